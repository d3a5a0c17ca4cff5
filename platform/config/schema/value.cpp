#include "config/schema/value.h"

#include "config/schema/blank.h"
#include "config/toml/path_variables.h"
#include "config/toml/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace lacuna {
namespace {

std::vector<std::string> alternatives(const std::string& units) {
  const std::size_t split = units.find(" or ");
  if (split == std::string::npos) return {units};
  return {units.substr(0, split), units.substr(split + 4)};
}

bool dimension_fits(const Quantity& quantity, const std::string& units) {
  const std::vector<std::string> wanted = alternatives(units);
  return std::any_of(wanted.begin(), wanted.end(),
                     [&](const std::string& unit) { return parse_unit(unit)->same_dimension(quantity.parsed); });
}

bool read_quantity(const Shape& shape, const TomlNode& node, Reading& reading, double& result) {
  if (is_blank(node.text)) {
    reading.problem(node, blank_complaint(node.text, shape.unit.empty() ? "1" : shape.unit));
    return false;
  }
  try {
    const Quantity quantity = parse_quantity(node.text);
    if (!shape.unit.empty() && !dimension_fits(quantity, shape.unit)) {
      reading.problem(node, shape.unit == "1"
                                ? toml_text(node.text) + " has a unit, but this is a plain number"
                                : toml_text(node.text) + " is not in " + shape.unit + " or a multiple of it");
      return false;
    }
    if (shape.unit.empty() || shape.unit.find(" or ") != std::string::npos) reading.written_unit(quantity.unit);
    result = quantity.value_in_si;
    return true;
  } catch (const Error& error) {
    reading.problem(node, error.what());
    return false;
  }
}

bool within(const Shape& shape, double value) {
  if (std::isnan(value) || (std::isinf(value) && !shape.may_be_infinite)) return false;
  return (shape.above ? value > shape.lower : value >= shape.lower) && value <= shape.upper;
}

bool read_number(const Shape& shape, const TomlNode& node, Reading& reading, double& result) {
  if (node.kind == TomlNode::Kind::text) {
    if (!read_quantity(shape, node, reading, result)) return false;
  } else if (node.is_number()) {
    result = node.kind == TomlNode::Kind::real ? node.real : static_cast<double>(node.integer);
  } else {
    report_mismatch(shape, node, reading);
    return false;
  }
  if (within(shape, result)) return true;
  reading.problem(node, fmt::format("must be {}, but is {}", described(shape), result));
  return false;
}

std::string shown(const TomlNode& node) {
  switch (node.kind) {
    case TomlNode::Kind::boolean: return node.boolean ? "true" : "false";
    case TomlNode::Kind::integer: return fmt::format("{}", node.integer);
    case TomlNode::Kind::real: return toml_number(node.real);
    case TomlNode::Kind::text: return toml_text(node.text);
    case TomlNode::Kind::date:
    case TomlNode::Kind::list:
    case TomlNode::Kind::table: break;
  }
  return std::string(described(node.kind));
}

}  // namespace

NumberValue::NumberValue(const std::string& unit) {
  shape.kind = Shape::Kind::number;
  shape.unit = unit;
  read = [inner = shape](const TomlNode& node, Reading& reading, double& result) {
    return read_number(inner, node, reading, result);
  };
  write = [](const double& shown) { return std::isnan(shown) ? std::string() : toml_number(shown); };
}

NumberValue NumberValue::bounded(double lower, double upper, bool above) const {
  NumberValue value = *this;
  value.shape.lower = lower;
  value.shape.upper = upper;
  value.shape.above = above;
  value.read = [inner = value.shape](const TomlNode& node, Reading& reading, double& result) {
    return read_number(inner, node, reading, result);
  };
  return value;
}

NumberValue NumberValue::or_infinite() const {
  NumberValue value = *this;
  value.shape.may_be_infinite = true;
  return value.bounded(shape.lower, shape.upper, shape.above);
}

NumberValue number(const std::string& unit) { return NumberValue(unit); }

Value<bool> boolean() {
  Value<bool> value;
  value.shape.kind = Shape::Kind::boolean;
  value.read = [shape = value.shape](const TomlNode& node, Reading& reading, bool& result) {
    result = node.boolean;
    if (node.kind == TomlNode::Kind::boolean) return true;
    report_mismatch(shape, node, reading);
    return false;
  };
  value.write = [](const bool& shown) { return std::string(shown ? "true" : "false"); };
  return value;
}

Value<std::int64_t> integer(std::int64_t lower, std::int64_t upper) {
  Value<std::int64_t> value;
  value.shape.kind = Shape::Kind::integer;
  value.shape.lower = static_cast<double>(lower);
  value.shape.upper =
      upper == std::numeric_limits<std::int64_t>::max() ? value.shape.upper : static_cast<double>(upper);
  value.read = [shape = value.shape, lower, upper](const TomlNode& node, Reading& reading, std::int64_t& result) {
    result = node.integer;
    if (node.kind != TomlNode::Kind::integer) {
      report_mismatch(shape, node, reading);
      return false;
    }
    if (result >= lower && result <= upper) return true;
    reading.problem(node, fmt::format("must be {}, but is {}", described(shape), result));
    return false;
  };
  value.write = [](const std::int64_t& shown) { return fmt::format("{}", shown); };
  return value;
}

Value<std::string> text(std::size_t fewest) {
  Value<std::string> value;
  value.shape.kind = Shape::Kind::text;
  value.shape.fewest = fewest;
  value.read = [shape = value.shape](const TomlNode& node, Reading& reading, std::string& result) {
    result = node.text;
    if (node.kind != TomlNode::Kind::text) {
      report_mismatch(shape, node, reading);
      return false;
    }
    if (result.size() >= shape.fewest) return true;
    reading.problem(node, "must not be empty");
    return false;
  };
  value.write = [](const std::string& shown) { return toml_text(shown); };
  return value;
}

Value<std::string> text_of(const std::vector<std::string>& choices) {
  Value<std::string> value = text();
  value.shape.choices = choices;
  value.read = [shape = value.shape](const TomlNode& node, Reading& reading, std::string& result) {
    result = node.text;
    const bool known = std::find(shape.choices.begin(), shape.choices.end(), result) != shape.choices.end();
    if (node.kind == TomlNode::Kind::text && known) return true;
    reading.problem(node,
                    "must be " + described(shape) + ", but is " + shown(node) + did_you_mean(result, shape.choices));
    return false;
  };
  return value;
}

bool is_element_name(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
  });
}

Value<std::string> element_name() {
  Value<std::string> value = text();
  value.shape.meaning = "a name of letters, digits, _ and -";
  value.read = [plain = text()](const TomlNode& node, Reading& reading, std::string& result) {
    if (!plain.read(node, reading, result)) return false;
    if (is_element_name(result)) return true;
    reading.problem(node, is_blank(result) ? blank_complaint(result, "")
                                           : toml_text(result) + " is not a valid name; use letters, digits, _ and -");
    return false;
  };
  return value;
}

namespace {

Value<std::filesystem::path> existing(decltype(&resolve_existing_file) resolve) {
  Value<std::filesystem::path> value;
  value.shape.kind = Shape::Kind::text;
  value.shape.meaning = "a file's path";
  value.read = [resolve, plain = text()](const TomlNode& node, Reading& reading, std::filesystem::path& result) {
    std::string written;
    if (!plain.read(node, reading, written)) return false;
    try {
      result = resolve(written, reading.directory());
      return true;
    } catch (const Error& error) {
      reading.problem(node, error.what());
      return false;
    }
  };
  value.write = [](const std::filesystem::path& shown) { return shown.empty() ? "" : toml_text(shown.string()); };
  return value;
}

}  // namespace

Value<std::filesystem::path> existing_file() { return existing(&resolve_existing_file); }
Value<std::filesystem::path> existing_recording() { return existing(&resolve_recording); }

Value<Eigen::Vector3d> vector3(const std::string& unit) {
  Value<std::vector<double>> list = list_of<double>(number(unit), 3);
  list.shape.most = 3;
  Value<Eigen::Vector3d> value;
  value.shape = list.shape;
  value.read = [list](const TomlNode& node, Reading& reading, Eigen::Vector3d& result) {
    std::vector<double> numbers;
    if (!fits_list(list.shape, node, reading) || !list.read(node, reading, numbers)) return false;
    result = {numbers[0], numbers[1], numbers[2]};
    return true;
  };
  value.write = [list](const Eigen::Vector3d& shown) { return list.write({shown.x(), shown.y(), shown.z()}); };
  return value;
}

Value<std::pair<double, double>> range_of(const NumberValue& number_value) {
  Value<std::vector<double>> list = list_of<double>(number_value, 2);
  list.shape.most = 2;
  Value<std::pair<double, double>> value;
  value.shape = list.shape;
  value.shape.meaning = "lower, upper";
  value.read = [list](const TomlNode& node, Reading& reading, std::pair<double, double>& result) {
    std::vector<double> numbers;
    if (!fits_list(list.shape, node, reading) || !list.read(node, reading, numbers)) return false;
    result = {numbers[0], numbers[1]};
    if (result.first < result.second) return true;
    reading.problem(node,
                    fmt::format("the lower bound {} is not below the upper bound {}", result.first, result.second));
    return false;
  };
  value.write = [list](const std::pair<double, double>& shown) { return list.write({shown.first, shown.second}); };
  return value;
}

bool may_be(const Shape& shape, const TomlNode& node) {
  switch (shape.kind) {
    case Shape::Kind::boolean: return node.kind == TomlNode::Kind::boolean;
    case Shape::Kind::integer: return node.kind == TomlNode::Kind::integer;
    case Shape::Kind::number: return node.is_number() || node.kind == TomlNode::Kind::text;
    case Shape::Kind::text: return node.kind == TomlNode::Kind::text;
    case Shape::Kind::list: return node.kind == TomlNode::Kind::list;
    case Shape::Kind::table:
    case Shape::Kind::named: return node.kind == TomlNode::Kind::table;
    case Shape::Kind::either: break;
  }
  return std::any_of(shape.parts.begin(), shape.parts.end(), [&](const Shape& part) { return may_be(part, node); });
}

void report_mismatch(const Shape& shape, const TomlNode& node, Reading& reading) {
  reading.problem(node, "must be " + described(shape) + ", but is " + shown(node));
}

bool is_unquoted_address(const Shape& shape, const TomlMember& member, Reading& reading) {
  const bool is_address = shape.name_hint == "ADDRESS" || shape.name_hint == "ELEMENT";
  if (!is_address || member.value.kind != TomlNode::Kind::table || member.name.find('.') != std::string::npos)
    return false;
  reading.problem(member.location, "write the address in quotes, as in \"body.arm.mass\" = 1.0");
  return true;
}

bool fits_list(const Shape& shape, const TomlNode& node, Reading& reading) {
  if (node.kind != TomlNode::Kind::list) {
    report_mismatch(shape, node, reading);
    return false;
  }
  const std::size_t count = node.items.size();
  if (count >= shape.fewest && count <= shape.most) return true;
  reading.problem(node, fmt::format("must be {}, but has {} item{}", described(shape), count, count == 1 ? "" : "s"));
  return false;
}

bool fits_table(const Shape& shape, const TomlNode& node, Reading& reading) {
  if (node.kind == TomlNode::Kind::table) return true;
  report_mismatch(shape, node, reading);
  return false;
}

}  // namespace lacuna

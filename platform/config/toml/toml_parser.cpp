#include "config/toml/toml_parser.h"

#include "config/toml/toml_scanner.h"
#include "config/toml/tomlplusplus.h"

#include <algorithm>
#include <tuple>

namespace lacuna {
namespace {

constexpr std::size_t kLargestText = std::size_t{4} << 20U;
constexpr std::size_t kLongestKey = 16;  // dotted parts; with the limit on nested values this bounds the depth

SourceLocation located(const std::string& file, const toml::source_position& position) {
  return {file, static_cast<int>(position.line), static_cast<int>(position.column)};
}

bool stands_before(const TomlMember& a, const TomlMember& b) {
  return std::tie(a.location.line, a.location.column) < std::tie(b.location.line, b.location.column);
}

TomlNode converted(const toml::node& source, const std::string& file);

void convert_table(const toml::table& source, const std::string& file, TomlNode& node) {
  node.kind = TomlNode::Kind::table;
  for (const auto& [key, value] : source) {
    TomlMember member{std::string(key.str()), located(file, key.source().begin), converted(value, file)};
    if (member.value.location.line == 0) member.value.location = member.location;
    node.members.push_back(std::move(member));
  }
  std::stable_sort(node.members.begin(), node.members.end(), stands_before);
}

void convert_scalar(const toml::node& source, TomlNode& node) {
  if (const auto* boolean = source.as_boolean()) {
    node.kind = TomlNode::Kind::boolean;
    node.boolean = boolean->get();
  } else if (const auto* integer = source.as_integer()) {
    node.kind = TomlNode::Kind::integer;
    node.integer = integer->get();
  } else if (const auto* real = source.as_floating_point()) {
    node.kind = TomlNode::Kind::real;
    node.real = real->get();
  } else if (const auto* text = source.as_string()) {
    node.kind = TomlNode::Kind::text;
    node.text = text->get();
  } else {
    node.kind = TomlNode::Kind::date;
  }
}

TomlNode converted(const toml::node& source, const std::string& file) {
  TomlNode node;
  node.location = located(file, source.source().begin);
  node.end = located(file, source.source().end);
  if (const auto* table = source.as_table()) {
    convert_table(*table, file, node);
  } else if (const auto* array = source.as_array()) {
    node.kind = TomlNode::Kind::list;
    for (const toml::node& item : *array) node.items.push_back(converted(item, file));
  } else {
    convert_scalar(source, node);
  }
  return node;
}

[[noreturn]] void refuse(const SourceLocation& location, const std::string& message) {
  ProblemList problems;
  problems.add(location, message);
  throw BadInput(problems.all());
}

int line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

bool breaks_assertion(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error&) {
    return false;
  } catch (const BrokenTomlAssertion&) {
    return true;
  }
  return false;
}

/// The parser does not say where an assertion broke. It stops at the first fault, so all prefixes
/// of the text that reach into the faulty line break it, and no shorter ones.
int line_that_breaks_assertion(const std::string& text) {
  std::size_t good = 0;
  std::size_t bad = text.size();
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (breaks_assertion(std::string_view(text).substr(0, middle)) ? bad : good) = middle;
  }
  return line_of(text, good);
}

}  // namespace

TomlNode parse_toml(const std::string& text, const std::string& file) {
  if (text.size() > kLargestText) refuse({file, 0, 0}, "is longer than 4 MiB; put measured data into separate files");
  if (const auto at = find_long_key(text, kLongestKey))
    refuse({file, line_of(text, *at), 0}, "a dotted key has more than 16 parts");
  try {
    return converted(toml::parse(text, file), file);
  } catch (const toml::parse_error& error) {
    refuse(located(file, error.source().begin), "not TOML: " + std::string(error.description()));
  } catch (const BrokenTomlAssertion&) {
    refuse({file, line_that_breaks_assertion(text), 0}, "not TOML: unexpected character");
  }
}

}  // namespace lacuna

#include "definition_lines.h"

#include "bad_bag.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace lacuna::rosbag2 {
namespace {

constexpr std::size_t kLargestArray = std::size_t{1} << 24;
constexpr std::size_t kShortestRule = 10;  ///< number of equals signs between definitions

constexpr std::array<std::pair<std::string_view, Primitive>, 14> kPrimitives = {{{"bool", Primitive::boolean},
                                                                                 {"byte", Primitive::uint8},
                                                                                 {"char", Primitive::uint8},
                                                                                 {"int8", Primitive::int8},
                                                                                 {"uint8", Primitive::uint8},
                                                                                 {"int16", Primitive::int16},
                                                                                 {"uint16", Primitive::uint16},
                                                                                 {"int32", Primitive::int32},
                                                                                 {"uint32", Primitive::uint32},
                                                                                 {"int64", Primitive::int64},
                                                                                 {"uint64", Primitive::uint64},
                                                                                 {"float32", Primitive::float32},
                                                                                 {"float64", Primitive::float64},
                                                                                 {"string", Primitive::text}}};

std::string_view without_space(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t start = text.find_first_not_of(kSpace);
  if (start == text.npos) return {};
  return text.substr(start, text.find_last_not_of(kSpace) - start + 1);
}

/// Removes the first line from the text.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  return without_space(line);
}

bool is_rule(std::string_view line) { return line.size() >= kShortestRule && line.find_first_not_of('=') == line.npos; }

[[noreturn]] void throw_unread(std::string_view line) {
  throw BadBag("the definition of a type has the line `" + std::string(line.substr(0, 60)) + "`, which cannot be read");
}

/// "[]", "[7]" or "[<=7]".
void take_times(std::string_view brackets, std::string_view line, MessageField& field) {
  const std::string_view inside = brackets.substr(1, brackets.size() - 2);
  field.times = Times::sequence;
  if (inside.empty() || inside.starts_with("<=")) return;
  field.times = Times::fixed;
  const auto [stopped, error] = std::from_chars(inside.data(), inside.data() + inside.size(), field.count);
  if (error != std::errc() || stopped != inside.data() + inside.size() || field.count > kLargestArray)
    throw_unread(line);
}

DefinitionLine field_of(std::string_view type, std::string_view name, std::string_view line) {
  DefinitionLine found;
  found.field.name = name;
  if (type.ends_with(']')) {
    const std::size_t start = type.rfind('[');
    if (start == type.npos) throw_unread(line);
    take_times(type.substr(start), line, found.field);
    type = type.substr(0, start);
  }
  type = type.substr(0, type.find('<'));  // the length limit of a text
  const auto known = std::find_if(kPrimitives.begin(), kPrimitives.end(),
                                  [&](const auto& primitive) { return primitive.first == type; });
  if (known != kPrimitives.end()) {
    found.field.primitive = known->second;
  } else if (type == "wstring") {
    throw BadBag("the type of a message has wide texts (wstring), which cannot be read");
  }
  found.type = type;
  return found;
}

}  // namespace

std::vector<DefinitionLine> lines_of_definition(std::string_view text) {
  std::vector<DefinitionLine> fields;
  while (!text.empty()) {
    const std::string_view whole = take_line(text);
    const std::string_view line = without_space(whole.substr(0, whole.find('#')));
    if (line.empty()) continue;
    const std::size_t type_end = line.find_first_of(" \t");
    if (type_end == line.npos) throw_unread(line);
    const std::string_view rest = without_space(line.substr(type_end));
    const std::size_t name_end = std::min(rest.find_first_of(" \t="), rest.size());
    if (name_end == 0) throw_unread(line);
    if (without_space(rest.substr(name_end)).starts_with('=')) continue;  // a constant
    fields.push_back(field_of(line.substr(0, type_end), rest.substr(0, name_end), line));
  }
  return fields;
}

std::map<std::string, std::string_view> split_definitions(const std::string& root, std::string_view text) {
  std::map<std::string, std::string_view> definitions;
  std::string name = root;
  const char* start = text.data();
  while (!text.empty()) {
    const char* const line_start = text.data();
    const std::string_view line = take_line(text);
    if (!is_rule(line) && !line.starts_with("MSG:")) continue;
    if (!name.empty()) definitions.emplace(name, std::string_view(start, static_cast<std::size_t>(line_start - start)));
    name.clear();
    if (is_rule(line)) continue;
    name = plain_type_name(without_space(line.substr(4)));
    start = text.data();
  }
  if (!name.empty()) definitions.emplace(name, std::string_view(start, static_cast<std::size_t>(text.data() - start)));
  return definitions;
}

}  // namespace lacuna::rosbag2

#include "config/edits/free_editor.h"

#include "config/edits/section_edit.h"
#include "config/edits/text_edit.h"
#include "config/toml/toml_parser.h"
#include "config/toml/toml_scanner.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr const char* kFree = "free";

const TomlNode* find_free(const TomlNode& tree) {
  const TomlNode* model = tree.find("model");
  return model ? model->find(kFree) : nullptr;
}

std::size_t place_of(std::string_view text, const SourceLocation& location) {
  return offset_of(text, location.line, location.column);
}

std::size_t end_of(std::string_view text, const TomlNode& value) { return place_of(text, value.end); }

std::string line_of(const FreeRange& value) {
  std::string range = fmt::format("[{}, {}]", toml_number(value.lower), toml_number(value.upper));
  if (value.start) range = fmt::format("{{ range = {}, start = {} }}", range, toml_number(*value.start));
  return fmt::format("{} = {}", toml_text(value.pattern), range);
}

/// The tree without an address; an empty table counts as none.
TomlNode without_value(TomlNode tree, const std::string& address) {
  TomlNode* model = tree.find("model");
  TomlNode* free = model ? model->find(kFree) : nullptr;
  if (!free) return tree;
  std::erase_if(free->members, [&](const TomlMember& member) { return member.name == address; });
  if (free->members.empty())
    std::erase_if(model->members, [](const TomlMember& member) { return member.name == kFree; });
  return tree;
}

[[noreturn]] void refuse(const std::string& what) {
  throw Error("the layout of the table model.free cannot be edited; " + what + " by hand");
}

std::string with_first(const std::string& text, const TomlNode& model, const std::string& line) {
  if (text[place_of(text, model.location)] == '{' && !model.members.empty()) {
    const std::size_t end = end_of(text, model.members.back().value);
    return edited(text, {{{end, end}, ", free = { " + line + " }"}});
  }
  const std::string new_line = line_end_of(text);
  const bool ends_its_line = text.empty() || text.back() == '\n';
  return text + (ends_its_line ? "" : new_line) + new_line + "[model.free]" + new_line + line + new_line;
}

std::string with_value(const std::string& text, const TomlNode& tree, const std::string& line) {
  const TomlNode* free = find_free(tree);
  if (!free) return with_first(text, *tree.find("model"), line);
  const std::size_t begin = place_of(text, free->location);
  if (text[begin] == '{' && free->members.empty()) return edited(text, {{{begin + 1, begin + 1}, " " + line + " "}});
  if (text[begin] == '{') {
    const std::size_t end = end_of(text, free->members.back().value);
    return edited(text, {{{end, end}, ", " + line}});
  }
  const std::size_t end = end_of_section(text, *free, tree);
  const std::string margin(indentation(text, end));
  return edited(text, {{{end, end}, line_end_of(text) + margin + line}});
}

/// Of an inline table, with the comma beside it.
Span span_in_braces(std::string_view text, const TomlNode& free, std::size_t index) {
  const std::size_t end = end_of(text, free.members[index].value);
  if (index > 0) return {end_of(text, free.members[index - 1].value), end};
  if (free.members.size() > 1)
    return {place_of(text, free.members[0].location), place_of(text, free.members[1].location)};
  return {place_of(text, free.location) + 1, end_of(text, free) - 1};
}

/// The lines of a value; where it is the only one those of the section, with the empty lines before it.
Span span_of_lines(std::string_view text, const TomlNode& free, std::size_t index) {
  const TomlMember& member = free.members[index];
  const std::size_t end = after_line_end(text, line_end(text, end_of(text, member.value)));
  if (free.members.size() > 1) return {line_begin(text, place_of(text, member.location)), end};
  std::size_t begin = line_begin(text, place_of(text, free.location));
  while (begin >= 2 && text[begin - 1] == '\n' && (text[begin - 2] == '\n' || text.substr(begin - 3, 2) == "\n\r"))
    begin = line_begin(text, begin - 1);
  return {begin, end};
}

}  // namespace

std::string insert_free_value(const std::string& text, const FreeRange& value) {
  const TomlNode tree = parse_toml(text, "");
  if (const TomlNode* model = tree.find("model"); !model || model->kind != TomlNode::Kind::table)
    throw Error("there is no section [model] for the free value");
  const TomlNode* free = find_free(tree);
  if (free && free->kind != TomlNode::Kind::table) throw Error("model.free is not a table");
  if (free && free->find(value.pattern)) throw Error("model.free has " + value.pattern + " already");
  const std::string by_hand = "put " + line_of(value) + " into it";
  try {
    std::string result = with_value(text, tree, line_of(value));
    const TomlNode after = parse_toml(result, "");
    const TomlNode* list = find_free(after);
    if (list && list->find(value.pattern) && same_values(without_value(after, value.pattern), without_value(tree, "")))
      return result;
  } catch (const Error&) {
    refuse(by_hand);
  }
  refuse(by_hand);
}

std::string remove_free_value(const std::string& text, const std::string& address) {
  const TomlNode tree = parse_toml(text, "");
  const TomlNode* free = find_free(tree);
  if (!free || !free->find(address)) throw Error("model.free has no " + address);
  const auto found = std::find_if(free->members.begin(), free->members.end(),
                                  [&](const TomlMember& member) { return member.name == address; });
  const auto index = static_cast<std::size_t>(found - free->members.begin());
  const std::string by_hand = "take " + toml_text(address) + " out of it";
  try {
    const bool has_braces = text[place_of(text, free->location)] == '{';
    const Span span = has_braces ? span_in_braces(text, *free, index) : span_of_lines(text, *free, index);
    std::string result = edited(text, {{span, ""}});
    if (same_values(without_value(parse_toml(result, ""), ""), without_value(tree, address))) return result;
  } catch (const Error&) {
    refuse(by_hand);
  }
  refuse(by_hand);
}

}  // namespace lacuna

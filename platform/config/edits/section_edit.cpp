#include "config/edits/section_edit.h"

#include "config/edits/text_edit.h"
#include "config/toml/toml_scanner.h"

#include <lacuna/error.h>

#include <algorithm>

namespace lacuna {
namespace {

std::size_t begin_of(std::string_view text, const TomlNode& node) {
  return offset_of(text, node.location.line, node.location.column);
}

bool is_section(std::string_view text, const TomlNode& node) {
  const std::size_t begin = begin_of(text, node);
  return node.kind == TomlNode::Kind::table && begin < text.size() && text[begin] == '[';
}

/// One past the last character of anything in `node` that begins before `limit`.
std::size_t last_character(std::string_view text, const TomlNode& node, std::size_t limit) {
  const std::size_t begin = begin_of(text, node);
  if (begin >= limit) return 0;
  std::size_t end = std::min(offset_of(text, node.end.line, node.end.column), limit);
  if (is_section(text, node)) end = line_end(text, begin);  // its header; a section's own end is not reliable
  for (const TomlNode& item : node.items) end = std::max(end, last_character(text, item, limit));
  for (const TomlMember& member : node.members) end = std::max(end, last_character(text, member.value, limit));
  return end;
}

/// Where the next section after `begin` starts, or the end of the text.
std::size_t next_section(std::string_view text, const TomlNode& node, std::size_t begin) {
  std::size_t next = text.size();
  if (is_section(text, node) && begin_of(text, node) > begin) next = begin_of(text, node);
  for (const TomlNode& item : node.items) next = std::min(next, next_section(text, item, begin));
  for (const TomlMember& member : node.members) next = std::min(next, next_section(text, member.value, begin));
  return next;
}

std::string list_of_one(const std::string& key, const std::string& item, const std::string& new_line,
                        std::string_view margin) {
  const std::string indent(margin);
  return new_line + indent + key + " = [" + new_line + indent + "  " + item + "," + new_line + indent + "]";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> keys_of(const EffectEntry& effect) {
  const auto list = [](const std::vector<std::string>& texts) {
    std::string words;
    for (const std::string& text : texts) words += (words.empty() ? "" : ", ") + toml_text(text);
    return "[" + words + "]";
  };
  std::vector<std::pair<std::string, std::string>> keys = {{"id", toml_text(effect.id)},
                                                           {"effect", toml_text(effect.effect)}};
  if (effect.where.size() == 1) keys.emplace_back("where", toml_text(effect.where.front()));
  if (effect.where.size() > 1) keys.emplace_back("where", list(effect.where));
  std::string start;
  for (const auto& [name, value] : effect.start)
    start += (start.empty() ? "" : ", ") + toml_key(name) + " = " + toml_number(value);
  if (!start.empty()) keys.emplace_back("start", "{ " + start + " }");
  if (!effect.fixed.empty()) keys.emplace_back("fixed", list(effect.fixed));
  std::string range;
  for (const auto& [name, bounds] : effect.range)
    range += (range.empty() ? "" : ", ") + toml_key(name) + " = [" + toml_number(bounds.first) + ", " +
             toml_number(bounds.second) + "]";
  if (!range.empty()) keys.emplace_back("range", "{ " + range + " }");
  if (effect.optional) keys.emplace_back("optional", "true");
  return keys;
}

std::string with_section(const std::string& text, const TomlNode& last, const EffectEntry& effect) {
  const std::string new_line = line_end_of(text);
  const std::string margin(indentation(text, begin_of(text, last)));
  std::string section = new_line + new_line + margin + "[[model.effects]]";
  for (const auto& [key, value] : keys_of(effect))
    section.append(new_line).append(margin).append(key).append(" = ").append(value);
  const std::size_t end = line_end(text, last_character(text, last, text.size()));
  return edited(text, {{{end, end}, section}});
}

std::string without_section(const std::string& text, const TomlNode& effect) {
  Span span{line_begin(text, begin_of(text, effect)), line_end(text, last_character(text, effect, text.size()))};
  std::size_t begin = span.begin;
  while (begin > 0 && (text[begin - 1] == '\n' || text[begin - 1] == '\r')) --begin;
  if (begin == 0) span.end = after_line_end(text, span.end);
  span.begin = begin;
  return edited(text, {{span, ""}});
}

std::size_t end_of_section(const std::string& text, const TomlNode& section, const TomlNode& tree) {
  const std::size_t begin = begin_of(text, section);
  const std::size_t limit = is_section(text, section) ? next_section(text, tree, begin) : text.size();
  std::size_t end = line_end(text, begin);
  for (const TomlMember& member : section.members) end = std::max(end, last_character(text, member.value, limit));
  return line_end(text, end);
}

std::string with_effects_key(const std::string& text, const TomlNode& model, const TomlNode& tree,
                             const std::string& item) {
  const std::string new_line = line_end_of(text);
  const std::size_t begin = begin_of(text, model);
  const bool has_braces = text[begin] == '{';
  const std::size_t limit = is_section(text, model) ? next_section(text, tree, begin) : text.size();
  std::size_t end = is_section(text, model) ? line_end(text, begin) : begin;
  for (const TomlMember& member : model.members) end = std::max(end, last_character(text, member.value, limit));
  if (has_braces && model.members.empty()) throw Error("model is an empty table");
  if (has_braces) return edited(text, {{{end, end}, ", effects = [" + item + "]"}});
  const std::string key = is_section(text, model) ? "effects" : "model.effects";
  const std::size_t line = line_end(text, end);
  return edited(text, {{{line, line}, list_of_one(key, item, new_line, indentation(text, end))}});
}

}  // namespace lacuna

#include "config/toml/toml_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lacuna {
namespace {

bool is_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

bool same_members(const std::vector<TomlMember>& a, const std::vector<TomlMember>& b) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](const TomlMember& member) {
           const auto other = std::find_if(b.begin(), b.end(),
                                           [&](const TomlMember& candidate) { return candidate.name == member.name; });
           return other != b.end() && same_values(member.value, other->value);
         });
}

}  // namespace

const TomlNode* TomlNode::find(std::string_view name) const {
  for (const TomlMember& member : members)
    if (member.name == name) return &member.value;
  return nullptr;
}

TomlNode* TomlNode::find(std::string_view name) {
  return const_cast<TomlNode*>(static_cast<const TomlNode*>(this)->find(name));
}

std::string_view described(TomlNode::Kind kind) {
  switch (kind) {
    case TomlNode::Kind::boolean: return "true or false";
    case TomlNode::Kind::integer: return "a whole number";
    case TomlNode::Kind::real: return "a number";
    case TomlNode::Kind::text: return "a text";
    case TomlNode::Kind::date: return "a date or time";
    case TomlNode::Kind::list: return "a list";
    case TomlNode::Kind::table: return "a table";
  }
  return "a value";
}

bool same_values(const TomlNode& a, const TomlNode& b) {
  if (a.kind != b.kind) return false;
  switch (a.kind) {
    case TomlNode::Kind::boolean: return a.boolean == b.boolean;
    case TomlNode::Kind::integer: return a.integer == b.integer;
    case TomlNode::Kind::real: return a.real == b.real || (std::isnan(a.real) && std::isnan(b.real));
    case TomlNode::Kind::text:
    case TomlNode::Kind::date: return a.text == b.text;
    case TomlNode::Kind::list:
      return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), same_values);
    case TomlNode::Kind::table: return same_members(a.members, b.members);
  }
  return false;
}

std::string toml_key(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), is_bare);
  return bare ? std::string(key) : toml_text(key);
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += {'\\', c};
    else if (c == '\t' || c == '\n' || c == '\r')
      quoted += c == '\t' ? "\\t" : c == '\n' ? "\\n" : "\\r";
    else if (byte < 0x20 || byte == 0x7f)
      quoted += fmt::format("\\u{:04X}", byte);
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string toml_number(double value) {
  std::string text = fmt::format("{}", value);
  const bool whole = text.find_first_of(".en") == std::string::npos;  // also of "inf" and "nan"
  if (whole) text += ".0";
  return text;
}

std::string toml_comment(const std::string& text) {
  std::string all, line;
  std::istringstream lines(text);
  while (std::getline(lines, line)) all += line.empty() ? "#\n" : "# " + line + "\n";
  return all;
}

}  // namespace lacuna

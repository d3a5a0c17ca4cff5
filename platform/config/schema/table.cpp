#include "config/schema/table.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace lacuna {
namespace {

std::vector<std::string> names_of(const Shape& shape) {
  std::vector<std::string> names;
  for (const KeyShape& key : shape.keys) names.push_back(key.name);
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// A section's description has sentences; the first one is wanted as a phrase.
std::string as_phrase(const std::string& description) {
  std::string phrase = description.substr(0, description.find(". "));
  const bool is_sentence = phrase.size() < description.size() || phrase.ends_with('.');
  if (phrase.ends_with('.')) phrase.pop_back();
  if (is_sentence) phrase.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(phrase.front())));
  return phrase;
}

}  // namespace

TableShape::TableShape() { shape_.kind = Shape::Kind::table; }

void TableShape::declare(std::string_view name, const Shape& value, bool required, std::string default_text,
                         std::string_view description) {
  shape_.keys.emplace_back(name, value, required, std::move(default_text), description);
}

const TomlNode* TableShape::find(const TomlNode& node, std::size_t key) const {
  return node.find(shape_.keys[key].name);
}

void check_keys(const Shape& shape, const TomlNode& node, Reading& reading) {
  const std::vector<std::string> names = names_of(shape);
  for (const TomlMember& member : node.members) {
    if (std::find(names.begin(), names.end(), member.name) != names.end()) continue;
    reading.problem(member.location, "unknown key " + toml_text(member.name) + did_you_mean(member.name, names) +
                                         "; known here: " + listed(names));
  }
  for (const KeyShape& key : shape.keys) {
    if (!key.required || node.find(key.name)) continue;
    reading.problem_at(key.name, node.location,
                       "is missing: " + as_phrase(key.description) + " (" + described(key.shape) + ")");
  }
}

}  // namespace lacuna

#include "config/table.h"

#include <algorithm>

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

}  // namespace

bool check_keys(const Shape& shape, const TomlNode& node, Reading& reading) {
  bool good = true;
  const std::vector<std::string> names = names_of(shape);
  for (const TomlMember& member : node.members) {
    if (std::find(names.begin(), names.end(), member.name) != names.end()) continue;
    good = false;
    reading.problem(member.location, "unknown key " + toml_text(member.name) + did_you_mean(member.name, names) +
                                         "; known here: " + listed(names));
  }
  for (const KeyShape& key : shape.keys) {
    if (!key.required || node.find(key.name)) continue;
    good = false;
    reading.problem(node.location, key.name + " is missing: " + described(key.shape) + ", " + key.description);
  }
  return good;
}

}  // namespace lacuna

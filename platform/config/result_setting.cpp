#include "config/result_setting.h"

#include "config/schema/experiment_schema.h"
#include "config/overrides.h"
#include "config/toml/toml_parser.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr const char* kVersion = "version";

/// Empty where it is left out.
std::string text_of_target(const TomlNode& setting, const char* key) {
  const TomlNode* target = setting.find("target");
  const TomlNode* value = target ? target->find(key) : nullptr;
  return value ? value->text : std::string();
}

bool says_how_it_is_run(const TomlMember& member) {
  static const Shape keys = process_keys().value().shape;
  return member.name != kVersion &&
         std::any_of(keys.keys.begin(), keys.keys.end(), [&](const KeyShape& key) { return key.name == member.name; });
}

}  // namespace

TomlNode result_setting(const std::string& text, const std::vector<std::string>& overrides) {
  TomlNode setting = parse_toml(text, "");
  ProblemList problems;  // a file that was read once has none
  apply_overrides(setting, overrides, problems);
  std::erase_if(setting.members, [](const TomlMember& member) { return member.name == "sweep"; });
  if (text_of_target(setting, "kind") == "process") std::erase_if(setting.find("target")->members, says_how_it_is_run);
  return setting;
}

bool same_target(const TomlNode& a, const TomlNode& b) {
  return text_of_target(a, "kind") == text_of_target(b, "kind") &&
         (text_of_target(a, "kind") != "process" || text_of_target(a, kVersion) == text_of_target(b, kVersion));
}

}  // namespace lacuna

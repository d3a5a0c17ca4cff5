#include "config/edits/effects_editor.h"

#include "config/edits/bracket_list.h"
#include "config/schema/experiment_schema.h"
#include "config/edits/section_edit.h"
#include "config/toml/toml_parser.h"
#include "config/toml/toml_scanner.h"

#include <algorithm>

namespace lacuna {
namespace {

const TomlNode* find_effects(const TomlNode& tree) {
  const TomlNode* model = tree.find("model");
  return model ? model->find("effects") : nullptr;
}

std::size_t place_of(std::string_view text, const TomlNode& node) {
  return offset_of(text, node.location.line, node.location.column);
}

bool is_in_sections(std::string_view text, const TomlNode& list) {
  return !list.items.empty() && text[place_of(text, list.items.front())] == '[';
}

std::string id_of(const TomlNode& effect) {
  const TomlNode* id = effect.find("id");
  const TomlNode* name = effect.find("effect");
  return id ? id->text : name ? name->text : "";
}

std::vector<std::string> ids_of(const TomlNode& effects) {
  std::vector<std::string> ids;
  for (const TomlNode& effect : effects.items) ids.push_back(id_of(effect));
  return ids;
}

bool same_effect(const TomlNode& node, const EffectEntry& effect) {
  ProblemList problems;
  Reading reading(problems, {});
  EffectEntry read;
  static const Value<EffectEntry> kKeys = model_effect_keys().value();
  return kKeys.read(node, reading, read) && read.id == effect.id && read.effect == effect.effect &&
         read.where == effect.where && read.start == effect.start && read.fixed == effect.fixed &&
         read.range == effect.range && read.optional == effect.optional;
}

/// The tree with an effect taken out; an empty list counts as none.
TomlNode without_effect(TomlNode tree, std::size_t index) {
  TomlNode* model = tree.find("model");
  TomlNode* effects = model ? model->find("effects") : nullptr;
  if (!effects) return tree;
  if (index < effects->items.size()) effects->items.erase(effects->items.begin() + static_cast<std::ptrdiff_t>(index));
  if (effects->items.empty())
    std::erase_if(model->members, [](const TomlMember& member) { return member.name == "effects"; });
  return tree;
}

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

[[noreturn]] void give_up(const std::string& what) {
  throw Error("the layout of the list model.effects cannot be edited; " + what + " by hand");
}

std::string with_effect(const std::string& text, const TomlNode& tree, const EffectEntry& effect) {
  const TomlNode* model = tree.find("model");
  const TomlNode* effects = find_effects(tree);
  if (!effects) return with_effects_key(text, *model, tree, effect_as_toml(effect));
  if (is_in_sections(text, *effects)) return with_section(text, effects->items.back(), effect);
  return BracketList(text, place_of(text, *effects)).with(effect_as_toml(effect));
}

}  // namespace

std::string effect_as_toml(const EffectEntry& effect) {
  std::string text;
  for (const auto& [key, value] : keys_of(effect)) {
    text += text.empty() ? "{ " : ", ";
    text += key;
    text += " = ";
    text += value;
  }
  return text + " }";
}

std::string insert_effect(const std::string& text, const EffectEntry& effect) {
  const TomlNode tree = parse_toml(text, "");
  if (const TomlNode* model = tree.find("model"); !model || model->kind != TomlNode::Kind::table)
    throw Error("there is no section [model] for the effect");
  const TomlNode* effects = find_effects(tree);
  if (effects && effects->kind != TomlNode::Kind::list) throw Error("model.effects is not a list");
  const std::vector<std::string> ids = effects ? ids_of(*effects) : std::vector<std::string>();
  if (std::find(ids.begin(), ids.end(), effect.id) != ids.end())
    throw Error("the model has an effect with the id " + toml_text(effect.id) + " already; choose another id");
  const std::string by_hand = "put " + effect_as_toml(effect) + " into it";
  try {
    std::string result = with_effect(text, tree, effect);
    const TomlNode after = parse_toml(result, "");
    const TomlNode* list = find_effects(after);
    const bool good = list && list->items.size() == ids.size() + 1 && same_effect(list->items.back(), effect) &&
                      same_values(without_effect(after, ids.size()), without_effect(tree, kNone));
    if (good) return result;
  } catch (const Error&) {
    give_up(by_hand);
  }
  give_up(by_hand);
}

std::string remove_effect(const std::string& text, const std::string& id) {
  const TomlNode tree = parse_toml(text, "");
  const TomlNode* effects = find_effects(tree);
  const std::vector<std::string> ids = effects ? ids_of(*effects) : std::vector<std::string>();
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) throw Error("the model has no effect with the id " + toml_text(id) + did_you_mean(id, ids));
  const auto index = static_cast<std::size_t>(found - ids.begin());
  const std::string by_hand = "take " + toml_text(id) + " out of it";
  try {
    std::string result = is_in_sections(text, *effects) ? without_section(text, effects->items[index])
                                                        : BracketList(text, place_of(text, *effects)).without(index);
    const TomlNode expected = without_effect(tree, index);
    if (same_values(without_effect(parse_toml(result, ""), kNone), expected)) return result;
  } catch (const Error&) {
    give_up(by_hand);
  }
  give_up(by_hand);
}

}  // namespace lacuna

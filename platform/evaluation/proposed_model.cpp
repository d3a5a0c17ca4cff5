#include "evaluation/proposed_model.h"

#include <algorithm>
#include <string>

namespace lacuna {

std::vector<ModelEffect> model_effects(const ModelDefinition& definition) {
  std::vector<ModelEffect> effects;
  for (const EffectEntry& entry : definition.effects) {
    ModelEffect effect{entry.id, entry.optional, {}};
    const std::string prefix = "effect." + entry.id + ".";
    for (std::size_t i = 0; i < definition.free.size(); ++i)
      if (definition.free[i].address.starts_with(prefix)) effect.values.push_back(i);
    effects.push_back(std::move(effect));
  }
  return effects;
}

std::vector<std::size_t> kept_values(const ModelProposal& proposal, const ModelDefinition& definition) {
  std::vector<bool> kept(definition.free.size(), true);
  if (!proposal.without.empty()) {
    const std::vector<ModelEffect> effects = model_effects(definition);
    for (const std::size_t effect : proposal.without)
      for (const std::size_t value : effects.at(effect).values) kept[value] = false;
  }
  std::vector<std::size_t> values;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) values.push_back(i);
  return values;
}

std::vector<double> structure_values(const ModelProposal& proposal, const ModelDefinition& definition) {
  std::vector<double> values;
  for (const std::size_t value : kept_values(proposal, definition)) values.push_back(proposal.values[value]);
  return values;
}

ModelStructure structure_of(const ModelProposal& proposal, const ModelDefinition& definition) {
  const ModelStructure& whole = definition.structure;
  ModelStructure structure{proposal.robot ? *proposal.robot : whole.robot, {}, {}};
  for (std::size_t i = 0; i < whole.effects.size(); ++i)
    if (!std::binary_search(proposal.without.begin(), proposal.without.end(), i))
      structure.effects.push_back(whole.effects[i]);
  for (const std::size_t value : kept_values(proposal, definition))
    structure.parameters.push_back(whole.parameters[value]);
  return structure;
}

}  // namespace lacuna

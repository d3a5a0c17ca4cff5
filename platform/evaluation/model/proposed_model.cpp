#include "evaluation/model/proposed_model.h"

#include "evaluation/robots/robot_key.h"
#include "foundation/address.h"

#include <algorithm>
#include <string>

namespace lacuna {
namespace {

/// Names of the effects that a proposal leaves out.
std::string misfit_of_effects(const std::vector<std::size_t>& without, const std::vector<ModelEffect>& effects) {
  for (std::size_t i = 0; i < without.size(); ++i) {
    if (without[i] >= effects.size())
      return "it left out effect " + std::to_string(without[i]) + " of a model that has " +
             std::to_string(effects.size());
    if (!effects[without[i]].optional)
      return "it left out the effect \"" + effects[without[i]].id + "\", which is not optional";
    if (i > 0 && without[i] <= without[i - 1]) return "the effects that it left out are not in ascending order";
  }
  return {};
}

}  // namespace

std::vector<ModelEffect> model_effects(const ModelDefinition& definition) {
  std::vector<ModelEffect> effects;
  for (const EffectEntry& entry : definition.effects) {
    ModelEffect effect{entry.id, entry.optional, {}};
    for (std::size_t i = 0; i < definition.free.size(); ++i)
      if (is_of_effect(definition.free[i].address, entry.id)) effect.values.push_back(i);
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
  ModelStructure structure{proposal.robot ? *proposal.robot : whole.robot, {}, {}, whole.setups};
  for (std::size_t i = 0; i < whole.effects.size(); ++i)
    if (!std::binary_search(proposal.without.begin(), proposal.without.end(), i))
      structure.effects.push_back(whole.effects[i]);
  for (const std::size_t value : kept_values(proposal, definition))
    structure.parameters.push_back(whole.parameters[value]);
  for (const std::size_t effect : proposal.without)
    for (Setup& setup : structure.setups)
      std::erase_if(setup.values, [&](const Setup::Value& value) {
        return is_of_effect(value.address, definition.effects[effect].id);
      });
  return structure;
}

std::string misfit(const ModelProposal& proposal, const ModelSpace& space) {
  if (proposal.values.size() != space.free.size())
    return "it decoded " + std::to_string(proposal.values.size()) + " values instead of " +
           std::to_string(space.free.size());
  if (proposal.robot)
    if (const std::string problem = misfit(*proposal.robot, space.robot); !problem.empty())
      return "its robot " + problem;
  return misfit_of_effects(proposal.without, space.effects);
}

}  // namespace lacuna

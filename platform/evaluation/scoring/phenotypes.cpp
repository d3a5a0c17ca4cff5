#include "evaluation/scoring/phenotypes.h"

#include "evaluation/model/proposed_model.h"
#include "evaluation/robots/robot_key.h"
#include "foundation/address.h"

#include <cmath>

namespace lacuna {

bool counts_in_steps(const FreeValue& value, const EngineSettings& engine) {
  return engine.delay_rounding == DelayRounding::step &&
         (matches("sensor.*.delay", value.address) || matches("actuator.*.delay", value.address));
}

Phenotypes::Phenotypes(const ModelDefinition& definition)
    : effects_(model_effects(definition)), step_(definition.engine.step) {
  for (const FreeValue& value : definition.free) whole_steps_.push_back(counts_in_steps(value, definition.engine));
}

std::string Phenotypes::of(const ModelProposal& model) const {
  std::vector<double> key;
  key.reserve(model.values.size() + 1 + model.without.size());
  key = model.values;
  for (std::size_t i = 0; i < key.size(); ++i)
    if (whole_steps_[i]) key[i] = std::round(key[i] / step_);
  key.push_back(static_cast<double>(model.without.size()));
  for (const std::size_t effect : model.without) {
    for (const std::size_t value : effects_[effect].values) key[value] = 0.0;
    key.push_back(static_cast<double>(effect));
  }
  std::string phenotype(reinterpret_cast<const char*>(key.data()), key.size() * sizeof(double));
  if (model.robot) append_key(*model.robot, phenotype);
  return phenotype;
}

}  // namespace lacuna

#pragma once

#include "candidates/hypothesis.h"

#include <memory>
#include <vector>

namespace lacuna {

/// A candidate model: the experiment's model with some effects added.
struct AugmentedModel {
  Experiment experiment;  ///< with the effects
  std::vector<EffectEntry> added;
  std::vector<EffectEntry> placed;  ///< `placed_entries` of them
  ModelDefinition definition;
  std::shared_ptr<const CompiledModel> model;
  std::vector<double> values;  ///< of `definition.free`, SI
};

/// The experiment's own model with these values.
AugmentedModel plain(const Experiment& experiment, const PluginCatalog& catalog, std::vector<double> values);
/// `plain` with these effects, in their order; `values` of the free values that it has then.
AugmentedModel with_effects(const AugmentedModel& plain, const std::vector<EffectEntry>& added,
                            std::vector<double> values, const PluginCatalog& catalog);
/// `augmented` without the `which`-th of the effects that it has more than `plain`; the other values stay.
AugmentedModel without(const AugmentedModel& augmented, std::size_t which, const AugmentedModel& plain,
                       const PluginCatalog& catalog);

}  // namespace lacuna

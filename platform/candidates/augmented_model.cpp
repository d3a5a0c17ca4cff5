#include "candidates/augmented_model.h"

#include <map>

namespace lacuna {

AugmentedModel plain(const Experiment& experiment, const PluginCatalog& catalog, std::vector<double> values) {
  AugmentedModel augmented;
  augmented.experiment = experiment;
  augmented.definition = define_model(augmented.experiment, catalog);
  augmented.model = compile(augmented.definition.structure, augmented.definition.engine);
  augmented.values = std::move(values);
  return augmented;
}

AugmentedModel with_effects(const AugmentedModel& plain, const std::vector<EffectEntry>& added,
                            std::vector<double> values, const PluginCatalog& catalog) {
  AugmentedModel longer;
  longer.experiment = plain.experiment;
  longer.added = added;
  longer.placed = placed_entries(added, plain.definition.structure.robot);
  for (const EffectEntry& entry : longer.placed) longer.experiment = with_effect(std::move(longer.experiment), entry);
  longer.definition = define_model(longer.experiment, catalog);
  longer.model = compile(longer.definition.structure, longer.definition.engine);
  longer.values = std::move(values);
  return longer;
}

AugmentedModel without(const AugmentedModel& augmented, std::size_t which, const AugmentedModel& plain,
                       const PluginCatalog& catalog) {
  std::vector<EffectEntry> added = augmented.added;
  added.erase(added.begin() + static_cast<std::ptrdiff_t>(which));
  AugmentedModel less = with_effects(plain, added, {}, catalog);
  std::map<std::string, double> known;
  for (std::size_t i = 0; i < augmented.definition.free.size(); ++i)
    known[augmented.definition.free[i].address] = augmented.values[i];
  for (const FreeValue& free : less.definition.free) less.values.push_back(known.at(free.address));
  return less;
}

}  // namespace lacuna

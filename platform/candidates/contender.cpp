#include "candidates/contender.h"

#include <map>

namespace lacuna {

Contender plain(const Experiment& experiment, const PluginCatalog& catalog, std::vector<double> values) {
  Contender contender;
  contender.experiment = experiment;
  contender.definition = define_model(contender.experiment, catalog);
  contender.model = compile(contender.definition.structure, contender.definition.engine);
  contender.values = std::move(values);
  return contender;
}

Contender with_effects(const Contender& plain, const std::vector<EffectEntry>& added, std::vector<double> values,
                       const PluginCatalog& catalog) {
  Contender longer;
  longer.experiment = plain.experiment;
  for (const EffectEntry& entry : added) longer.experiment = with_effect(std::move(longer.experiment), entry);
  longer.added = added;
  longer.definition = define_model(longer.experiment, catalog);
  longer.model = compile(longer.definition.structure, longer.definition.engine);
  longer.values = std::move(values);
  return longer;
}

Contender without(const Contender& contender, std::size_t which, const Contender& plain, const PluginCatalog& catalog) {
  std::vector<EffectEntry> added = contender.added;
  added.erase(added.begin() + static_cast<std::ptrdiff_t>(which));
  Contender less = with_effects(plain, added, {}, catalog);
  std::map<std::string, double> known;
  for (std::size_t i = 0; i < contender.definition.free.size(); ++i)
    known[contender.definition.free[i].address] = contender.values[i];
  for (const FreeValue& free : less.definition.free) less.values.push_back(known.at(free.address));
  return less;
}

}  // namespace lacuna

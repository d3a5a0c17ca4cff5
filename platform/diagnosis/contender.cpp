#include "diagnosis/contender.h"

#include <map>

namespace lacuna {

Contender plain(const Experiment& experiment, const PluginCatalog& catalog, std::vector<double> values, int substeps) {
  Contender contender;
  contender.experiment = experiment;
  contender.experiment.engine.substeps = substeps;
  contender.definition = define_model(contender.experiment, catalog);
  contender.model = compile(contender.definition.structure, contender.definition.engine);
  contender.values = std::move(values);
  return contender;
}

Contender with(const Contender& contender, const Hypothesis& hypothesis, std::vector<double> values) {
  Contender next{with_effect(contender.experiment, hypothesis.entry), contender.added, hypothesis.definition, nullptr,
                 std::move(values)};
  next.added.push_back(hypothesis.entry);
  next.model = compile(next.definition.structure, next.definition.engine);
  return next;
}

Contender without(const Contender& contender, std::size_t which, const Experiment& experiment,
                  const PluginCatalog& catalog) {
  Contender less;
  less.experiment = experiment;
  for (std::size_t i = 0; i < contender.added.size(); ++i) {
    if (i == which) continue;
    less.added.push_back(contender.added[i]);
    less.experiment = with_effect(std::move(less.experiment), contender.added[i]);
  }
  less.definition = define_model(less.experiment, catalog);
  less.model = compile(less.definition.structure, less.definition.engine);
  std::map<std::string, double> known;
  for (std::size_t i = 0; i < contender.definition.free.size(); ++i)
    known[contender.definition.free[i].address] = contender.values[i];
  for (const FreeValue& free : less.definition.free) less.values.push_back(known.at(free.address));
  return less;
}

}  // namespace lacuna

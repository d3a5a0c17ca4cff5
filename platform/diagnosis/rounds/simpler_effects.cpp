#include "diagnosis/rounds/simpler_effects.h"

#include "foundation/address.h"

#include <lacuna/error.h>
#include <lacuna/physical_effect.h>

#include <algorithm>
#include <map>

namespace lacuna {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_usable(const PluginCatalog& catalog, const std::string& effect) {
  const std::vector<PluginListing> all = catalog.list();
  return std::any_of(all.begin(), all.end(), [&](const PluginListing& one) {
    return one.kind == "effect" && one.name == effect && one.problem.empty();
  });
}

std::vector<std::string> simpler_than(const std::string& effect, const PluginCatalog& catalog,
                                      const std::vector<std::string>& among) {
  const EffectDescription description = catalog.get<PhysicalEffect>(effect).describe();
  std::vector<std::string> names;
  for (const std::string& name : description.look_alikes) {
    if ((!among.empty() && !holds(among, name)) || !is_usable(catalog, name)) continue;
    const EffectDescription alike = catalog.get<PhysicalEffect>(name).describe();
    if (alike.parameters.size() < description.parameters.size()) names.push_back(name);
  }
  return names;
}

bool has(const Experiment& experiment, const std::string& effect, const std::vector<std::string>& where) {
  const EffectList& effects = experiment.model.effects;
  return std::any_of(effects.begin(), effects.end(),
                     [&](const EffectEntry& one) { return one.effect == effect && one.where == where; });
}

/// Of an effect's values, by unit: their sum and how many they are.
std::map<std::string, std::pair<double, double>> sums_by_unit(const Contender& model, const std::string& id) {
  std::map<std::string, std::pair<double, double>> sums;
  for (std::size_t i = 0; i < model.definition.free.size(); ++i) {
    if (!is_of_effect(model.definition.free[i].address, id)) continue;
    auto& [sum, count] = sums[model.definition.free[i].unit];
    sum += model.values[i];
    count += 1.0;
  }
  return sums;
}

/// The id that an effect added to a model got.
std::string id_in(const Contender& model, const Contender& plain, std::size_t which) {
  return model.experiment.model.effects[plain.experiment.model.effects.size() + which].id;
}

Contender replaced(const Contender& answer, std::size_t which, const std::string& name, const Contender& plain,
                   const PluginCatalog& catalog) {
  std::map<std::string, double> known;
  for (std::size_t i = 0; i < answer.definition.free.size(); ++i)
    known[answer.definition.free[i].address] = answer.values[i];
  std::vector<EffectEntry> added = answer.added;
  EffectEntry simple;
  simple.effect = name;
  simple.where = added[which].where;
  added[which] = simple;
  Contender model = with_effects(plain, added, {}, catalog);
  model.added[which].id = id_in(model, plain, which);
  const auto sums = sums_by_unit(answer, id_in(answer, plain, which));
  for (const FreeValue& free : model.definition.free) {
    const auto sum = sums.find(free.unit);
    if (is_of_effect(free.address, model.added[which].id))
      model.values.push_back(sum == sums.end() ? free.start : sum->second.first / sum->second.second);
    else
      model.values.push_back(known.at(free.address));
  }
  return model;
}

}  // namespace

std::vector<Contender> with_simpler_effects(const Contender& answer, const Contender& plain,
                                            const PluginCatalog& catalog, const std::vector<std::string>& among) {
  std::vector<Contender> models;
  for (std::size_t i = 0; i < answer.added.size(); ++i)
    for (const std::string& name : simpler_than(answer.added[i].effect, catalog, among)) {
      if (has(answer.experiment, name, answer.added[i].where)) continue;
      try {
        models.push_back(replaced(answer, i, name, plain, catalog));
      } catch (const Error&) {
        // it stands on other elements, or needs what the robot has not
      }
    }
  return models;
}

}  // namespace lacuna

#include "diagnosis/rounds/present_effects.h"

#include "diagnosis/rounds/search_state.h"
#include "foundation/address.h"

#include <algorithm>
#include <map>

namespace lacuna {
namespace {

Contender without_effects(const Contender& plain, const PluginCatalog& catalog) {
  Contender bare;
  bare.experiment = plain.experiment;
  ModelSection& model = bare.experiment.model;
  model.effects.clear();
  std::erase_if(model.free, [](const FreeRange& free) { return is_of_effect(free.pattern); });
  std::erase_if(model.set, [](const auto& value) { return is_of_effect(value.first); });
  for (MeasuredFile& file : bare.experiment.target.recording.files) {
    std::erase_if(file.own, [](const std::string& pattern) { return is_of_effect(pattern); });
    std::erase_if(file.setup.values, [](const Setup::Value& value) { return is_of_effect(value.address); });
  }
  bare.definition = define_model(bare.experiment, catalog);
  bare.model = compile(bare.definition.structure, bare.definition.engine);
  std::map<std::string, double> known;
  for (std::size_t i = 0; i < plain.definition.free.size(); ++i)
    known[plain.definition.free[i].address] = plain.values[i];
  for (const FreeValue& free : bare.definition.free) bare.values.push_back(known.at(free.address));
  return bare;
}

}  // namespace

std::optional<PresentEffects> present_effects(const Contender& plain, const PluginCatalog& catalog, const Round& round,
                                              std::uint64_t seed, int threads) {
  if (plain.experiment.model.effects.empty()) return std::nullopt;
  PresentEffects present;
  for (const EffectEntry& entry : plain.experiment.model.effects) present.names.push_back(name_of(entry));
  const Refit with = refit_under(round, plain, threads);
  const Refit less = refit_under(round, without_effects(plain, catalog), threads);
  if (!with.valid || !less.valid) return std::nullopt;
  present.gain = gain(held_out_deviance(less, round.folds), held_out_deviance(with, round.folds), seed);
  return present;
}

}  // namespace lacuna

#include "measured_rigs/set_scores.h"

#include "app/workspace/rig.h"
#include "search/set_starts.h"

#include <algorithm>
#include <limits>
#include <set>
#include <thread>

namespace hidden_effects {
namespace {

using namespace lacuna;

constexpr double kNoScore = std::numeric_limits<double>::quiet_NaN();

/// Names of the effects without their places.
std::vector<std::string> effect_names(const std::vector<std::vector<std::string>>& sets) {
  std::set<std::string> names;
  for (const std::vector<std::string>& set : sets)
    for (const std::string& effect : set) names.insert(effect.substr(0, effect.find(' ')));
  return {names.begin(), names.end()};
}

/// A set with one of these effects more, the one that promises most; null: none promises anything.
const FittedSet* grown(const Ground& ground, ModelSets& sets, const FittedSet& from, std::vector<std::string>& left) {
  const Look look = look_beside(ground, from.model, from.all.fit);
  for (const Promise& promise : look.promises) {
    const std::string name = name_of_set({look.hypotheses[promise.hypothesis].entry});
    const auto wanted = std::find(left.begin(), left.end(), name);
    if (wanted == left.end()) continue;
    left.erase(wanted);
    const StartedSet started = with_promised(ground, from, look, promise);
    const std::string longer = name_of_set(started.model.added);
    if (!sets.find(longer)) sets.fit(started.model, started.ways);
    return &sets.finish(longer);
  }
  return nullptr;
}

double held_out_cost(const Ground& ground, ModelSets& sets, std::vector<std::string> effects) {
  const FittedSet* set = &sets.base();
  while (set && set->all.valid() && !effects.empty()) set = grown(ground, sets, *set, effects);
  if (!set || !set->all.valid()) return kNoScore;
  const HorizonErrors errors = held_out_errors(ground, set->model);
  return errors.valid ? errors.cost : kNoScore;
}

}  // namespace

std::vector<double> held_out_costs(const std::filesystem::path& experiment,
                                   const std::vector<std::vector<std::string>>& sets) {
  CommonOptions options;
  options.experiment = experiment.string();
  const Rig rig = open_rig(options);
  MissingTask task{rig.experiment, *rig.catalog, rig.trials, rig.definition.start_values()};
  task.among = effect_names(sets);
  task.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const Ground ground(task);
  ModelSets fitted(ground);
  std::vector<double> costs;
  for (const std::vector<std::string>& set : sets) costs.push_back(held_out_cost(ground, fitted, set));
  return costs;
}

}  // namespace hidden_effects

#include "measured_rigs/set_scores.h"

#include "app/workspace/open_experiment.h"
#include "prediction/settled_errors.h"
#include "search/effect_look.h"

#include <algorithm>
#include <limits>
#include <optional>
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

/// Fits sets of effects by name, each where it promises most.
class NamedSets {
 public:
  explicit NamedSets(const EffectSearchTask& task) : data_(task), models_(data_, data_.deciding(), kept_) {
    if (!models_.fit({}, {{}})) return;
    look_ = look_at_library(data_, models_.base(), data_.deciding());
  }

  double held_out_cost(std::vector<std::string> effects) {
    const FittedModel* set = models_.find({});
    while (set && !effects.empty()) set = grown(*set, effects);
    const PredictionLadder ladder = data_.held_out();
    if (!set || ladder.stretches.empty()) return kNoScore;
    const ModelContext context = data_.bench_for(set->model);
    LadderPredictions predictions(ladder, context.predictor(), context.space(), data_.starts(),
                                  changes_readings(set->model.definition));
    const std::optional<Eigen::VectorXd> left = settled_errors(predictions, set->fit.point.values);
    if (!left) return kNoScore;
    double cost = 0.0;
    for (std::size_t c = 0; c < ladder.layout.cells.size(); ++c)
      if (const double weight = ladder.layout.cells[c].weight; weight > 0.0)
        cost += weight * cost_of_mean_square((*left)(static_cast<Eigen::Index>(c)));
    return cost;
  }

 private:
  /// A set with one of these effects more, the one that promises most; null: none promises anything.
  const FittedModel* grown(const FittedModel& from, std::vector<std::string>& left) {
    EffectLook beside;
    if (!from.model.added.empty()) beside = look_beside(data_, from, look_);
    const EffectLook& look = from.model.added.empty() ? look_ : beside;
    for (const EffectPromise& promise : look.promises) {
      const EffectEntry& entry = look.hypotheses[promise.hypothesis].entry;
      const auto wanted = std::find(left.begin(), left.end(), entry.effect);
      if (wanted == left.end()) continue;
      left.erase(wanted);
      std::vector<EffectEntry> added = from.model.added;
      added.push_back(entry);
      return models_.fit(added, {start_of_fit(data_, from, look, promise)});
    }
    return nullptr;
  }

  SearchData data_;
  KeptFits kept_;
  FittedModels models_;
  EffectLook look_;
};

}  // namespace

std::vector<double> held_out_costs(const std::filesystem::path& experiment,
                                   const std::vector<std::vector<std::string>>& sets) {
  CommonOptions options;
  options.experiment = experiment.string();
  const OpenExperiment opened = open_experiment(options);
  EffectSearchTask task{opened.experiment, *opened.catalog, opened.trials, opened.definition.start_values()};
  task.among = effect_names(sets);
  task.work.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  NamedSets fitted(task);
  std::vector<double> costs;
  for (const std::vector<std::string>& set : sets) costs.push_back(fitted.held_out_cost(set));
  return costs;
}

}  // namespace hidden_effects

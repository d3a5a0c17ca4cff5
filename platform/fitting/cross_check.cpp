#include "fitting/cross_check.h"

#include "fitting/comparison.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace lacuna {
namespace {

constexpr int kTimesAsShort =
    64;  ///< factor by which the steps are shorter than the model's; the finer solution's steps are half of that

std::string other_engine(const ModelDefinition& definition) {
  if (definition.engine.engine != "ode") return "ode";
  const std::string other = engine_for(definition.structure.robot);
  if (other == "ode")
    throw Error(
        "no second engine is available for a check: bodies of this robot may touch the ground, which only ode can "
        "simulate");
  return other;
}

/// A model's predictions of whole trials.
class Solution {
 public:
  Solution(const ComparisonTask& task, const EngineSettings& engine)
      : model_(compile(task.definition.structure, engine)),
        predictor_(*model_, task.trials, task.work),
        values_(task.values) {}

  int workers() const { return predictor_.workers(); }
  Prediction from(const std::vector<RunPiece>& pieces, std::size_t trial, int worker) const {
    predictor_.stop().throw_if_due();
    return predict_again(predictor_, trial, pieces, values_, worker);
  }

 private:
  std::unique_ptr<CompiledModel> model_;
  TrialPredictor predictor_;
  const std::vector<double>& values_;
};

/// Sums of squares of one channel.
struct Squares {
  double apart = 0.0, error = 0.0, count = 0.0;
};

void add(const TrialComparison& trial, const TimeSeries::Samples& other, Eigen::Index channel, Squares& sums) {
  for (Eigen::Index row = trial.first_scored; row < other.rows(); ++row) {
    const double residual = trial.residuals(row, channel);
    if (!std::isfinite(residual)) continue;
    sums.apart += std::pow(other(row, channel) - trial.predicted(row, channel), 2);
    sums.error += residual * residual;
    sums.count += 1.0;
  }
}

}  // namespace

CrossCheck cross_check(const ComparisonTask& task, const Comparison& comparison) {
  CrossCheck check{.engine = other_engine(task.definition), .substeps = 0, .channels = {}, .left_out = {}};
  EngineSettings engine = task.definition.engine;
  engine.engine = check.engine;
  engine.substeps = kTimesAsShort * std::max(1, engine.substeps);
  const Solution coarse(task, engine);
  engine.substeps = check.substeps = 2 * engine.substeps;
  const Solution fine(task, engine);
  std::vector<Prediction> first(task.trials.size()), second(task.trials.size());
  parallel_for(task.trials.size(), coarse.workers(), [&](std::size_t trial, int worker) {
    if (!comparison.trials[trial].valid) return;
    first[trial] = coarse.from(comparison.trials[trial].pieces, trial, worker);
    second[trial] = fine.from(comparison.trials[trial].pieces, trial, worker);
  });

  const double halved =
      check.engine == "ode" ? 2.0 : 4.0;  // change by half the step, for an error of first or second order
  std::vector<Squares> sums;
  for (std::size_t t = 0; t < task.trials.size(); ++t) {
    const TrialComparison& trial = comparison.trials[t];
    if (!first[t].valid || !second[t].valid) {
      const std::string& reason = first[t].valid ? second[t].reason : first[t].reason;
      check.left_out.push_back(trial.trial + ": " + (trial.valid ? reason : trial.reason));
      continue;
    }
    const TimeSeries::Samples limit = (halved * second[t].samples - first[t].samples) / (halved - 1.0);
    for (std::size_t c = 0; c < trial.channels.size(); ++c) {
      const std::string& name = trial.channels[c].channel;
      auto found = std::find_if(check.channels.begin(), check.channels.end(),
                                [&](const EngineDistance& one) { return one.channel == name; });
      if (found == check.channels.end()) {
        check.channels.push_back({name, trial.channels[c].unit, 0.0, 0.0});
        sums.emplace_back();
        found = check.channels.end() - 1;
      }
      add(trial, limit, static_cast<Eigen::Index>(c), sums[static_cast<std::size_t>(found - check.channels.begin())]);
    }
  }
  for (std::size_t c = 0; c < check.channels.size(); ++c) {
    check.channels[c].apart = std::sqrt(sums[c].apart / sums[c].count);
    check.channels[c].error = std::sqrt(sums[c].error / sums[c].count);
  }
  return check;
}

}  // namespace lacuna

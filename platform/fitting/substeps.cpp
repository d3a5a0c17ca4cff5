#include "fitting/substeps.h"

#include "fitting/floor/free_run.h"
#include "fitting/floor/noise_floor.h"
#include "fitting/numerics/scored_rms.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

namespace lacuna {
namespace {

constexpr double kToleratedShare = 0.05;  ///< of the unavoidable uncertainty of a prediction
constexpr double kLeastOfSignal = 3e-3;   ///< of a channel's standard deviation: few models are better
constexpr double kToleratedShift = 0.1;   ///< of half a value's 95 % interval
constexpr int kMostSubsteps = 128;
constexpr int kMostForValues = 16;    ///< times as many as the motion needs: a limit on the time of a fit
constexpr double kLargestLeap = 4.0;  ///< times as many, in one trial: the order of convergence may not show yet
constexpr double kHelped = 0.7;     ///< of the improvement expected from the order: a chaotic motion does not converge
constexpr std::size_t kTrials = 8;  ///< evenly spread over all trials

std::vector<Trial> some_of(const std::vector<Trial>& trials) {
  std::vector<Trial> chosen;
  const std::size_t count = std::min(kTrials, trials.size());
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(trials[i * trials.size() / count]);
  return chosen;
}

double deviation_of(const TimeSeries::Samples& measured, Eigen::Index channel) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (Eigen::Index row = 0; row < measured.rows(); ++row) {
    const double value = measured(row, channel);
    if (!std::isfinite(value)) continue;
    sum += value;
    squares += value * value;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(std::max(0.0, squares / count - std::pow(sum / count, 2))) : 0.0;
}

/// Of one channel, over trials.
struct ChannelShare {
  double change = 0.0, unknown = 0.0;  ///< squares
};

/// Integrates with any number of substeps and with twice as many.
class TwoSolutions {
 public:
  TwoSolutions(const ModelDefinition& definition, const std::vector<Trial>& trials, std::span<const double> values,
               const Work& work)
      : definition_(definition),
        trials_(some_of(trials)),
        noise_(sensor_noise(definition.structure.robot, trials_)),
        values_(values),
        work_(work) {}

  const std::vector<Trial>& trials() const { return trials_; }

  /// See `Substeps::share`; nothing where a trial cannot be simulated.
  std::optional<double> share(int substeps) const {
    const std::unique_ptr<CompiledModel> model = compiled(substeps), finer = compiled(2 * substeps);
    const TrialPredictor predictor(*model, trials_, work_), fine(*finer, trials_, work_);
    const StartStates states(definition_.structure.robot, predictor, noise_);
    std::vector<std::vector<ChannelShare>> shares(trials_.size());
    parallel_for(trials_.size(), predictor.workers(), [&](std::size_t trial, int worker) {
      shares[trial] = shares_of(predictor, fine, states, trial, worker);
    });
    if (std::any_of(shares.begin(), shares.end(), [](const auto& one) { return one.empty(); })) return std::nullopt;
    return largest(shares);
  }

 private:
  std::unique_ptr<CompiledModel> compiled(int substeps) const {
    EngineSettings engine = definition_.engine;
    engine.substeps = substeps;
    return compile(definition_.structure, engine);
  }

  double noise_of(const std::string& channel) const {
    const auto found =
        std::find_if(noise_.begin(), noise_.end(), [&](const ChannelNoise& one) { return one.channel == channel; });
    return found == noise_.end() ? 0.0 : found->deviation;
  }

  /// One per channel of the trial; none where it cannot be simulated.
  std::vector<ChannelShare> shares_of(const TrialPredictor& predictor, const TrialPredictor& fine,
                                      const StartStates& states, std::size_t trial, int worker) const {
    work_.stop.throw_if_requested();
    const FreeRun run = free_run(predictor, states, trial, values_, worker);
    const Prediction better = predict_again(fine, trial, run.pieces, values_, worker);
    std::vector<ChannelShare> all;
    if (!run.prediction.valid || !better.valid) return all;
    const Eigen::VectorXd from_start = effect_of_start(predictor, trial, values_, run, worker);
    const TimeSeries::Samples change = better.samples - run.prediction.samples;
    const TimeSeries& measured = trials_[trial].measured;
    for (Eigen::Index c = 0; c < change.cols(); ++c) {
      const double noise = noise_of(measured.channels[static_cast<std::size_t>(c)].name);
      const double least = kLeastOfSignal * deviation_of(measured.samples, c);
      const double moved = scored_rms(change, c, run.first_scored);
      all.push_back({});
      if (!std::isfinite(moved)) continue;  // nothing is scored
      all.back() = {moved * moved, std::pow(std::max({noise, least, from_start(c)}), 2)};
    }
    return all;
  }

  double largest(const std::vector<std::vector<ChannelShare>>& shares) const {
    std::map<std::string, ChannelShare> pooled;
    for (std::size_t trial = 0; trial < shares.size(); ++trial)
      for (std::size_t c = 0; c < shares[trial].size(); ++c) {
        ChannelShare& channel = pooled[trials_[trial].measured.channels[c].name];
        channel.change += shares[trial][c].change;
        channel.unknown += shares[trial][c].unknown;
      }
    double most = 0.0;
    for (const auto& [name, share] : pooled)
      if (share.change > 0.0) most = std::max(most, std::sqrt(share.change / share.unknown));
    return most * 4.0 / 3.0;  // with half the step, a quarter of the error remains
  }

  const ModelDefinition& definition_;
  std::vector<Trial> trials_;
  std::vector<ChannelNoise> noise_;
  std::span<const double> values_;
  Work work_;
};

/// The number expected from the order where the error with `substeps` is so many times the tolerance.
int next_count(int substeps, double excess) {
  const double wanted = std::ceil(substeps * std::sqrt(excess));
  return static_cast<int>(std::clamp(wanted, substeps + 1.0, kLargestLeap * substeps));
}

/// The largest error with `count` substeps that justifies them, given the error before.
double promised(double left, int before, int count) {
  const double kept = std::pow(static_cast<double>(before) / count, 2);
  return left * (1.0 - kHelped * (1.0 - kept));
}

/// As many as the motion needs.
Substeps enough_for_motion(const TwoSolutions& solutions) {
  Substeps found{1, std::numeric_limits<double>::infinity(), {}, false};
  for (int count = 1; count <= kMostSubsteps && !found.enough;) {
    const std::optional<double> share = solutions.share(count);
    if (share && *share > promised(found.share, found.count, count)) break;
    if (share) found = {count, *share, {}, *share <= kToleratedShare};
    count = share ? next_count(count, *share / kToleratedShare) : 2 * count;
  }
  return found;
}

/// As many as the free values need, at least those of `found`.
void suffice_for_values(const IntegrationBias& bias, Substeps& found) {
  const int most = std::min(kMostSubsteps, kMostForValues * found.count);
  std::optional<ValueShift> shift = bias.with(found.count);
  if (!shift) return;
  found.shift = *shift;
  while (found.shift.share > kToleratedShift && found.count < most) {
    const int count = std::min(most, next_count(found.count, found.shift.share / kToleratedShift));
    shift = bias.with(count);
    if (!shift || shift->share > promised(found.shift.share, found.count, count)) break;
    found.count = count;
    found.shift = *shift;
  }
  found.enough = found.shift.share <= kToleratedShift;
}

/// Of these, as many as the fitted values need.
Substeps sufficient_for_values(const ModelDefinition& definition, const std::vector<Trial>& trials,
                               std::span<const double> values, const Work& work, const FitSection& options,
                               const TwoSolutions& solutions, Substeps found) {
  const IntegrationBias bias(definition, options, solutions.trials(), trials.size(), {values.begin(), values.end()},
                             found.count, work);
  const std::vector<double> near = bias.values();
  if (near.empty()) return found;
  const TwoSolutions nearer(definition, trials, near, work);
  if (!found.enough) found = enough_for_motion(nearer);
  if (!found.enough) return found;
  const int for_motion = found.count;
  suffice_for_values(bias, found);
  if (found.count > for_motion) found.share = nearer.share(found.count).value_or(found.share);
  return found;
}

}  // namespace

Substeps sufficient_substeps(const ModelDefinition& definition, const std::vector<Trial>& trials,
                             std::span<const double> values, const Work& work, TrialsFor trials_for,
                             const FitSection& options) {
  if (trials.empty() || definition.engine.engine == "ode") return {};
  const TwoSolutions solutions(definition, trials, values, work);
  const Substeps found = enough_for_motion(solutions);
  if (definition.free.empty() || trials_for == TrialsFor::motion || !std::isfinite(found.share)) return found;
  try {
    return sufficient_for_values(definition, trials, values, work, options, solutions, found);
  } catch (const TimeIsUp&) {
    return found;  // the limit stays: the next step reports where it ended
  }
}

}  // namespace lacuna

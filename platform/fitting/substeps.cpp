#include "fitting/substeps.h"

#include "fitting/free_run.h"
#include "fitting/noise_floor.h"
#include "fitting/scores.h"
#include "foundation/interrupt.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

namespace lacuna {
namespace {

constexpr double kToleratedShare = 0.05;  ///< of what is not known of a prediction
constexpr double kLeastOfSignal = 3e-3;   ///< a channel's standard deviation: few models are better
constexpr int kMostSubsteps = 128;
constexpr double kLargestLeap = 4.0;  ///< times as many, at once: the order may not show yet
constexpr double kHelped = 0.7;       ///< of what the order promises: a chaotic motion follows no step
constexpr std::size_t kTrials = 8;    ///< spread evenly over those that there are

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
               int threads)
      : definition_(definition),
        trials_(some_of(trials)),
        noise_(sensor_noise(definition.structure.robot, trials_)),
        values_(values),
        threads_(threads) {}

  /// See `Substeps::share`; nothing where a trial cannot be simulated.
  std::optional<double> share(int substeps) const {
    const std::unique_ptr<CompiledModel> model = compiled(substeps), finer = compiled(2 * substeps);
    const TrialPredictor predictor(*model, trials_, threads_), fine(*finer, trials_, threads_);
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

  /// One a channel of the trial; none where it cannot be simulated.
  std::vector<ChannelShare> shares_of(const TrialPredictor& predictor, const TrialPredictor& fine,
                                      const StartStates& states, std::size_t trial, int worker) const {
    throw_if_asked_to_stop();
    const FreeRun run = free_run(predictor, states, trial, values_, worker);
    Prediction better;
    fine.predict(fine.whole(trial), values_, run.start.start, worker, better);
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
    return most * 4.0 / 3.0;  // half the step leaves a quarter of the error
  }

  const ModelDefinition& definition_;
  std::vector<Trial> trials_;
  std::vector<ChannelNoise> noise_;
  std::span<const double> values_;
  int threads_;
};

/// As many as the order promises to need where `substeps` leave this share.
int next_count(int substeps, double share) {
  const double wanted = std::ceil(substeps * std::sqrt(share / kToleratedShare));
  return static_cast<int>(std::clamp(wanted, substeps + 1.0, kLargestLeap * substeps));
}

/// The most that so many substeps may leave to be worth it.
double promised(const Substeps& before, int count) {
  const double kept = std::pow(static_cast<double>(before.count) / count, 2);
  return before.share * (1.0 - kHelped * (1.0 - kept));
}

}  // namespace

Substeps sufficient_substeps(const ModelDefinition& definition, const std::vector<Trial>& trials,
                             std::span<const double> values, int threads) {
  Substeps found;
  if (trials.empty() || definition.engine.engine == "ode") return found;
  const TwoSolutions solutions(definition, trials, values, threads);
  found = {1, std::numeric_limits<double>::infinity(), false};
  for (int count = 1; count <= kMostSubsteps && !found.enough;) {
    const std::optional<double> share = solutions.share(count);
    if (share && *share > promised(found, count)) break;
    if (share) found = {count, *share, *share <= kToleratedShare};
    count = share ? next_count(count, *share) : 2 * count;
  }
  return found;
}

}  // namespace lacuna

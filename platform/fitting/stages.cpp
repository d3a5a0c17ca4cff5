#include "fitting/stages.h"

#include "fitting/starts/start_fit.h"
#include "foundation/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

constexpr int kProbes = 5;  ///< starts a trial

std::optional<double> seconds(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value > 0.0)) return std::nullopt;
  return value;
}

PlannedStage last_stage(const std::string& horizon) {
  if (horizon == "whole") return {"free run", 0.0, false};
  if (horizon == "auto") return {"automatic horizon", 0.0, true};
  const std::optional<double> length = seconds(horizon);
  if (!length) throw Error("fit.horizon is \"" + horizon + "\"; write \"whole\", \"auto\" or seconds such as \"2.0\"");
  return {fmt::format("segments of {:g} s", *length), *length, false};
}

double longest_trial(const TrialPredictor& predictor) {
  double longest = 0.0;
  for (const Trial& trial : predictor.trials())
    if (!trial.held_out)
      longest = std::max(longest, trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0));
  return longest;
}

/// Why the trials cannot be cut into segments, or nothing.
std::string why_not_cut(const TrialPredictor& predictor, const StartStates& states) {
  for (std::size_t trial = 0; trial < predictor.trials().size(); ++trial) {
    if (const std::string obstacle = states.obstacle(trial); !obstacle.empty())
      return predictor.trials()[trial].name + ": " + obstacle;
  }
  return "";
}

/// Time until the uncertainty of the initial state, estimated on `head` s, reaches `growth` × noise; infinite if it
/// never does, nothing if the model cannot be simulated.
std::optional<double> time_to_grow(const TrialPredictor& predictor, const StartStates& states, const Stretch& stretch,
                                   const std::vector<double>& values, int worker, double head, double growth) {
  const StartEstimate estimate = fit_head(predictor, states, stretch, values, worker, head);
  Prediction base, moved;
  if (estimate.valid) predictor.predict(stretch, values, estimate.start, worker, base);
  if (!base.valid) return std::nullopt;
  TimeSeries::Samples variance = TimeSeries::Samples::Zero(base.samples.rows(), base.samples.cols());
  for (Eigen::Index axis = 0; axis < estimate.axes.cols(); ++axis) {
    predictor.predict(stretch, values, moved_along(estimate, axis), worker, moved);
    if (moved.valid) variance += (moved.samples - base.samples).cwiseAbs2();
  }
  const Eigen::VectorXd& times = predictor.trials()[stretch.trial].measured.times;
  for (Eigen::Index row = 0; row < variance.rows(); ++row)
    for (Eigen::Index column = 0; column < variance.cols(); ++column)
      if (std::sqrt(variance(row, column)) > growth * estimate.misfit * states.deviation(stretch.trial, column))
        return times(stretch.first + row) - times(stretch.first);
  return std::numeric_limits<double>::infinity();
}

/// From a sample to the trial's end, or to the restart of the prediction.
Stretch probe_at(const TrialPredictor& predictor, std::size_t trial, Eigen::Index first, double restart) {
  const Eigen::VectorXd& times = predictor.trials()[trial].measured.times;
  const double* end = times.data() + times.size();
  return {trial, first, std::upper_bound(times.data() + first, end, times(first) + kHead + restart) - times.data()};
}

/// For trials whose predictions restart after a while, no stage is longer.
PlannedStage limited(PlannedStage last, const TrialPredictor& predictor, const StartStates& states,
                     std::vector<std::string>& notes) {
  double restart = std::numeric_limits<double>::infinity();
  for (std::size_t trial = 0; trial < predictor.trials().size(); ++trial)
    if (!predictor.trials()[trial].held_out && states.reconstructible(trial))
      restart = std::min(restart, states.restart(trial));
  if (last.automatic || last.length > 0.0 || !(restart < longest_trial(predictor))) return last;
  notes.push_back(
      fmt::format("fitted to predictions of {:g} s instead of whole trials, because recorded torques drive the robot "
                  "without a controller; choose another length with fit.horizon = \"2 s\"",
                  restart));
  return {fmt::format("segments of {:g} s", restart), restart, false};
}

}  // namespace

std::vector<PlannedStage> plan_stages(const FitSection& options, const TrialPredictor& predictor,
                                      const StartStates& states, std::vector<std::string>& notes) {
  const PlannedStage last = limited(last_stage(options.horizon), predictor, states, notes);
  if (options.method == "free_run") return {last_stage("whole")};
  if (options.method != "multiple_shooting")
    throw Error("fit.method is \"" + options.method + "\"; write \"multiple_shooting\" or \"free_run\"");
  const std::string obstacle = why_not_cut(predictor, states);
  if (!obstacle.empty()) {
    notes.push_back("fitted by free run alone, because initial states inside a trial cannot be estimated (" + obstacle +
                    ")");
    return {last_stage("whole")};
  }
  std::vector<PlannedStage> stages;
  const double longest = longest_trial(predictor);
  for (const double length : options.segments)
    if (length < longest && (last.length <= 0.0 || length < last.length))
      stages.push_back({fmt::format("segments of {:g} s", length), length, false});
  stages.push_back(last);
  return stages;
}

double automatic_horizon(const TrialPredictor& predictor, const StartStates& states, const std::vector<double>& values,
                         double head, double growth) {
  std::vector<Stretch> probes;
  for (std::size_t trial = 0; trial < predictor.trials().size(); ++trial) {
    if (predictor.trials()[trial].held_out || !states.reconstructible(trial)) continue;
    const Eigen::Index size = predictor.trials()[trial].measured.times.size();
    for (Eigen::Index probe = 0; probe < kProbes; ++probe)
      probes.push_back(probe_at(predictor, trial, probe * size / (Eigen::Index{2} * kProbes), states.restart(trial)));
  }
  std::vector<std::optional<double>> grown(probes.size());
  parallel_for(probes.size(), predictor.workers(), [&](std::size_t i, int worker) {
    grown[i] = time_to_grow(predictor, states, probes[i], values, worker, head, growth);
  });
  std::vector<double> times;
  for (const std::optional<double>& time : grown)
    if (time) times.push_back(*time);
  if (times.empty()) return std::numeric_limits<double>::infinity();
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace lacuna

#include "report/text/advice_text.h"

#include "foundation/counted.h"
#include "report/text/times_floor_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lacuna {
namespace {

/// An error this close to the floor leaves nothing to find.
constexpr double kAtTheFloor = 1.2;

/// Fit trials that were scored in a channel.
double scored_trials(const Comparison& comparison, const std::string& channel) {
  double count = 0.0;
  for (const TrialComparison& trial : comparison.trials)
    for (const ChannelScore& score : trial.channels)
      if (!trial.held_out && trial.valid && score.channel == channel && score.samples > 0) count += 1.0;
  return count;
}

/// The error in multiples of what a right model may leave. A start error is one draw a trial: 1 + 1/√n standard errors
/// is, within 3 %, what the RMS of n such draws stays below 19 times in 20 (√(χ²/n)).
double times_explained(const Comparison& comparison, const PooledScore& score) {
  const double trials = std::max(scored_trials(comparison, score.channel), 1.0);
  return score.rmse / std::hypot(score.floor, (1.0 + 1.0 / std::sqrt(trials)) * score.from_start);
}

std::string failed_text(const Comparison& comparison) {
  std::vector<std::string> failed;
  for (const TrialComparison& trial : comparison.trials)
    if (!trial.valid) failed.push_back(trial.trial + ": " + trial.reason);
  if (failed.empty()) return "";
  return fmt::format(
      "{} of {} cannot be simulated, so the error over all of them is not known ({}) → a smaller engine.step, or "
      "bounds "
      "that keep the free values where the model holds\n",
      failed.size(), counted(comparison.trials.size(), "trial"), fmt::join(failed, "; "));
}

/// A channel of the fit trials whose floor is not known.
const PooledScore* without_floor(const Comparison& comparison) {
  for (const PooledScore& score : comparison.pooled)
    if (!score.held_out && !std::isfinite(score.floor)) return &score;
  return nullptr;
}

/// The channel of the fit trials that is the furthest above what is explained.
const PooledScore* furthest(const Comparison& comparison) {
  const PooledScore* worst = nullptr;
  for (const PooledScore& score : comparison.pooled)
    if (!score.held_out &&
        (worst == nullptr || times_explained(comparison, score) > times_explained(comparison, *worst)))
      worst = &score;
  return worst;
}

}  // namespace

std::string advice_text(const Comparison& comparison, const std::string& diagnose) {
  if (std::string failed = failed_text(comparison); !failed.empty()) return failed;
  if (const PooledScore* score = without_floor(comparison); score != nullptr)
    return fmt::format("the floor of {} is not known: {}\n", score->channel, score->floor_origin);
  const PooledScore* worst = furthest(comparison);
  if (worst == nullptr) return "no fit trial was scored, so nothing tells whether an effect is missing\n";
  const std::string times = times_floor_text(worst->times_floor);
  if (worst->times_floor <= kAtTheFloor) return fmt::format("model is at the floor ({} ×)\n", times);
  if (times_explained(comparison, *worst) <= kAtTheFloor)
    return fmt::format("model is at the floor as far as can be told: {} ×, which the uncertain start can explain\n",
                       times);
  return fmt::format("model is above the floor ({} ×) → {}\n", times, diagnose);
}

}  // namespace lacuna

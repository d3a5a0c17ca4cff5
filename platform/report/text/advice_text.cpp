#include "report/text/advice_text.h"

#include "foundation/text/counted.h"
#include "report/text/times_floor_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace lacuna {
namespace {

/// An error this close to the floor leaves nothing to find.
constexpr double kAtTheFloor = 1.2;

/// Trials that were scored in a channel, of those that a score is of.
double scored_trials(const Comparison& comparison, const PooledScore& pooled) {
  double count = 0.0;
  for (const TrialComparison& trial : comparison.trials)
    for (const ChannelScore& score : trial.channels)
      if (trial.held_out == pooled.held_out && trial.valid && score.channel == pooled.channel && score.samples > 0)
        count += 1.0;
  return count;
}

/// The error that a right model may have. The error of an initial state is one draw per trial: with 95 % probability
/// the RMS of n such draws is below 1 + 1/√n standard errors (√(χ²/n), within 3 %).
double explained(const Comparison& comparison, const PooledScore& score) {
  const double trials = std::max(scored_trials(comparison, score), 1.0);
  return std::hypot(score.floor, (1.0 + 1.0 / std::sqrt(trials)) * score.from_start);
}

double times_explained(const Comparison& comparison, const PooledScore& score) {
  return score.rmse / explained(comparison, score);
}

/// Trials that cannot be simulated; nothing where all can.
std::optional<Advice> advice_on_failures(const Comparison& comparison) {
  std::vector<std::string> failed;
  for (const TrialComparison& trial : comparison.trials)
    if (!trial.valid) failed.push_back(trial.trial + ": " + trial.reason);
  if (failed.empty()) return std::nullopt;
  return Advice{fmt::format("{} of {} cannot be simulated, so their common error is not known ({}).", failed.size(),
                            counted(comparison.trials.size(), "trial"), fmt::join(failed, "; ")),
                "use a smaller engine.step, or narrower bounds of the free values"};
}

/// A channel of the fit trials whose floor is not known.
const PooledScore* without_floor(const Comparison& comparison) {
  for (const PooledScore& score : comparison.pooled)
    if (!score.held_out && !std::isfinite(score.floor)) return &score;
  return nullptr;
}

/// The channel of the fit trials, or of the held-out ones, that is the furthest above what is explained.
const PooledScore* furthest(const Comparison& comparison, bool held_out) {
  const PooledScore* worst = nullptr;
  for (const PooledScore& score : comparison.pooled)
    if (score.held_out == held_out &&
        (worst == nullptr || times_explained(comparison, score) > times_explained(comparison, *worst)))
      worst = &score;
  return worst;
}

/// The error in multiples of the floor up to which the initial-state uncertainty explains it.
std::string most_explained(const Comparison& comparison, const PooledScore& score) {
  return times_floor_text(kAtTheFloor * explained(comparison, score) / score.floor);
}

/// That the error of the fit trials may be that of a correct model, with the reason.
std::string at_the_floor(const Comparison& comparison, const PooledScore& score) {
  const std::string times = times_floor_text(score.times_floor);
  if (score.times_floor <= kAtTheFloor)
    return fmt::format("Error is {} × the noise floor: as small as the noise allows", times);
  return fmt::format(
      "Error is {} × the noise floor. The initial-state uncertainty can explain it: a correct model has up to {} ×",
      times, most_explained(comparison, score));
}

/// Of a model whose error on the fit trials is explained, with the evidence of the held-out trials.
Advice advice_on_explained(const Comparison& comparison, const PooledScore& fit, const std::string& diagnose) {
  const std::string of_fit = at_the_floor(comparison, fit);
  const PooledScore* worst = furthest(comparison, true);
  if (worst == nullptr || !(worst->times_floor > kAtTheFloor))
    return {of_fit + (fit.times_floor > kAtTheFloor ? ". No missing effect is visible" : ""), "", true};
  const std::string held_out =
      fmt::format("{}. Held-out files: {} {} ×", of_fit, worst->channel, times_floor_text(worst->times_floor));
  if (times_explained(comparison, *worst) <= kAtTheFloor)
    return {fmt::format("{} (a correct model has up to {} ×, because of the initial-state uncertainty). No missing "
                        "effect is visible",
                        held_out, most_explained(comparison, *worst)),
            "", true};
  return {fmt::format("{}, largest in {} at {:.2f} s. Either this motion excites an effect that the fit files do not "
                      "excite, or the rig or its load was different in this recording.",
                      held_out, worst->worst_trial, worst->worst_time),
          "move a held-out file to target.files, then " + diagnose};
}

}  // namespace

Advice advice_on(const Comparison& comparison, const std::string& diagnose) {
  if (std::optional<Advice> failures = advice_on_failures(comparison)) return *failures;
  if (const PooledScore* score = without_floor(comparison); score != nullptr)
    return {fmt::format("the noise floor of {} is not known: {}", score->channel, score->floor_origin), ""};
  const PooledScore* worst = furthest(comparison, false);
  if (worst == nullptr) return {"no fit trial was scored, so it is not known whether an effect is missing", ""};
  if (worst->times_floor <= kAtTheFloor || times_explained(comparison, *worst) <= kAtTheFloor)
    return advice_on_explained(comparison, *worst, diagnose);
  return {fmt::format("Error is {} × the noise floor: something is missing.", times_floor_text(worst->times_floor)),
          diagnose};
}

std::string advice_text(const Comparison& comparison, const std::string& diagnose) {
  const Advice advice = advice_on(comparison, diagnose);
  return advice.result + (advice.next.empty() ? "" : " Next: " + advice.next) + "\n";
}

}  // namespace lacuna

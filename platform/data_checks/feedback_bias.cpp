#include "data_checks/feedback_bias.h"

#include "foundation/statistics.h"
#include "data_checks/wrong_controllers.h"
#include "fitting/comparison.h"
#include "foundation/unit.h"
#include "measurement/trials/recorded_controller.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kBiased = 3.0;  // standard errors

/// The controller of a fit trial; null: none.
const RecordedController* controller_of(const Trial& trial) {
  return trial.held_out ? nullptr : dynamic_cast<const RecordedController*>(trial.controller.get());
}

std::vector<std::string> sentences_on(const std::vector<WrongController>& wrong) {
  std::vector<std::string> sentences;
  for (const WrongController& one : wrong)
    sentences.push_back(fmt::format(
        "{}: the controller that target.controllers declares for {} does not reproduce the recorded commands from the "
        "recorded readings (error {:.0f} % of their deviation), so feedback bias was not tested; check its gains, "
        "their signs and the reference",
        one.trial, one.actuator, 100.0 * one.off));
  return sentences;
}

std::vector<Trial> in_the_loop(std::vector<Trial> trials) {
  for (Trial& trial : trials) trial.closed_loop = controller_of(trial) != nullptr;
  return trials;
}

/// Of the interval, which reaches at least as far as the integration step changed the value. None at a bound: the other
/// estimate has an interval.
double error_of(const FittedValue& value) {
  constexpr double kWithin = 2.0 * kWithin95;  // standard errors, 95 %
  if (value.at_lower_bound || value.at_upper_bound) return 0.0;
  return std::max(value.standard_error, (value.upper_95 - value.lower_95) / kWithin);
}

std::string difference(const FittedValue& replayed, const FittedValue& looped) {
  const double error = std::hypot(error_of(replayed), error_of(looped));
  const double times = error > 0.0 ? std::abs(replayed.value - looped.value) / error : 0.0;
  if (times <= kBiased) return "";
  return fmt::format("{} ({} with the recorded commands, {} with the controller in the loop: {:.1f} standard errors)",
                     replayed.address, format_quantity(replayed.value, replayed.unit),
                     format_quantity(looped.value, looped.unit), times);
}

}  // namespace

bool has_controller(const std::vector<Trial>& trials) {
  return std::any_of(trials.begin(), trials.end(),
                     [](const Trial& trial) { return !trial.closed_loop && controller_of(trial) != nullptr; });
}

std::vector<std::string> feedback_bias(const FitTask& task) {
  if (const std::vector<WrongController> wrong = wrong_controllers(task.trials); !wrong.empty())
    return sentences_on(wrong);
  const auto fitted_to = [&](const std::vector<Trial>& trials) {
    return fit({task.definition, task.model, trials, task.options, task.seed, task.work.unreported()});
  };
  const FitResult replayed = fitted_to(task.trials), looped = fitted_to(in_the_loop(task.trials));
  std::vector<std::string> biased;
  for (std::size_t i = 0; i < replayed.values.size(); ++i)
    if (std::string text = difference(replayed.values[i], looped.values[i]); !text.empty())
      biased.push_back(std::move(text));
  if (biased.empty())
    return {"no feedback bias: with the controller in the loop no value differs by three standard errors"};
  return {fmt::format("feedback bias: {}; use the values with the controller in the loop", fmt::join(biased, ", "))};
}

}  // namespace lacuna

#include "evaluation/prediction/step_count.h"

#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

double duration_of_trial(const Trial& trial) {
  const Eigen::VectorXd& times = trial.measured.times;
  return times.size() < 2 ? 0.0 : times(times.size() - 1) - times(0);
}

/// Short to type.
double power_of_ten_above(double value) { return std::pow(10.0, std::ceil(std::log10(value))); }

int most_substeps(const Experiment& experiment) {
  return std::max({experiment.engine.substeps, experiment.target.simulated.substeps, 1});
}

}  // namespace

void check_step_count(const Experiment& experiment, double duration, const std::string& what) {
  const int substeps = most_substeps(experiment);
  const double step = experiment.engine.step;
  const double steps = duration / step * substeps;
  if (!(steps > kMostSteps)) return;
  throw_problem(
      experiment.where("engine.step"),
      fmt::format("engine.step: {}{} makes {:.2g} integration steps of each simulation {} ({}), more than {:.0e}; set "
                  "engine.step = {:g} or more (s), best to the interval of the readings",
                  format_quantity(step, "s"), substeps > 1 ? fmt::format(" in {} substeps", substeps) : "", steps, what,
                  format_quantity(duration, "s"), kMostSteps, power_of_ten_above(duration * substeps / kMostSteps)));
}

void check_step_count(const Experiment& experiment, const std::vector<Trial>& trials, bool takes_tests) {
  const auto longest = std::max_element(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    return duration_of_trial(a) < duration_of_trial(b);
  });
  if (longest != trials.end()) check_step_count(experiment, duration_of_trial(*longest), "of " + longest->name);
  if (takes_tests) check_step_count(experiment, experiment.test.duration, "of a test");
}

}  // namespace lacuna

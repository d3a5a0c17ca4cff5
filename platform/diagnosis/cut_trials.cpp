#include "diagnosis/cut_trials.h"

#include "diagnosis/free_run.h"
#include "fitting/shooting_problem.h"
#include "foundation/problem.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kRunIn = 0.1;               ///< s: longer than most delays and lags
constexpr double kShort = 0.5, kLong = 1.0;  ///< s
constexpr double kMuch = 12.0;               ///< s of data: enough for long segments
constexpr double kLeast = 0.05;              ///< s
constexpr double kAsLong = 1.01;             ///< a trial of 4 s may end a sample before that

std::vector<Trial> fit_trials(const std::vector<Trial>& trials) {
  std::vector<Trial> kept;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(kept),
               [](const Trial& trial) { return !trial.held_out; });
  if (kept.empty())
    throw Error(
        "there is no trial to diagnose: name a measured file that is not held out, or, where the target is simulated, "
        "let lacuna trial make some");
  return kept;
}

double duration_of(const Trial& trial) {
  const Eigen::VectorXd& times = trial.measured.times;
  return times.size() > 0 ? times(times.size() - 1) - times(0) : 0.0;
}

}  // namespace

double longest_fit_trial(const std::vector<Trial>& trials) {
  double longest = 0.0;
  for (const Trial& trial : trials)
    if (!trial.held_out) longest = std::max(longest, duration_of(trial));
  return longest;
}

double usual_segment(const std::vector<Trial>& trials) {
  double all = 0.0;
  for (const Trial& trial : trials)
    if (!trial.held_out) all += duration_of(trial);
  return kAsLong * all >= kMuch ? kLong : kShort;
}

void check_segment(double segment, const std::vector<Trial>& trials) {
  if (segment == 0.0) return;
  if (segment < kLeast)
    throw_problem({}, fmt::format("diagnosis.segment is {}; choose at least {}, or 0 for the usual length",
                                  format_quantity(segment, "s"), format_quantity(kLeast, "s")));
  const double longest = longest_fit_trial(trials);
  if (segment <= kAsLong * longest || longest == 0.0) return;
  std::string lengths;
  for (const Trial& trial : trials)
    if (!trial.held_out)
      lengths += (lengths.empty() ? "" : ", ") + trial.name + " " + format_quantity(duration_of(trial), "s");
  throw_problem({}, fmt::format("diagnosis.segment is {}, but no fit trial is that long: {}; choose at most {}",
                                format_quantity(segment, "s"), lengths, format_quantity(longest, "s")));
}

BaseSolution cut_trials(const CutTask& task) {
  BaseSolution base;
  base.trials = fit_trials(task.trials);
  const RobotSpec& robot = task.definition.structure.robot;
  base.noise = sensor_noise(robot, base.trials);
  const TrialPredictor predictor(task.model, base.trials, task.threads);
  const StartStates states(robot, predictor, base.noise);
  bool measured = true, reconstructible = true;
  for (std::size_t trial = 0; trial < base.trials.size(); ++trial) {
    measured = measured && states.unmeasured(trial).empty();
    reconstructible = reconstructible && states.reconstructible(trial);
  }
  if (measured) {
    const double length = task.segment > 0.0 ? task.segment : usual_segment(base.trials);
    base.segments = make_segments(predictor, states, reconstructible ? length : 0.0, task.values, kRunIn);
    for (Segment& segment : base.segments)
      if (segment.stretch.first == 0 && segment.run_in == 0) segment.deviation *= kDoubtOfStart;
  } else {
    cut_free_runs(task, predictor, states, base);
  }
  if (base.segments.empty())
    throw Error(
        "there is nothing to diagnose: no stretch of the fit files holds more measured values than its start "
        "state has unknowns; check the mask, the time ranges and the columns");
  const ParameterSpace space(task.definition.free);
  base.states =
      ShootingProblem(predictor, space, base.segments, base.noise).start(space.to_coordinates(task.values)).states;
  base.values = task.values;
  return base;
}

}  // namespace lacuna

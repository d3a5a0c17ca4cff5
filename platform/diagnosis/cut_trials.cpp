#include "diagnosis/cut_trials.h"

#include "diagnosis/free_run.h"
#include "fitting/shooting_problem.h"

#include <algorithm>

namespace lacuna {
namespace {

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

}  // namespace

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
    base.segments = make_segments(predictor, states, reconstructible ? task.segment : 0.0, task.values);
    for (Segment& segment : base.segments)
      if (segment.stretch.first == 0) segment.deviation *= kDoubtOfStart;
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

#include "diagnosis/rounds/cut_trials.h"

#include "diagnosis/rounds/free_run.h"
#include "fitting/shooting_problem.h"
#include "fitting/stages.h"
#include "foundation/problem.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lacuna {
namespace {

constexpr double kShort = 1.0;                         ///< s
constexpr std::array kLongLengths = {5.0, 2.5, 1.25};  ///< s
constexpr double kFollowed = 30.0;     ///< times the sensor noise: what an uncertain start may move a prediction by
constexpr double kAtEase = 10.0;       ///< times the sensor noise: what a model may leave over long segments, ...
constexpr double kNotMuchMore = 1.25;  ///< ... or times what it leaves over short ones
constexpr double kLeast = 0.05;        ///< s
constexpr double kAsLong = 1.01;       ///< a trial of 4 s may end a sample before that

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

/// What cuts the trials of a task; everything referred to must outlive it.
class Cutter {
 public:
  Cutter(const CutTask& task, const Follower& follower, const TrialPredictor& plain, const StartStates& states,
         const BaseSolution& base)
      : task_(task),
        plain_(plain),
        states_(states),
        base_(base),
        predictor_(follower.model, base.trials, task.threads),
        space_(follower.definition.free),
        values_(follower.values),
        moving_(follower.moving) {}

  /// Into segments of about `length` s, 0: whole trials.
  BaseSolution cut(double length) const {
    BaseSolution all = base_;
    all.segment = longest_piece(length);
    all.segments = make_segments(plain_, states_, length, task_.values, kLongestMemory);
    for (Segment& segment : all.segments)
      if (segment.stretch.first == 0 && segment.run_in == 0) segment.deviation *= kDoubtOfStart;
    all.values = values_;
    all.states =
        ShootingProblem(predictor_, space_, all.segments, all.noise).start(space_.to_coordinates(all.values)).states;
    return all;
  }

  /// Into segments of the length that is asked for, or the usual one.
  BaseSolution cut_long() {
    const double wanted = task_.segment > 0.0 ? task_.segment : kLongLengths.front();
    BaseSolution best = cut(std::min(wanted, kShort));
    if (wanted <= kShort || best.segments.empty() || longest_fit_trial(base_.trials) <= kAsLong * kShort) return best;
    const std::optional<double> near = settled(best);
    values_ = best.values;
    if (task_.segment > 0.0) {
      best = cut(wanted);
      settled(best);
      return best;
    }
    const double horizon = automatic_horizon(predictor_, states_, best.values, kShort, kFollowed);
    std::size_t as_many = 0;
    for (const double length : kLongLengths) {
      if (!near || longest_piece(length) > kAsLong * horizon) continue;
      BaseSolution longer = cut(length);
      if (longer.segments.size() == as_many) continue;  // trials that are shorter
      as_many = longer.segments.size();
      const std::optional<double> left = settled(longer);
      if (left && *left <= std::max(kAtEase, kNotMuchMore * *near)) return longer;
    }
    return best;
  }

 private:
  /// Of the trials, cut into equal ones of about `length` s: what a trial of 7 s is cut into by 5 s is itself.
  double longest_piece(double length) const {
    double longest = 0.0;
    for (std::size_t trial = 0; trial < base_.trials.size(); ++trial)
      longest = std::max(longest, duration_of(base_.trials[trial]) /
                                      static_cast<double>(lacuna::cut(base_.trials[trial], trial, length).size()));
    return longest;
  }

  /// What is left once the model has settled, RMS, multiples of the sensor noise; nothing if it cannot.
  std::optional<double> settled(BaseSolution& base) const {
    ShootingProblem problem(predictor_, space_, base.segments, base.noise);
    if (!settle(problem, space_, base, moving_)) return std::nullopt;
    std::vector<Eigen::VectorXd> residuals;
    if (!problem.residuals({space_.to_coordinates(base.values), base.states}, residuals)) return std::nullopt;
    double squares = 0.0, count = 0.0;
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      squares += residuals[k].head(problem.robust_rows(k)).squaredNorm();
      count += static_cast<double>(problem.robust_rows(k));
    }
    return std::sqrt(squares / count);
  }

  const CutTask& task_;
  const TrialPredictor& plain_;  ///< of what is cut for
  const StartStates& states_;
  const BaseSolution& base_;
  TrialPredictor predictor_;
  ParameterSpace space_;
  std::vector<double> values_;  ///< of the follower, SI
  Moving moving_;
};

}  // namespace

double longest_fit_trial(const std::vector<Trial>& trials) {
  double longest = 0.0;
  for (const Trial& trial : trials)
    if (!trial.held_out) longest = std::max(longest, duration_of(trial));
  return longest;
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

BaseSolution cut_trials(const CutTask& task) { return cut_trials(task, {task.definition, task.model, task.values}); }

BaseSolution cut_trials(const CutTask& task, const Follower& follower) {
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
    const BaseSolution uncut = base;
    Cutter cutter(task, follower, predictor, states, uncut);
    base = reconstructible ? cutter.cut_long() : cutter.cut(0.0);
  } else {
    cut_free_runs(task, predictor, states, base);
    base.values = follower.values;
  }
  if (base.segments.empty())
    throw Error(
        "there is nothing to diagnose: no stretch of the fit files holds more measured values than its start "
        "state has unknowns; check the mask, the time ranges and the columns");
  return base;
}

}  // namespace lacuna

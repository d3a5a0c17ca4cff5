#include "fitting/fit.h"

#include "fitting/anew.h"
#include "fitting/intervals/covariance.h"
#include "fitting/fitted_values.h"
#include "fitting/intervals/identifiability.h"
#include "fitting/judged_values.h"
#include "fitting/numerics/progress_meter.h"
#include "fitting/shooting/refine_all.h"
#include "fitting/stage_drift.h"
#include "fitting/stages.h"
#include "fitting/shooting/start_points.h"
#include "foundation/unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

namespace lacuna {
namespace {

constexpr std::size_t kExploredSegments = 48;  ///< of the segments, to choose among starting points
constexpr std::size_t kStageSegments = 96;     ///< in the stages before the last one
constexpr std::size_t kAllSegments = std::numeric_limits<std::size_t>::max();
constexpr double kBetter = 1e-4;  ///< of the objective, per sample: a 20 000th of the residual
constexpr double kNotFitted = std::numeric_limits<double>::quiet_NaN();

std::vector<Trial> fit_trials(const std::vector<Trial>& trials) {
  std::vector<Trial> kept;
  for (const Trial& trial : trials)
    if (!trial.held_out) kept.push_back(trial);
  if (kept.empty())
    throw Error(
        "no trial to fit to: name a recorded file that is not held out; if the target takes tests, make trials with "
        "lacuna run or lacuna trial");
  return kept;
}

RobustLoss loss_of(const FitSection& options) {
  if (options.loss == "squared") return {};
  if (options.loss == "huber") return {options.loss_scale};
  throw Error("fit.loss is \"" + options.loss + "\"; write \"huber\" or \"squared\"");
}

/// Data shared by all stages of one fit.
class Fitter {
 public:
  explicit Fitter(const FitTask& task)
      : task_(task),
        meter_(task.work.progress),
        loss_(loss_of(task.options)),
        result_(as_written(task.definition)),
        predictor_(task.model, fit_trials(task.trials), task.work),
        space_(task.definition.free) {
    result_.noise = sensor_noise(task.definition.structure.robot, predictor_.trials());
    states_ = std::make_unique<StartStates>(task.definition.structure.robot, predictor_, result_.noise);
  }

  FitResult run() {
    std::vector<PlannedStage> stages = plan_stages(task_.options, predictor_, *states_, result_.notes);
    try {
      search(stages);
      judge();
    } catch (const TimeIsUp&) {
      if (!task_.best_at_time_limit) throw;
      task_.work.stop.lift_limit();
      end_with_best(stages.back());
    }
    finish_problem();
    result_.seconds = meter_.seconds();
    return result_;
  }

 private:
  /// METHOD's step 4.
  void search(std::vector<PlannedStage>& stages) {
    meter_.set_parts(std::max(task_.options.starts, 1) + kKeptCandidates * static_cast<int>(stages.size()) + 1);
    leave_out_empty(stages);
    explore(stages.front());
    for (PlannedStage& stage : stages) {
      if (stage.automatic) find_horizon(stage, result_.stages.empty() ? kHead : result_.stages.back().segment);
      const bool last = &stage == &stages.back();
      cut_into_segments(stage.length, last ? kAllSegments : kStageSegments);
      refine_candidates(stage.name, last ? kFine : kMiddling);
      if (refined_ < kKeptCandidates) meter_.end_part();
      if (last) look_anew(stage.name);
      record(stage);
      keep_best(candidates_, problem_->samples());
    }
    settle_heads(stages.back());
    let_best_win(stages.back());
  }

  std::vector<double> current_values() const {
    return candidates_.empty() ? result_.parameters() : space_.to_values(candidates_.front().values);
  }

  /// Segments with no more samples than unknowns of their start carry no information.
  void leave_out_empty(std::vector<PlannedStage>& stages) {
    for (std::size_t i = 0; i + 1 < stages.size();) {
      if (!make_segments(predictor_, *states_, stages[i].length, current_values()).empty()) {
        ++i;
        continue;
      }
      result_.notes.push_back(stages[i].name + " hold too few samples and are left out");
      stages.erase(stages.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  /// The longest length at which the uncertainty of an initial state, estimated over the longest segments so far, stays
  /// small.
  void find_horizon(PlannedStage& stage, double head) {
    const double horizon = std::max(head, automatic_horizon(predictor_, *states_, current_values(), head));
    stage.length = std::isfinite(horizon) ? horizon : 0.0;
    stage.name = stage.length > 0.0 ? fmt::format("segments of {:.3g} s (automatic horizon)", horizon) : "free run";
    if (stage.length > 0.0)
      result_.notes.push_back(
          fmt::format("the last stage uses segments of {:.3g} s: up to this length, the uncertainty of an initial "
                      "state estimated over {:.3g} s stays below twice the noise",
                      horizon, head));
  }

  /// Tries all starting points, on a part of the data if there is plenty.
  void explore(const PlannedStage& stage) {
    cut_into_segments(stage.length, kExploredSegments);
    for (const Eigen::VectorXd& point :
         start_points(*problem_, space_, task_.definition.free, task_.options.starts, task_.seed)) {
      candidates_.emplace_back();
      candidates_.back().values = point;
    }
    result_.starts = static_cast<int>(candidates_.size());
    refine_candidates("starting points", kCoarse);
    result_.agreeing = agreeing_;
    keep_best(candidates_, problem_->samples());
  }

  void cut_into_segments(double length, std::size_t most) {
    std::vector<Segment> segments = thinned(make_segments(predictor_, *states_, length, current_values()), most);
    if (segments.empty())
      throw Error(
          "nothing to fit to: no stretch of the fit files has more readings than unknowns of its initial state; check "
          "the mask, the time ranges and the columns");
    auto next = std::make_unique<ShootingProblem>(predictor_, space_, std::move(segments), result_.noise);
    if (problem_) next->set_steps(problem_->steps());
    finish_problem();
    problem_ = std::move(next);
  }

  void refine_candidates(const std::string& stage, double precision) {
    candidates_ = refine_all(*problem_, starts_of(candidates_), watched(search(precision)), meter_, stage);
    refined_ = static_cast<int>(candidates_.size());
    order_candidates();
  }

  void order_candidates() {
    agreeing_ = rank(candidates_, problem_->samples());
    if (!candidates_.front().valid)
      throw Error("the model cannot be simulated from any of " + std::to_string(candidates_.size()) +
                  " starting points: " + problem_->last_reason() + "; check the start values and bounds of [model]");
    problem_->set_steps(candidates_.front().steps);
  }

  RefinementOptions search(double precision) const { return {loss_, task_.options.max_iterations, precision}; }

  /// Remembers the values that a search has reached, for the case that the time limit ends it.
  RefinementOptions watched(RefinementOptions options) {
    if (task_.best_at_time_limit)
      options.reached = [this](const FitPoint& point) {
        const std::scoped_lock lock(reaching_);
        reached_ = space_.to_values(point.values);
      };
    return options;
  }

  /// The best values of the search by the measure of the last stage, without intervals: it did not converge.
  void end_with_best(PlannedStage& last) {
    const std::size_t finished = result_.stages.size();
    if (last.automatic && last.length == 0.0) find_horizon(last, finished == 0 ? kHead : result_.stages.back().segment);
    cut_into_segments(last.length, kAllSegments);
    std::vector<JudgedValues> all = others(last);
    if (finished > 0) all.push_back(judged("", result_.stages.back().values, last));
    if (!reached_.empty()) all.push_back(judged("", reached_, last));
    JudgedValues& best = *std::min_element(all.begin(), all.end(), [](const JudgedValues& a, const JudgedValues& b) {
      return a.objective() < b.objective();
    });
    for (const JudgedValues& one : all)
      if (&one != &best) count_in(one);
    if (!best.candidate.valid)
      throw TimeIsUp(task_.work.stop.reason_of_limit() + " before any values were found; give the fit more time");
    result_.stages.emplace_back();  // in whose place `take` puts the best
    best.candidate.search.converged = false;
    take(best, last);
    result_.samples = problem_->samples();
    const std::vector<double> values = space_.to_values(candidates_.front().values);
    for (std::size_t i = 0; i < values.size(); ++i) result_.values[i].value = values[i];
    result_.stopped = true;
    result_.notes.push_back(
        fmt::format("the fit did not converge: {} after {} of its stages. These are the best values so far ({:.3g} × "
                    "the sensor noise), without intervals; run the command again with more time",
                    task_.work.stop.reason_of_limit(), finished, candidates_.front().residual));
  }

  /// Where the values moved during the stages, or away from known values, tries other starts once more.
  void look_anew(const std::string& stage) {
    const AnewTask task{task_, space_, loss_, *problem_, meter_, stage};
    if (!result_.stages.empty() && moved(result_.stages.back().values, space_.to_values(candidates_.front().values))) {
      refined_ += try_all_starts(task, candidates_);
      order_candidates();
    }
    refined_ += try_known_starts(task, candidates_);
    order_candidates();
  }

  void record(const PlannedStage& planned) {
    const Candidate& best = candidates_.front();
    FitStage stage;
    stage.name = planned.name;
    stage.segment = planned.length;
    stage.segments = static_cast<int>(problem_->segments().size());
    stage.starts = refined_;
    stage.agreeing = agreeing_;
    stage.iterations = best.search.iterations;
    stage.converged = best.search.converged;
    stage.residual = best.residual;
    stage.values = space_.to_values(best.values);
    result_.stages.push_back(stage);
  }

  /// Repeats the last stage with initial states of the trials estimated under its values, if these are different.
  void settle_heads(const PlannedStage& last) {
    candidates_.resize(1);
    const std::vector<Segment> before = problem_->segments();
    cut_into_segments(last.length, kAllSegments);
    if (same_starts(before, problem_->segments())) return;
    refine_candidates(last.name + ", once more", kFine);
    result_.stages.pop_back();
    record(last);
  }

  JudgedValues judged(std::string name, const std::vector<double>& values, const PlannedStage& last) const {
    return ValueJudge{predictor_, *states_, space_, result_.noise, last.length, *problem_, search(kFine)}.judge(
        std::move(name), values);
  }

  /// The start and the results of all stages but the last, the best first, without those that cannot be simulated.
  std::vector<JudgedValues> others(const PlannedStage& last) {
    std::vector<JudgedValues> all;
    all.push_back(judged("the start values", start_values(), last));
    for (std::size_t i = 0; i + 1 < result_.stages.size(); ++i)
      all.push_back(judged("the values of " + result_.stages[i].name, result_.stages[i].values, last));
    std::stable_sort(all.begin(), all.end(),
                     [](const JudgedValues& a, const JudgedValues& b) { return a.objective() < b.objective(); });
    return all;
  }

  /// The one place where a fit's result is chosen: where the start or another stage fits better than the result of the
  /// last search, the search starts from there again; the best of all wins, as it is or refined.
  void let_best_win(const PlannedStage& last) {
    const JudgedValues found = judged("", current_values(), last);
    std::vector<JudgedValues> all = others(last);
    JudgedValues& best = all.front();
    if (best.objective() < found.objective() - kBetter) go_on_from(best, last);
    count_in(found);
    for (const JudgedValues& one : all) count_in(one);
  }

  std::vector<double> start_values() const { return as_written(task_.definition).parameters(); }

  void count_in(const JudgedValues& judged) {
    if (!judged.problem) return;
    result_.simulations += judged.problem->simulations();
    result_.invalid_simulations += judged.problem->invalid_simulations();
  }

  void go_on_from(JudgedValues& best, const PlannedStage& last) {
    meter_.add_parts(1);
    const std::vector<Candidate> refined = refine_all(*best.problem, {best.candidate.values}, watched(search(kFine)),
                                                      meter_, last.name + ", from " + best.name);
    JudgedValues further = judged(best.name, space_.to_values(refined.front().values), last);
    const bool is_further = further.objective() < best.objective();
    if (is_further) further.candidate.search.iterations = refined.front().search.iterations;
    if (is_further) further.candidate.search.converged = refined.front().search.converged;
    take(is_further ? further : best, last);
    count_in(further);
    result_.notes.push_back(fmt::format(
        "the fit may be at a local minimum: over {}, {} have a smaller error than the result of the last stage. {}. To "
        "check the result, raise fit.starts",
        last.length > 0.0 ? last.name : "whole trials", best.name,
        is_further ? fmt::format("The fit continued from these values and reached {:.3g} × the sensor noise",
                                 candidates_.front().residual)
                   : "The fit keeps these values, because a search from them found no better ones"));
  }

  void take(JudgedValues& winner, const PlannedStage& last) {
    finish_problem();
    problem_ = std::move(winner.problem);
    candidates_ = {std::move(winner.candidate)};
    problem_->set_steps(candidates_.front().steps);
    agreeing_ = 1;
    result_.stages.pop_back();
    ++refined_;
    record(last);
  }

  void judge() {
    const Candidate& best = candidates_.front();
    problem_->set_scales(best.scales);
    std::vector<bool> at_bound;
    for (Eigen::Index j = 0; j < space_.size(); ++j) at_bound.push_back(bound_side(space_, best.values, j) != 0);
    std::vector<SegmentJacobian> jacobians;
    problem_->linearize_finely(best.search.point, best.search.residuals, jacobians);
    const Uncertainty known =
        uncertainty(*problem_, space_, best.search.point, best.search.residuals, jacobians, loss_, at_bound);
    result_.cannot_tell = undetermined_sentences(known, best.search.point, space_, task_.definition.free);
    result_.correlation_time = known.correlation_time;
    result_.samples = problem_->samples();
    if (known.few_blocks)
      result_.notes.push_back(
          fmt::format("the 95 % intervals are approximate, because the trials are short. Residuals are correlated over "
                      "{:.2g} s; reliable intervals need about {:.2g} s of data",
                      known.correlation_time, known.enough_data));
    if (!best.search.converged)
      result_.notes.push_back(
          fmt::format("the last stage stopped after {} iterations without convergence; raise fit.max_iterations",
                      best.search.iterations));
    enter_values({space_, task_.definition.free, best.values, known}, result_);
    for (std::string& sentence : drift_sentences(result_.stages, result_.values, task_.definition.free))
      result_.notes.push_back(std::move(sentence));
  }

  void finish_problem() {
    if (!problem_) return;
    result_.simulations += problem_->simulations();
    result_.invalid_simulations += problem_->invalid_simulations();
    problem_.reset();
  }

  const FitTask& task_;
  ProgressMeter meter_;
  RobustLoss loss_;
  FitResult result_;
  TrialPredictor predictor_;
  ParameterSpace space_;
  std::unique_ptr<StartStates> states_;
  std::unique_ptr<ShootingProblem> problem_;
  std::vector<Candidate> candidates_;
  std::mutex reaching_;
  std::vector<double> reached_;  ///< by a search, at last
  int refined_ = 0;
  int agreeing_ = 0;
};

}  // namespace

std::vector<double> FitResult::parameters() const {
  std::vector<double> all;
  for (const FittedValue& value : values) all.push_back(value.value);
  return all;
}

FitResult fit(const FitTask& task) {
  if (task.definition.free.empty()) return as_written(task.definition);
  return Fitter(task).run();
}

FitResult as_written(const ModelDefinition& definition) {
  FitResult result;
  for (const FreeValue& free : definition.free) {
    FittedValue value;
    value.address = free.address;
    value.unit = free.unit;
    value.start = value.value = free.start;
    value.standard_error = value.lower_95 = value.upper_95 = kNotFitted;
    result.values.push_back(value);
    if (free.own)
      result.notes.push_back(fmt::format(
          "{} has no start value: it starts at {}, the end of its range, because the robot's value, {}, lies outside",
          free.address, format_quantity(free.start, free.unit), format_quantity(*free.own, free.unit)));
  }
  const auto size = static_cast<Eigen::Index>(result.values.size());
  result.covariance = Eigen::MatrixXd::Constant(size, size, kNotFitted);
  return result;
}

}  // namespace lacuna

#include "answer/find_missing_effects.h"

#include "answer/calibration.h"
#include "answer/doubted_data.h"
#include "answer/evidence.h"
#include "answer/fitted_values.h"
#include "answer/search_findings.h"
#include "answer/settling_test.h"
#include "answer/stopped_search.h"
#include "data_checks/data_checks.h"
#include "data_checks/feedback_bias.h"
#include "fitting/numerics/progress_meter.h"
#include "search/effect_search.h"

#include <algorithm>
#include <set>

namespace lacuna {
namespace {

constexpr int kSteps = 60;  ///< of a usual search

/// Candidates that no set was fitted with.
std::vector<std::string> not_examined(const DiagnosisTask& task, const SearchResult& found) {
  std::set<std::string> examined;
  for (const FittedModel& set : found.sets) examined.insert(set.judged.members.begin(), set.judged.members.end());
  std::vector<std::string> names = candidate_names(task.experiment, task.catalog, task.definition, task.among);
  std::erase_if(names, [&](const std::string& name) { return examined.contains(name); });
  return names;
}

EffectSearchTask search_task(const DiagnosisTask& task, ProgressMeter& meter) {
  EffectSearchTask search{task.experiment, task.catalog,          task.trials, task.definition.start_values(),
                          task.among,      task.work.unreported()};
  search.known = task.known;
  search.keep = task.keep;
  search.note = [&meter](const std::string& what) {
    meter.end_part();
    meter.begin_part(what);
  };
  return search;
}

/// Whether a controller made the commands. Then values identified from the recorded commands may differ from those with
/// the controller in the loop.
void look_for_feedback(const DiagnosisTask& task, const SearchResult& found, ProgressMeter& meter, Diagnosis& result) {
  if (!has_controller(task.trials)) return;
  meter.end_part();
  meter.begin_part("the controller in the loop");
  const AugmentedModel& answer = found.answer().model;
  std::vector<std::string> findings;
  try {
    findings =
        feedback_bias({answer.definition, *answer.model, task.trials, answer.experiment.fit, task.seed, task.work});
  } catch (const TimeIsUp&) {  // the answer stands
    task.work.stop.lift_limit();
    findings = {"feedback bias was not checked: the time limit was reached"};
  }
  result.findings.insert(result.findings.end(), findings.begin(), findings.end());
}

Diagnosis without_predictions(const NothingPredictable& reason) {
  Diagnosis result;
  result.findings.emplace_back(reason.what());
  return result;
}

Diagnosis diagnose(const DiagnosisTask& task, ProgressMeter& meter) {
  const SearchResult found = search_effects(search_task(task, meter));
  Diagnosis result = findings_of(found);
  if (found.stopped) {
    mark_stopped({"the search", not_examined(task, found), {}}, task.work.stop, found.sets.size(), result);
  } else {
    tell_probability(result, evidence_of(found));
    propose_settling_test(task, found, result);
    look_for_feedback(task, found, meter, result);
  }
  const std::vector<double> fitted = FittedValues(found, found.sets.front()).values();
  add_doubts(data_checks({task.definition, task.model, task.trials, fitted, true, task.work.stop}), result);
  return result;
}

}  // namespace

Diagnosis find_missing_effects(const DiagnosisTask& task) {
  if (std::all_of(task.trials.begin(), task.trials.end(), [](const Trial& trial) { return trial.held_out; }))
    throw Error(
        "no trial to diagnose: name a recorded file that is not held out; for a simulated target, make trials with "
        "lacuna trial");
  ProgressMeter meter(task.work.progress);
  meter.set_parts(kSteps);
  Diagnosis result;
  try {
    result = diagnose(task, meter);
  } catch (const NothingPredictable& reason) {
    result = without_predictions(reason);
  } catch (const TimeIsUp&) {
    task.work.stop.lift_limit();
    result = stopped_before_search(task.experiment, task.catalog, task.definition, task.among, "the fit of the model",
                                   task.work.stop);
  }
  result.effect_filter = task.among;
  result.seconds = meter.seconds();
  return result;
}

}  // namespace lacuna

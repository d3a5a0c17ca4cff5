#include "diagnosis/likelihoods/search_ending.h"

#include "diagnosis/data_checks/feedback_bias.h"
#include "diagnosis/experiment_design/propose_test.h"
#include "diagnosis/refit/jackknife.h"
#include "diagnosis/rounds/channel_errors.h"
#include "diagnosis/rounds/segment_lengths.h"
#include "diagnosis/rounds/selection.h"
#include "diagnosis/verdict/calibration.h"
#include "diagnosis/verdict/conclusion.h"
#include "diagnosis/verdict/evidence.h"
#include "diagnosis/verdict/stopped_search.h"
#include "foundation/interrupt.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

constexpr double kUnsteady = 0.5;  ///< of the probability, where an effect does not survive other segment lengths

class EndedSearch {
 public:
  explicit EndedSearch(const SearchEnding& ending)
      : ending_(ending), task_(ending.task), result_(ending.state.so_far) {}

  void run() {
    if (!ending_.state.law_leads && !ending_.answer.added.empty()) tell_rest();  // the library has the law
    judge_base();
    const auto present = [this] {
      return present_effects(ending_.plain, task_.catalog, ending_.last, task_.seed, task_.threads);
    };
    conclude(result_, {ending_.answer, first(), ending_.last, ending_.law_ahead, present, task_.seed});
    try {
      check_answer();
    } catch (const TimeIsUp&) {  // the verdict stands, without what would tell its probability
      lift_time_limit();
      mark_stopped({ending_.meter.what(), {}, {}}, ending_.state.tried.size() - 1, result_);
      return;
    }
    tell_probability(result_, evidence_of(result_, steady_), !ending_.cut.free_run);
  }

 private:
  void check_answer() {
    const auto enough = ending_.state.enough.find(names_of(ending_.answer.added));
    if (is_answer() && enough != ending_.state.enough.end()) result_.findings.push_back(enough->second);
    if (ending_.state.law_leads && is_answer() && ending_.last.free_force.p < kFreeForceLevel) tell_rest();
    if (is_answer())
      look_at_answer();
    else if (result_.verdict == Verdict::nothing_missing)
      state_values_alone();
    look_for_feedback();
  }

  BaseValues first() const { return {ending_.plain.definition.free, ending_.state.base_values}; }

  /// What the answer leaves may have a law of its own.
  void tell_rest() {
    result_.residual_force = ending_.last.free_force.curves;
    result_.formulas = ending_.last.formulas;
    result_.formulas_of_rest = true;
  }

  /// What the answer gains over the model without any effect added, both under the noise of the last round; and the
  /// errors of that model, where the answer's are about segments of another length.
  void judge_base() {
    if (ending_.answer.added.empty()) return;
    const Round& last = ending_.last;
    if (!ending_.unaided) {
      result_.answer_gain = ending_.state.gains.at(names_of(ending_.answer.added));
      return;
    }
    result_.answer_gain = ending_.unaided->behind;
    if (result_.base_segment == last.base.segment) return;
    result_.base = channel_errors(last.base, last.bins, last.noise, ending_.unaided->fit, last.folds);
    result_.base_segment = last.base.segment;
  }

  /// Whether the effects found are said to be missing, and do not only imitate something.
  bool is_answer() const {
    return !ending_.answer.added.empty() &&
           (result_.verdict == Verdict::effect_found ||
            (result_.verdict == Verdict::not_in_library && answer_comes_first(result_)));
  }

  void look_at_answer() {
    ending_.meter.add_parts(1);
    ending_.meter.begin_part("other lengths of segments");
    const Refit wary = wary_fit();
    state_values(wary);
    change_lengths(wary);
    if (result_.verdict == Verdict::effect_found) propose();
    ending_.meter.end_part();
  }

  /// The last round's fit, with a covariance that errors of the model widen.
  Refit wary_fit() const {
    Refit fit = ending_.last.fit;
    fit.covariance = wary_covariance(fit, ending_.last.folds);
    return fit;
  }

  /// What does not survive a change of segment length is less likely to be the answer.
  void change_lengths(const Refit& fit) {
    result_.lengths = refit_at_lengths(
        {{task_.definition, task_.model, task_.trials, task_.values, ending_.last.base.segment, task_.threads},
         ending_.answer,
         ending_.last,
         fit,
         task_.threads});
    const LengthVerdict verdict =
        judge_lengths(result_.ranking.front().effects, ending_.last.base.segment, result_.lengths, task_.catalog);
    if (!verdict.survives) result_.probability *= kUnsteady;
    steady_ = verdict.survives;
    result_.findings.insert(result_.findings.end(), verdict.findings.begin(), verdict.findings.end());
  }

  /// Of the answer's effects and the model beside them.
  void state_values(const Refit& fit) {
    const Contender& answer = ending_.answer;
    result_.values = own_values(answer.added, answer.definition, fit);
    result_.ranking.front().effects = found_effects(answer.added, answer.definition, fit);
  }

  /// Of the model without what was found, if anything was, for it only makes up for a form.
  void state_values_alone() {
    if (ending_.answer.added.empty())
      result_.values = own_values({}, ending_.plain.definition, wary_fit());
    else if (ending_.unaided)
      result_.values = own_values({}, ending_.plain.definition, ending_.unaided->fit);
  }

  /// The test that would tell the answer from what looks most like it.
  void propose() {
    if (ending_.again.inseparable.empty()) return;
    const SearchStep& step = *ending_.state.last;
    const auto& [which, fit] = ending_.again.inseparable.front();
    const KeptRival& alike = step.rivals[which];
    const Contender other = with_effect_of(alike, step, ending_.plain, task_.catalog);
    state_next_test(
        propose_test(
            task_.catalog, task_.experiment,
            {name_of(step.rivals[step.chosen].entry), ending_.answer.definition, ending_.last.fit},
            {name_of(alike.entry), other.definition, fit}, ending_.last.base.trials,
            [&](double period) { return like_the_trials(ending_.last, period); }, task_.seed, task_.threads),
        result_);
  }

  /// Whether a controller made the commands so that what is identified from them is another than with it in the loop.
  void look_for_feedback() {
    if (!has_controller(task_.trials)) return;
    ending_.meter.add_parts(1);
    ending_.meter.begin_part("the controller in the loop");
    const std::vector<std::string> findings =
        feedback_bias({ending_.answer.definition, *ending_.answer.model, task_.trials, ending_.answer.experiment.fit,
                       task_.seed, task_.threads});
    result_.findings.insert(result_.findings.end(), findings.begin(), findings.end());
    ending_.meter.end_part();
  }

  const SearchEnding& ending_;
  const DiagnosisTask& task_;
  Diagnosis& result_;
  bool steady_ = true;  ///< the answer, at other lengths of segments
};

}  // namespace

void end_search(const SearchEnding& ending) { EndedSearch(ending).run(); }

}  // namespace lacuna

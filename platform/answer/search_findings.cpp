#include "answer/search_findings.h"

#include "foundation/statistics.h"
#include "answer/bound_findings.h"
#include "answer/errors_by_length.h"
#include "answer/evidence.h"
#include "answer/fitted_values.h"
#include "answer/held_out_finding.h"
#include "foundation/unit.h"
#include "residual_law/joint_laws.h"
#include "residual_law/missing_force.h"
#include "residual_law/residual_law.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace lacuna {
namespace {

constexpr std::size_t kMostRanked = 8;
constexpr double kAboveFloor = 3.0;  ///< of the model's error: a larger error with the answer cannot be sensor noise
constexpr double kFarAboveFloor = 20.0;  ///< of the model's error: a candidate with a larger error cannot be right
constexpr double kMostLeft = 0.25;       ///< of the total gain: what a law without an effect may gain beside an answer
constexpr double kBeyond = kWithin95;    ///< standard errors
constexpr double kMoved = 2.0;           ///< standard errors
constexpr double kNoticeable = 0.01;     ///< of a value
constexpr double kOffTime = 0.1;         ///< command intervals
constexpr double kLongEnough = 0.3;      ///< of the longest trial

double longest_trial(const std::vector<Trial>& trials) {
  double longest = 0.0;
  for (const Trial& trial : trials)
    if (!trial.held_out)
      longest = std::max(longest, trial.measured.times(trial.measured.times.size() - 1) - trial.measured.times(0));
  return longest;
}

double norm(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).norm();
}

class Told {
 public:
  explicit Told(const SearchResult& found) : found_(found), base_(found.sets.front()), answer_(found.answer()) {
    if (found.stopped) return;
    const FittedModel& best = found.spread ? *found.spread : found.sets[found.decision.best];
    law_ = lacking_ = ResidualLaws(found, best).best();
    if (!has_answer()) return;
    const ResidualLaws of_model(found, base_);
    const ResidualLaw instead = of_model.best(&best);
    if (is_more_than_remainder(instead) && !(is_more_than_remainder(law_) && law_.share > instead.share))
      law_ = lacking_ = instead;
    else if (ResidualLaw lacking; ends_library() && (lacking = of_model.best()).is_present)
      lacking_ = std::move(lacking);
  }

  Diagnosis diagnosis() const {
    const ErrorsByLength of_base(*found_.data, base_), of_answer(*found_.data, answer_);
    Diagnosis result;
    result.method = DiagnosisMethod::prediction;
    result.hypotheses = found_.hypotheses;
    result.untestable = found_.untestable;
    result.horizons = errors_by_horizon(*found_.data, of_base, of_answer);
    result.base = of_base.longest();
    result.base_segment = of_base.longest_length();
    result.base_times_floor = of_base.times_floor();
    result.verdict = verdict(result.base_times_floor);
    result.p_by_chance = found_.decision.p;
    result.values = FittedValues(found_, answer_).own();
    for (const FittedModel* set : shown())
      result.ranking.push_back(ranked(*set, set == &answer_ ? of_answer : ErrorsByLength(*found_.data, *set)));
    tell_law(result);
    if (has_answer()) {
      result.ranking.front().look_alikes = look_alikes_of(found_);
      result.answer_gain = result.ranking.front().gain;
    }
    result.findings = sentences(result);
    return result;
  }

 private:
  bool has_answer() const { return found_.decision.answer != 0; }

  static bool is_more_than_remainder(const ResidualLaw& law) {
    return law.is_present && law.share > kMostLeft && !law.is_minor;
  }

  /// Whether the force that no effect explains is more than a small rest beside an answer.
  bool ends_library() const { return has_answer() ? is_more_than_remainder(law_) : law_.is_present; }

  Verdict verdict(double base_times_floor) const {
    if (ends_library()) return Verdict::not_in_library;
    if (has_answer()) return Verdict::effect_found;
    return found_.stopped || base_times_floor > kFarAboveFloor ? Verdict::cannot_tell : Verdict::nothing_missing;
  }

  /// The answer, if it has effects, then the other sets with effects, the largest gain first.
  std::vector<const FittedModel*> shown() const {
    std::vector<const FittedModel*> sets;
    for (const FittedModel& set : found_.sets)
      if (&set != &base_ && &set != &found_.sets[found_.decision.answer]) sets.push_back(&set);
    std::stable_sort(sets.begin(), sets.end(), [](const FittedModel* a, const FittedModel* b) {
      return a->judged.cost.cost < b->judged.cost.cost;
    });
    if (has_answer()) sets.insert(sets.begin(), &answer_);
    sets.resize(std::min(sets.size(), kMostRanked));
    return sets;
  }

  RankedModel ranked(const FittedModel& set, const ErrorsByLength& errors) const {
    return {.effects = FittedValues(found_, set).effects(),
            .look_alikes = {},
            .gain = in_nats(gain_of(set.judged, base_.judged)),
            .errors = errors.longest(),
            .times_floor = errors.times_floor(),
            .segment = errors.longest_length()};
  }

  std::vector<std::string> sentences(const Diagnosis& result) const {
    std::vector<std::string> all;
    const auto add = [&](std::string text) {
      if (!text.empty()) all.push_back(std::move(text));
    };
    if (result.verdict == Verdict::effect_found) add(held_out_finding(result.horizons));
    if (has_answer()) {
      add(absorbed(result.values));
      if (found_.by_all_lengths)
        add("only the longest predictions show the effect; shorter ones are as good without it");
    }
    add(left(result));
    add(idle());
    if (result.verdict == Verdict::nothing_missing && result.base_times_floor > kAboveFloor)
      add(
          fmt::format("predictions are off by {:.3g} × floor, more than sensor noise explains. No effect of the "
                      "library and no law of the joints' motion lowers this error on data to which it was not fitted. "
                      "Random forces or an unrecorded influence would look like this",
                      result.base_times_floor));
    if (result.verdict == Verdict::cannot_tell && !found_.stopped)
      add(
          fmt::format("predictions are off by {:.3g} × floor. No effect of the library and no law of the joints' "
                      "motion lowers this error on data to which it was not fitted, so these recordings do not show "
                      "what is missing; record other commands, initial states or loads",
                      result.base_times_floor));
    for (std::string& text : bound_findings(answer_.model.definition.free, result.values)) add(std::move(text));
    add(off_time());
    add(unread());
    add(reach(result.base_segment));
    return all;
  }

  /// Where the library is not enough: the law of all that the model lacks; else: of what the answer leaves unexplained.
  void tell_law(Diagnosis& result) const {
    result.residual_force = lacking_.curves;
    result.formulas = lacking_.formulas;
    if (result.verdict == Verdict::effect_found && !found_.stopped) result.missing_force = missing_force(found_);
    if (law_.is_present) result.unexplained = {lacking_.joint, lacking_.kind, law_.share, in_nats(law_.gain)};
  }

  /// The force that no effect of the library explains.
  std::string left(const Diagnosis& result) const {
    if (!law_.is_present) return "";
    const std::string where = "joint." + lacking_.joint;
    if (!has_answer() && !found_.data->task().among.empty())
      return fmt::format(
          "no effect that was tried describes the missing force on {}. The force depends on {}. Leave --among out to "
          "try all effects",
          where, lacking_.kind);
    if (!has_answer())
      return fmt::format("no effect of the library describes the missing force on {}. The force depends on {}", where,
                         lacking_.kind);
    if (ends_library())
      return fmt::format(
          "no effect of the library describes the missing force on {}. The force depends on {}. With the best effects, "
          "{:.0f} % of the possible gain remains",
          where, lacking_.kind, 100.0 * law_.share);
    const char* form =
        has_another_form(result) ? ". The answer does, too, so its law probably has another formula" : "";
    return fmt::format(
        "with the answer, {:.0f} % of the possible gain remains: an unexplained force on {} depends on {}{}",
        100.0 * law_.share, where, law_.kind, form);
  }

  /// Effects that are no part of the answer because their intervals include values without effect.
  std::string idle() const {
    const std::set<std::string>& names = found_.decision.idle;
    if (names.empty()) return "";
    return fmt::format(
        "{} beside the answer lowers the error further, but the 95 % interval of its value includes the value without "
        "effect, so it may be no effect; record longer, or a motion that shows it more",
        fmt::join(names, " or "));
  }

  /// Whether the remaining force depends on the same quantity over which the answer explains most of the missing force.
  bool has_another_form(const Diagnosis& result) const {
    return std::any_of(result.missing_force.begin(), result.missing_force.end(), [&](const ForceCurve& curve) {
      return curve.joint == law_.joint && curve.of == law_.kind && 2.0 * norm(curve.by_answer) > norm(curve.force);
    });
  }

  /// The model's own values that the answer changes.
  std::string absorbed(const std::vector<FoundParameter>& now) const {
    std::vector<std::string> moved;
    for (const FoundParameter& before : FittedValues(found_, base_).own())
      for (const FoundParameter& after : now) {
        const double by = std::abs(after.value - before.value);
        const double error = (after.upper_95 - after.lower_95) / (2.0 * kBeyond);  // NaN: not told
        if (after.name == before.name && by > kMoved * error && by > kNoticeable * std::abs(after.value))
          moved.push_back(fmt::format("{} ({})", after.name, format_change(before.value, after.value, after.unit)));
      }
    return moved.empty() ? "" : fmt::format("without the answer, {} had absorbed the effect", fmt::join(moved, ", "));
  }

  /// Beyond this offset a user who simulates with the recorded commands sees an error from it.
  std::string off_time() const {
    const FittedValues values(found_, answer_);
    const std::optional<double> timing = values.timing();
    if (!timing || !values.timing_is_told() || std::abs(*timing) < kOffTime) return "";
    return fmt::format(
        "timestamp offset: commands act {} earlier than recorded. This fit corrects it; compare and trial do not. To "
        "correct it there, shift the times of the commands by as much",
        format_quantity(std::abs(*timing) * longest_command_interval(found_.data->task().trials), "s"));
  }

  std::string unread() const {
    const std::vector<std::string> missing = found_.data->starts().states().unmeasured(0);
    if (missing.empty()) return "";
    return fmt::format("{} has no measured position, so predictions can begin only at the start of a recording",
                       fmt::join(missing, ", "));
  }

  std::string reach(double longest) const {
    const double whole = longest_trial(found_.data->task().trials);
    if (!(longest > 0.0) || longest > kLongEnough * whole) return "";
    return fmt::format(
        "the longest predictions are {:.2g} s (recordings: {:.3g} s), because in longer predictions the uncertainty of "
        "the initial state exceeds a quarter of the motion. Slower effects (a drift, warming, a clock error) cannot be "
        "detected",
        longest, whole);
  }

  const SearchResult& found_;
  const FittedModel& base_;
  const FittedModel& answer_;
  ResidualLaw law_;      ///< fitted beside the answer or the best set, or without either
  ResidualLaw lacking_;  ///< the same, but of the model as it is where the library is not enough
};

}  // namespace

Diagnosis findings_of(const SearchResult& found) { return Told(found).diagnosis(); }

}  // namespace lacuna

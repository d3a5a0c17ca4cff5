#include "diagnosis/verdict/conclusion.h"

#include "diagnosis/residual_force/random_force.h"
#include "diagnosis/rounds/channel_errors.h"
#include "diagnosis/rounds/ranking.h"
#include "diagnosis/rounds/selection.h"
#include "diagnosis/verdict/unexplained_motion.h"
#include "diagnosis/verdict/verdict_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>

namespace lacuna {
namespace {

constexpr double kCounts = 1e-3;  ///< of the stronger force's power

/// Quick and slow ones of each joint, but for those that do next to nothing beside the other.
std::vector<RandomForce> random_forces(const Round& round) {
  using Kind = NoiseComponent::Kind;
  std::vector<RandomForce> forces;
  std::map<std::string, double> most;
  for (const NoiseComponent& one : round.noise.components()) {
    if (one.kind != Kind::force && one.kind != Kind::slow_force) continue;
    forces.push_back({"joint." + round.forces.joints[one.index], round.forces.units[one.index], one.deviation,
                      one.kind == Kind::force ? round.forces.width : kSlowForce, one.kind == Kind::slow_force});
    double& largest = most[forces.back().joint];
    largest = std::max(largest, power(forces.back()));
  }
  std::erase_if(forces, [&](const RandomForce& force) { return power(force) < kCounts * most[force.joint]; });
  return forces;
}

double best_further(const Round& last) { return last.rivals.empty() ? 0.0 : last.rivals.front().gain.value; }

/// What the search tells; whether it is a form alone, and what motion is missed, is not asked yet.
VerdictFigures figures_of_search(const Diagnosis& diagnosis, const SearchOutcome& outcome) {
  const Round& last = outcome.last;
  VerdictFigures figures;
  figures.has_answer = !outcome.answer.added.empty();
  figures.outdone = outcome.law_ahead.has_value();
  figures.law_ahead = with_range(outcome.law_ahead.value_or(0.0));
  figures.answer_share = share_with_range(gained(diagnosis.answer_gain), gained(diagnosis.free_force_gain));
  figures.structure_p = {last.free_force.p, last.free_force.p_low, last.free_force.p_high};
  const Gain answer = diagnosis.answer_gain.value_or(Gain());
  figures.structure_gain =
      lower_with_range(diagnosis.free_force_gain.value_or(Gain()), std::max(0.0, best_further(last)));
  figures.answer_gain = with_range(answer.value);
  figures.answer_lower = lower_with_range(answer);
  figures.chance_p = {last.screening.p, last.screening.p_low, last.screening.p_high};
  return figures;
}

/// What is found, or left, may only make up for the form of what the model has: nothing is missing then, and a sentence
/// says so.
std::string judge_form(Diagnosis& diagnosis, const SearchOutcome& outcome, VerdictFigures& figures) {
  if (diagnosis.verdict == Verdict::nothing_missing) return "";
  const std::optional<PresentEffects> explained = outcome.present();
  if (!explained || !(explained->gain.lower_95 > 0.0)) return "";
  const PresentEffects& present = *explained;
  const double further =
      std::max({gained(diagnosis.answer_gain), gained(diagnosis.free_force_gain), best_further(outcome.last)});
  figures.may_be_form = true;
  figures.form_share = with_range(further / present.gain.value);
  figures.base_error = with_range(diagnosis.base_times_floor, kLastDigitsOfError);
  if (!is_form_only(figures)) return "";
  diagnosis.verdict = Verdict::nothing_missing;
  diagnosis.form_only = true;
  const double share = further / present.gain.value;
  diagnosis.probability = 1.0 - share;
  return fmt::format(
      "what is left to be gained, {:.1f} nats, is {:.2g} % of what {} explain{}: it more likely makes up for {} form, "
      "and the model is at the floor without it",
      further, 100.0 * share, fmt::join(present.names, " and "), present.names.size() == 1 ? "s" : "",
      present.names.size() == 1 ? "its" : "their");
}

void cannot_tell(Diagnosis& diagnosis) {
  diagnosis.verdict = Verdict::cannot_tell;
  diagnosis.probability = std::numeric_limits<double>::quiet_NaN();
}

/// Of the last effect the ranking says itself what it is not told from now.
bool is_about_earlier(const std::string& finding, const std::vector<EffectEntry>& added) {
  return !added.empty() && std::any_of(added.begin(), added.end() - 1, [&](const EffectEntry& entry) {
    return finding.starts_with(name_of(entry) + " ");
  });
}

/// The floor is that of the first or the last round: the one in which less that is structured passes for noise. Models
/// that were judged over segments of another length keep the floor of that length.
void measure_by(std::vector<ChannelError> floors, double segment, Diagnosis& diagnosis) {
  const bool as_long = diagnosis.base_segment == segment;
  for (std::size_t c = 0; as_long && c < floors.size(); ++c)
    floors[c].floor = std::min(floors[c].floor, diagnosis.base[c].floor);
  const auto take_floor = [&](std::vector<ChannelError>& errors) {
    for (std::size_t c = 0; c < errors.size(); ++c) errors[c].floor = floors[c].floor;
    return times_floor(errors);
  };
  diagnosis.base_times_floor = as_long ? take_floor(diagnosis.base) : times_floor(diagnosis.base);
  for (RankedModel& model : diagnosis.ranking)
    model.times_floor = model.segment == segment ? take_floor(model.errors) : times_floor(model.errors);
}

}  // namespace

void conclude(Diagnosis& diagnosis, const SearchOutcome& outcome) {
  const Contender& answer = outcome.answer;
  const Round& last = outcome.last;
  const std::vector<ChannelError> errors = channel_errors(last.base, last.bins, last.noise, last.fit, last.folds);
  if (answer.added.empty()) {
    diagnosis.ranking = ranking_of(answer, last, std::nullopt, {}, outcome.seed);
  } else {
    diagnosis.ranking.front().effects = found_effects(answer.added, answer.definition, last.fit);
    diagnosis.ranking.front().errors = errors;
    diagnosis.ranking.front().segment = last.base.segment;
  }
  diagnosis.forces = random_forces(last);
  if (last.free_force.freedom > 0) {  // else no force could be tested
    diagnosis.free_force_p = last.free_force.p;
    diagnosis.free_force_gain = gain(last.held_out, last.free_force.held_out, outcome.seed);
  }
  measure_by(errors, last.base.segment, diagnosis);
  VerdictFigures figures = figures_of_search(diagnosis, outcome);
  diagnosis.verdict = verdict_of_search(figures);
  weigh(diagnosis);
  const std::string about_form = judge_form(diagnosis, outcome, figures);
  const std::vector<std::string> unexplained = unexplained_motion(last.base, errors);
  figures.missed_motion = with_range(missed_motion(last.base, errors), kLastDigitsOfError);
  if (verdict_of(figures) != diagnosis.verdict) cannot_tell(diagnosis);
  diagnosis.at_threshold = at_thresholds(figures);
  const bool structure_left = last.free_force.p < kFreeForceLevel;
  if (diagnosis.verdict != Verdict::not_in_library && !(diagnosis.verdict == Verdict::effect_found && structure_left)) {
    diagnosis.residual_force.clear();
    diagnosis.formulas.clear();
  }
  std::vector<std::string> classes = std::move(diagnosis.findings);
  std::erase_if(classes, [&](const std::string& text) { return !is_about_earlier(text, answer.added); });
  diagnosis.findings = findings_of(diagnosis, outcome.first, answer, last);
  diagnosis.findings.insert(diagnosis.findings.begin(), unexplained.begin(), unexplained.end());
  if (!about_form.empty()) diagnosis.findings.insert(diagnosis.findings.begin(), about_form);
  diagnosis.findings.insert(diagnosis.findings.end(), classes.begin(), classes.end());
}

}  // namespace lacuna

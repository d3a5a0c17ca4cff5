#include "diagnosis/conclusion.h"

#include "diagnosis/channel_errors.h"
#include "diagnosis/ranking.h"
#include "diagnosis/selection.h"
#include "diagnosis/unexplained_motion.h"

#include <algorithm>
#include <map>

namespace lacuna {
namespace {

constexpr double kCounts = 1e-3;  ///< of the stronger force's power

/// Of what a force does to a motion, roughly: its power at low frequencies.
double power_of(const RandomForce& force) { return force.deviation * force.deviation * force.duration; }

/// Quick and slow ones of each joint, but for those that do next to nothing beside the other.
std::vector<RandomForce> random_forces(const Round& round) {
  using Kind = NoiseComponent::Kind;
  std::vector<RandomForce> forces;
  std::map<std::string, double> most;
  for (const NoiseComponent& one : round.noise.components()) {
    if (one.kind != Kind::force && one.kind != Kind::slow_force) continue;
    forces.push_back({"joint." + round.forces.joints[one.index], round.forces.units[one.index], one.deviation,
                      one.kind == Kind::force ? round.forces.width : kSlowForce});
    double& largest = most[forces.back().joint];
    largest = std::max(largest, power_of(forces.back()));
  }
  std::erase_if(forces, [&](const RandomForce& force) { return power_of(force) < kCounts * most[force.joint]; });
  return forces;
}

Verdict verdict_of(const Diagnosis& diagnosis, const Contender& contender, const Round& last) {
  const double best = last.rivals.empty() ? 0.0 : last.rivals.front().gain.value;
  const double free = diagnosis.free_force_gain.lower_95;
  const bool is_law = diagnosis.free_force_p < kFreeForceLevel && free > std::max(0.0, best);
  if (is_law && (contender.added.empty() || !answer_is_most(diagnosis))) return Verdict::not_in_library;
  if (!contender.added.empty()) return Verdict::effect_found;
  return last.screening.p <= kFirstLevel ? Verdict::cannot_tell : Verdict::nothing_missing;
}

bool is_about(const std::string& finding, const std::vector<EffectEntry>& added) {
  return std::any_of(added.begin(), added.end(),
                     [&](const EffectEntry& entry) { return finding.starts_with(name_of(entry) + " "); });
}

/// The floor is that of the first or the last round: the one in which less that is structured passes for noise.
void measure_by(std::vector<ChannelError> floors, Diagnosis& diagnosis) {
  for (std::size_t c = 0; c < floors.size(); ++c) floors[c].floor = std::min(floors[c].floor, diagnosis.base[c].floor);
  const auto take_floor = [&](std::vector<ChannelError>& errors) {
    for (std::size_t c = 0; c < errors.size(); ++c) errors[c].floor = floors[c].floor;
    return times_floor(errors);
  };
  diagnosis.base_times_floor = take_floor(diagnosis.base);
  for (RankedModel& model : diagnosis.ranking) model.times_floor = take_floor(model.errors);
}

}  // namespace

void conclude(Diagnosis& diagnosis, const Contender& contender, const BaseValues& first, const Round& last,
              bool outdone_by_law, std::uint64_t seed) {
  const std::vector<ChannelError> errors = channel_errors(last.base, last.bins, last.noise, last.fit, last.folds);
  if (contender.added.empty()) {
    diagnosis.ranking = ranking_of(contender, last, std::nullopt, {}, seed);
  } else {
    diagnosis.ranking.front().effects = found_effects(contender.added, contender.definition, last.fit);
    diagnosis.ranking.front().errors = errors;
  }
  diagnosis.forces = random_forces(last);
  diagnosis.free_force_p = last.free_force.p;
  diagnosis.free_force_gain = gain(last.held_out, last.free_force.held_out, seed);
  diagnosis.verdict = outdone_by_law ? Verdict::not_in_library : verdict_of(diagnosis, contender, last);
  const std::vector<std::string> unexplained = unexplained_motion(last.base, errors);
  if (diagnosis.verdict == Verdict::nothing_missing && !unexplained.empty()) diagnosis.verdict = Verdict::cannot_tell;
  const bool structure_left = diagnosis.free_force_p < kFreeForceLevel;
  if (diagnosis.verdict != Verdict::not_in_library && !(diagnosis.verdict == Verdict::effect_found && structure_left)) {
    diagnosis.residual_force.clear();
    diagnosis.formulas.clear();
  }
  measure_by(errors, diagnosis);
  weigh(diagnosis);
  std::vector<std::string> classes = std::move(diagnosis.findings);
  std::erase_if(classes, [&](const std::string& text) { return !is_about(text, contender.added); });
  diagnosis.findings = findings_of(diagnosis, first, contender, last);
  diagnosis.findings.insert(diagnosis.findings.begin(), unexplained.begin(), unexplained.end());
  diagnosis.findings.insert(diagnosis.findings.end(), classes.begin(), classes.end());
}

}  // namespace lacuna

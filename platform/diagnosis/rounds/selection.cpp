#include "diagnosis/rounds/selection.h"

#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kBeyond = 1.959963984540054;  ///< of a normal distribution, 95 % lie within
/// Share of the gain that is no reason for a model with more parameters: the noise is not quite as it is modelled, and
/// an effect that a simple one stands for is found by a further round.
constexpr double kAsGood = 0.1;
/// Share of the best gain from which on a simpler effect is tried first: two of them may do what a richer one does, and
/// the next round judges that (rejudge.h).
constexpr double kSimpleFirst = 0.5;
constexpr double kSomething = 0.5;      ///< nats: what an effect must predict better, to be one
constexpr double kTold = 2.0;           ///< nats: less does not tell two effects apart
constexpr double kSaysSomething = 0.9;  ///< of the deviation of a value anywhere within its bounds

std::size_t freedom(const Round& round, const Rival& rival) { return round.hypotheses[rival.hypothesis].own.size(); }

/// How sure it is that a gain is one at all, blocks of data being drawn at random.
double above_zero(const Gain& gain) {
  if (gain.standard_error <= 0.0) return gain.value > 0.0 ? 1.0 : 0.0;
  return 0.5 * std::erfc(-gain.value / gain.standard_error / std::numbers::sqrt2);
}

/// The best of the rivals with fewer parameters than `chosen` that still has a good part of the best gain.
std::size_t simpler_first(const Round& round, std::size_t chosen) {
  const double enough = kSimpleFirst * round.rivals.front().gain.value;
  for (std::size_t i = 0; i < round.rivals.size(); ++i)  // the largest gain first
    if (freedom(round, round.rivals[i]) < freedom(round, round.rivals[chosen]) &&
        round.rivals[i].gain.value >= enough && round.rivals[i].gain.lower_95 > 0.0)
      return i;
  return chosen;
}

bool is_of_sensor(const Round& round, const Rival& rival) {
  return round.hypotheses[rival.hypothesis].where().starts_with("sensor.");
}

/// A late sensor and a late drive show the same readings of a rig that rests before: where the data do not tell them
/// apart, no sensor is blamed for what the rig may do.
std::size_t rig_before_sensor(const Round& round, std::size_t chosen) {
  if (!is_of_sensor(round, round.rivals[chosen])) return chosen;
  for (std::size_t i = 0; i < round.rivals.size(); ++i)
    if (!is_of_sensor(round, round.rivals[i]) &&
        freedom(round, round.rivals[i]) <= freedom(round, round.rivals[chosen]) &&
        round.rivals[i].gain.value >= round.rivals[chosen].gain.value - kTold)
      return i;
  return chosen;
}

/// Probes may miss what a refit finds, where an effect has several parameters: then that there is something to be
/// explained is shown by the force of any form.
bool explains_structure(const Round& round, const Rival& rival) {
  return round.free_force.p < kFreeForceLevel && rival.gain.lower_95 > 0.0;
}

/// A free value and its interval, which has no ends at a bound and where the data tell nothing.
FoundParameter fitted(const ModelDefinition& definition, const Refit& fit, std::size_t value, const std::string& name) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  const ParameterSpace space(definition.free);
  const auto j = static_cast<Eigen::Index>(value);
  FoundParameter parameter{name, definition.free[value].unit, fit.values[value], kNothing, kNothing};
  const double deviation = std::sqrt(fit.covariance(j, j));
  const double at = space.to_coordinate(j, fit.values[value]);
  const double untold = (space.upper()(j) - space.lower()(j)) / std::sqrt(12.0);  // anywhere within its bounds
  if (!fit.at_bound[value] && deviation > 0.0 && deviation < kSaysSomething * untold) {
    parameter.lower_95 = space.to_value(j, std::max(space.lower()(j), at - kBeyond * deviation));
    parameter.upper_95 = space.to_value(j, std::min(space.upper()(j), at + kBeyond * deviation));
  }
  return parameter;
}

}  // namespace

std::optional<std::size_t> choose(const Round& round, double level) {
  if (round.rivals.empty()) return std::nullopt;
  const Rival& best = round.rivals.front();
  if (round.screening.p > level && !explains_structure(round, best)) return std::nullopt;
  if (best.gain.value <= kSomething) return std::nullopt;
  // Errors of one block of a free run are in the next, too: the score's chance counts them as more than they are.
  if (round.base.free_run && best.gain.lower_95 <= 0.0) return std::nullopt;
  std::size_t chosen = 0;
  for (std::size_t i = 1; i < round.rivals.size(); ++i) {
    const Gain behind = gain(round.rivals[i].held_out, best.held_out, 1);
    if (behind.value <= std::max(behind.standard_error, kAsGood * best.gain.value) &&
        round.rivals[i].gain.value > 0.0 && freedom(round, round.rivals[i]) < freedom(round, round.rivals[chosen]))
      chosen = i;
  }
  return rig_before_sensor(round, simpler_first(round, chosen));
}

std::vector<std::size_t> inseparable(const Round& round, std::size_t chosen, std::uint64_t seed) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < round.rivals.size() && others.size() < kMostLookAlikes; ++i) {
    if (i == chosen) continue;
    const Gain ahead = gain(round.rivals[i].held_out, round.rivals[chosen].held_out, seed);
    if (ahead.lower_95 <= 0.0 || ahead.value < kTold) others.push_back(i);
  }
  return others;
}

std::vector<FoundEffect> found_effects(const std::vector<EffectEntry>& added, const ModelDefinition& definition,
                                       const Refit& fit) {
  std::vector<FoundEffect> effects;
  for (const EffectEntry& entry : added) {
    FoundEffect effect{entry.effect, entry.where.empty() ? "world" : entry.where.front(), {}};
    const std::size_t name_begins = effect_address(entry.id, "").size();
    for (std::size_t i = 0; i < definition.free.size(); ++i)
      if (is_of_effect(definition.free[i].address, entry.id))
        effect.parameters.push_back(fitted(definition, fit, i, definition.free[i].address.substr(name_begins)));
    effects.push_back(std::move(effect));
  }
  return effects;
}

std::vector<FoundParameter> own_values(const std::vector<EffectEntry>& added, const ModelDefinition& definition,
                                       const Refit& fit) {
  std::vector<FoundParameter> values;
  for (std::size_t i = 0; i < definition.free.size(); ++i) {
    const std::string& address = definition.free[i].address;
    const bool is_own = std::none_of(added.begin(), added.end(),
                                     [&](const EffectEntry& entry) { return is_of_effect(address, entry.id); });
    if (is_own) values.push_back(fitted(definition, fit, i, address));
  }
  return values;
}

Gain sum(const Gain& a, const Gain& b) {
  const double value = a.value + b.value;
  const double error = std::hypot(a.standard_error, b.standard_error);
  if (a.standard_error == 0.0) return b;
  return {value, error, value - kBeyond * error, value + kBeyond * error};
}

void weigh(Diagnosis& diagnosis) {
  double most = 0.0;
  for (const RankedModel& model : diagnosis.ranking) most = std::max(most, model.gain.value);
  double total = std::exp(-most);
  for (const RankedModel& model : diagnosis.ranking) total += std::exp(model.gain.value - most);
  for (RankedModel& model : diagnosis.ranking) model.probability = std::exp(model.gain.value - most) / total;
  switch (diagnosis.verdict) {
    case Verdict::nothing_missing: diagnosis.probability = std::sqrt(diagnosis.p_by_chance.value_or(1.0)); break;
    case Verdict::effect_found:
      diagnosis.probability = std::min(1.0 - std::exp(-most) / total, above_zero(diagnosis.ranking.front().gain));
      break;
    case Verdict::not_in_library: diagnosis.probability = 1.0 - diagnosis.free_force_p.value_or(1.0); break;
    case Verdict::cannot_tell: diagnosis.probability = std::numeric_limits<double>::quiet_NaN(); break;
  }
}

}  // namespace lacuna

#include "contacts/contact_strength.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr double kSmallest = 1e-3, kLargest = 30.0;  ///< sizes that are tried
constexpr int kMostTries = 7;
constexpr double kClose = 0.08;     ///< of the wanted strength
constexpr double kBeyond = 1e3;     ///< the strength of a robot that falls to pieces
constexpr double kFirstStep = 0.2;  ///< of the refit's logarithmic search
constexpr double kEnough = 0.01;
constexpr double kFarthest = 0.9;  ///< from the nominal value, logarithm

double cost(const ContactRig& rig, const ContactLeft& left) {
  double sum = 0.0;
  for (std::size_t c = 0; c < left.rms.size(); ++c)
    if (!rig.channels[c].touch()) sum += std::pow(left.rms[c] / rig.channels[c].noise, 2);
  return sum;
}

/// With the free value given; beyond all bounds where the engine gives up.
ContactLeft left_by(const ContactRig& rig, const EngineModel& base, double free_value,
                    const std::vector<ContactTrial>& trials) try {
  ContactLeft left{free_value, std::vector<double>(rig.channels.size(), 0.0)};
  for (const ContactTrial& trial : trials) {
    const Samples predicted = base.readings(free_value, trial.commands, rig.interval);
    for (std::size_t c = 0; c < predicted.size(); ++c)
      for (std::size_t k = 0; !rig.channels[c].touch() && k < predicted[c].size(); ++k)
        left.rms[c] += std::pow(predicted[c][k] - trial.readings[c][k], 2);
  }
  const double rows = static_cast<double>(trials.size()) * rig.samples();
  for (double& value : left.rms) value = std::sqrt(value / rows);
  return left;
} catch (const std::runtime_error&) {
  return {free_value, std::vector<double>(rig.channels.size(), std::numeric_limits<double>::infinity())};
}

}  // namespace

ContactLeft left_by_refitted(const ContactRig& rig, const EngineModel& base, const std::vector<ContactTrial>& trials) {
  const auto at = [&](double place) { return left_by(rig, base, rig.nominal * std::exp(place), trials); };
  double place = 0.0, step = kFirstStep;
  ContactLeft best = at(place);
  // A walk that halves its stride where neither side is better: impacts make the cost too rough for derivatives.
  while (step > kEnough) {
    bool better = false;
    for (const double side : {step, -step}) {
      if (std::abs(place + side) > kFarthest) continue;
      ContactLeft other = at(place + side);
      if (cost(rig, other) >= cost(rig, best)) continue;
      best = std::move(other);
      place += side;
      better = true;
      break;
    }
    if (!better) step *= 0.5;
  }
  if (!std::isfinite(cost(rig, best))) throw std::runtime_error("the engine cannot predict these trials");
  return best;
}

double strength_of(const ContactLeft& left, const ContactLeft& floor) {
  double sum = 0.0, channels = 0.0;
  for (std::size_t c = 0; c < left.rms.size(); ++c) {
    if (floor.rms[c] <= 0.0) continue;
    sum += std::pow(left.rms[c] / floor.rms[c], 2);
    channels += 1.0;
  }
  return std::sqrt(sum / channels);
}

double value_of_strength(const ContactLaw& law, double wanted,
                         const std::function<double(const SizedContactLaw&)>& strength_with) {
  const double added = std::sqrt(wanted * wanted - 1.0);  // grows about in proportion to the size
  double low = kSmallest, high = kLargest, size = 1.0;
  double best = size, best_miss = kBeyond;
  for (int i = 0; i < kMostTries; ++i) {
    double strength = kBeyond;
    try {
      strength = strength_with({law, law.at_size(size)});
    } catch (const std::runtime_error&) {
    }
    const double miss = std::abs(std::log(strength / wanted));
    if (miss < best_miss) best = size, best_miss = miss;
    if (miss < kClose) break;
    (strength < wanted ? low : high) = size;
    const double next = size * std::clamp(added / std::sqrt(std::max(0.01, strength * strength - 1.0)), 0.1, 8.0);
    size = next > low * 1.02 && next < high / 1.02 ? next : std::sqrt(low * high);
  }
  return law.at_size(best);
}

}  // namespace hidden_effects

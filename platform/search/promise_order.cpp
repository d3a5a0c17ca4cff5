#include "search/promise_order.h"

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kNearlyAsMuch =
    0.3;  ///< of the predicted gain of a simpler effect of its kind; with less, an effect is not fitted
constexpr double kMoreOnEach = 1.05;    ///< the same for effects with a value for each joint, which take long to fit
constexpr double kLeastPromise = 1e-3;  ///< nats
constexpr double kSamePromise =
    0.03;  ///< of the gains by blocks of time: effects closer than this are predicted to act alike

std::vector<EffectPromise> cheapest_first(const EffectLook& look, double worth_of_value) {
  std::vector<EffectPromise> promises = look.promises;
  const auto price = [&](const EffectPromise& one) {
    return one.cost + worth_of_value * static_cast<double>(look.hypotheses[one.hypothesis].parameters());
  };
  std::stable_sort(promises.begin(), promises.end(),
                   [&](const EffectPromise& a, const EffectPromise& b) { return price(a) < price(b); });
  return promises;
}

/// An effect compared with those chosen before it.
struct Compared {
  const EffectLook& look;
  const EffectPromise& promise;

  const Hypothesis& hypothesis_of(const EffectPromise& one) const { return look.hypotheses[one.hypothesis]; }
  double gain_of(const EffectPromise& one) const { return look.cost - one.cost; }

  bool is_outdone_by(const EffectPromise& other) const {
    const Hypothesis &own = hypothesis_of(promise), &simpler = hypothesis_of(other);
    return simpler.parameters() < own.parameters() && of_one_kind(simpler, own) &&
           gain_of(promise) < (own.placed.size() > 1 ? kMoreOnEach : kNearlyAsMuch) * gain_of(other);
  }
  bool is_twin_of(const EffectPromise& other) const {
    return (promise.gains - other.gains).norm() < kSamePromise * promise.gains.norm();
  }
};

}  // namespace

std::vector<EffectPromise> best_promises(const EffectLook& look, const std::set<std::string>& beside,
                                         std::size_t most) {
  std::vector<EffectPromise> chosen;
  const double most_gain = look.promises.empty() ? 0.0 : look.cost - look.promises.front().cost;
  for (const EffectPromise& promise : cheapest_first(look, kWorthOfAValue * most_gain)) {
    const Compared one{look, promise};
    if (beside.contains(member_name(one.hypothesis_of(promise).entry))) continue;
    if (one.gain_of(promise) < std::max(kLeastPromise, kLeastShare * most_gain)) continue;
    const auto by_any = [&](bool (Compared::*is)(const EffectPromise&) const) {
      return std::any_of(chosen.begin(), chosen.end(), [&](const EffectPromise& other) { return (one.*is)(other); });
    };
    if (by_any(&Compared::is_outdone_by) || by_any(&Compared::is_twin_of)) continue;
    if (chosen.size() == most) break;
    chosen.push_back(promise);
  }
  return chosen;
}

std::vector<EffectPromise> twins_of(const EffectLook& look, const std::string& member) {
  std::vector<EffectPromise> twins;
  const auto own = std::find_if(look.promises.begin(), look.promises.end(), [&](const EffectPromise& one) {
    return member_name(look.hypotheses[one.hypothesis].entry) == member;
  });
  if (own == look.promises.end()) return twins;
  for (const EffectPromise& promise : look.promises)
    if (promise.hypothesis != own->hypothesis && Compared{look, promise}.is_twin_of(*own)) twins.push_back(promise);
  return twins;
}

}  // namespace lacuna

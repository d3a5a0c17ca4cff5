#include "search/slots.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSamePromise = 0.01;  ///< nats
constexpr double kNearlyAsMuch = 0.7;  ///< of what a simpler law promises to gain: a promise is only of first order

/// Whether an effect is there already.
bool is_there(const Hypothesis& one, const std::vector<EffectEntry>& beside) {
  return std::any_of(beside.begin(), beside.end(), [&](const EffectEntry& there) {
    return one.entry.effect == there.effect && !there.where.empty() && one.where() == there.where.front();
  });
}

}  // namespace

bool are_alike(const Hypothesis& one, const Hypothesis& other) {
  const auto names = [](const Hypothesis& a, const Hypothesis& b) {
    return std::find(a.alike.begin(), a.alike.end(), b.entry.effect) != a.alike.end();
  };
  return one.entry.effect == other.entry.effect || names(one, other) || names(other, one);
}

bool same_place(const Hypothesis& one, const Hypothesis& other) {
  const auto kind = [](const std::string& where) { return where.substr(0, where.find('.')); };
  return one.where() == other.where() || kind(one.where()) != kind(other.where());
}

std::vector<Promise> slots_of(const Look& look, const std::vector<EffectEntry>& beside, std::size_t most) {
  std::vector<Promise> slots;
  for (const Promise& promise : look.promises) {
    if (slots.size() == most) break;
    const Hypothesis& one = look.hypotheses[promise.hypothesis];
    const bool outdone = std::any_of(slots.begin(), slots.end(), [&](const Promise& better) {
      const Hypothesis& other = look.hypotheses[better.hypothesis];
      return are_alike(one, other) && same_place(one, other) && other.own.size() <= one.own.size() &&
             look.cost - promise.cost < kNearlyAsMuch * (look.cost - better.cost);
    });
    if (!outdone && !is_there(one, beside)) slots.push_back(promise);
  }
  return slots;
}

std::vector<std::size_t> not_redundant(const Look& look, std::size_t most) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < look.promises.size() && kept.size() < most; ++i) {
    const Hypothesis& one = look.hypotheses[look.promises[i].hypothesis];
    const bool redundant = std::any_of(look.promises.begin(), look.promises.end(), [&](const Promise& promise) {
      const Hypothesis& other = look.hypotheses[promise.hypothesis];
      return other.own.size() < one.own.size() && are_alike(one, other) && same_place(one, other) &&
             std::abs(promise.cost - look.promises[i].cost) < kSamePromise;
    });
    if (!redundant) kept.push_back(look.promises[i].hypothesis);
  }
  return kept;
}

}  // namespace lacuna

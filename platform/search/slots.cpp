#include "search/slots.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSamePromise = 0.01;  ///< nats
constexpr double kNearlyAsMuch =
    0.7;  ///< of the gain: simpler laws are refitted first, richer ones later in their place

/// Whether the two are at one place: the same element, or elements of two kinds, which may belong together.
bool same_place(const Hypothesis& one, const Hypothesis& other) {
  const auto kind = [](const std::string& where) { return where.substr(0, where.find('.')); };
  return one.where() == other.where() || kind(one.where()) != kind(other.where());
}

/// Whether an effect would do what one that is there already does.
bool repeats(const Look& look, const Promise& promise, const std::vector<EffectEntry>& beside) {
  const Hypothesis& one = look.hypotheses[promise.hypothesis];
  return std::any_of(beside.begin(), beside.end(), [&](const EffectEntry& there) {
    const bool alike = one.entry.effect == there.effect ||
                       std::find(one.alike.begin(), one.alike.end(), there.effect) != one.alike.end();
    return alike && !there.where.empty() && one.where() == there.where.front();
  });
}

}  // namespace

bool are_alike(const Hypothesis& one, const Hypothesis& other) {
  const auto names = [](const Hypothesis& a, const Hypothesis& b) {
    return std::find(a.alike.begin(), a.alike.end(), b.entry.effect) != a.alike.end();
  };
  return one.entry.effect == other.entry.effect || names(one, other) || names(other, one);
}

std::vector<Promise> slots_of(const Look& look, const std::vector<EffectEntry>& beside, std::size_t most) {
  std::vector<Promise> slots;
  std::vector<bool> done(look.promises.size(), false);
  for (std::size_t i = 0; i < look.promises.size() && slots.size() < most; ++i) {
    if (done[i] || repeats(look, look.promises[i], beside)) continue;
    const Hypothesis& leader = look.hypotheses[look.promises[i].hypothesis];
    const double gain = look.cost - look.promises[i].cost;
    std::size_t chosen = i;
    for (std::size_t j = i; j < look.promises.size(); ++j) {
      const Hypothesis& other = look.hypotheses[look.promises[j].hypothesis];
      if (done[j] || !are_alike(leader, other) || !same_place(leader, other)) continue;
      const bool simpler = other.own.size() < look.hypotheses[look.promises[chosen].hypothesis].own.size();
      if (simpler && look.cost - look.promises[j].cost >= kNearlyAsMuch * gain) chosen = j;
    }
    const Hypothesis& taken = look.hypotheses[look.promises[chosen].hypothesis];
    for (std::size_t j = i; j < look.promises.size(); ++j) {
      const Hypothesis& other = look.hypotheses[look.promises[j].hypothesis];
      const bool in_its_place = are_alike(taken, other) && same_place(taken, other);
      if (in_its_place && other.own.size() > taken.own.size()) done[j] = true;
    }
    done[chosen] = done[i] = true;
    slots.push_back(look.promises[chosen]);
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

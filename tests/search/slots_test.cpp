#include "search/slots.h"

#include <gtest/gtest.h>

#include <utility>

namespace lacuna {
namespace {

/// A look at effects on one hinge: name, number of values, what it gains, what looks like it.
struct Seen {
  std::string effect;
  std::size_t values;
  double gain;
  std::vector<std::string> alike = {};
  std::string where = "joint.hinge";
};

Look look_of(const std::vector<Seen>& effects) {
  Look look;
  for (const Seen& seen : effects) {
    Hypothesis hypothesis;
    hypothesis.entry.effect = seen.effect;
    hypothesis.entry.where = {seen.where};
    hypothesis.own.resize(seen.values);
    hypothesis.alike = seen.alike;
    look.promises.push_back({look.hypotheses.size(), -seen.gain, {}, {}});
    look.hypotheses.push_back(std::move(hypothesis));
  }
  return look;
}

std::vector<std::string> slots(const std::vector<Seen>& effects, const std::vector<EffectEntry>& beside = {},
                               std::size_t most = 8) {
  const Look look = look_of(effects);
  std::vector<std::string> names;
  for (const Promise& promise : slots_of(look, beside, most))
    names.push_back(look.hypotheses[promise.hypothesis].entry.effect);
  return names;
}

using Names = std::vector<std::string>;

TEST(Slots, ALawThatPromisesMuchLessThanASimplerOneThatLooksLikeItHasNone) {
  EXPECT_EQ(slots({{"coulomb", 1, 1.0}, {"stribeck", 3, 0.6, {"coulomb"}}}), Names{"coulomb"});
  EXPECT_EQ(slots({{"coulomb", 1, 1.0}, {"stribeck", 3, 0.8, {"coulomb"}}}), (Names{"coulomb", "stribeck"}));
}

TEST(Slots, ARicherLawAndTheSimpleOneThatPromisesLessHaveOneEach) {
  EXPECT_EQ(slots({{"stribeck", 3, 1.0, {"coulomb"}}, {"coulomb", 1, 0.5}}), (Names{"stribeck", "coulomb"}));
}

TEST(Slots, WhatLooksDifferentOrIsElsewhereHasItsOwn) {
  EXPECT_EQ(slots({{"coulomb", 1, 1.0}, {"stribeck", 3, 0.3, {"coulomb"}, "joint.other"}, {"spring", 3, 0.2}}),
            (Names{"coulomb", "stribeck", "spring"}));
}

TEST(Slots, NothingThatTheModelHasAlready) {
  EffectEntry there;
  there.effect = "coulomb";
  there.where = {"joint.hinge"};
  EXPECT_EQ(slots({{"coulomb", 1, 1.0}, {"spring", 1, 0.9}}, {there}), Names{"spring"});
}

TEST(Slots, WhatLooksLikeAnEffectThatIsThereMayComeBesideIt) {
  EffectEntry there;
  there.effect = "coulomb";
  there.where = {"joint.hinge"};
  EXPECT_EQ(slots({{"load", 1, 1.0, {"coulomb"}}, {"spring", 1, 0.9}}, {there}), (Names{"load", "spring"}));
}

TEST(Slots, NoMoreThanAskedFor) {
  EXPECT_EQ(slots({{"a", 1, 1.0}, {"b", 1, 0.9}, {"c", 1, 0.8}}, {}, 2), (Names{"a", "b"}));
}

}  // namespace
}  // namespace lacuna

#include "search/fit_starts.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// One effect with a size, which changes nothing at 1, and a shape.
EffectLook look_at_one() {
  Hypothesis one;
  one.entry.effect = "drag";
  one.entry.where = {"body.arm"};
  one.placed = {one.entry};
  one.definition.free = {{{"effect.drag.size", "1", 0.0, 10.0, 1.0, Scale::linear}, ""},
                         {{"effect.drag.shape", "1", 0.1, 10.0, 1.0, Scale::logarithmic}, ""}};
  one.own = {0, 1};
  one.neutral = {1.0, 1.0};
  EffectLook look;
  look.hypotheses.push_back(std::move(one));
  return look;
}

TEST(Slightly, BeginsSizesNearNothingAndTakesShapes) {
  const NamedValues with{{"drag @ body.arm.size", 6.0}, {"drag @ body.arm.shape", 4.0}, {"body.arm.mass", 2.0}};
  const NamedValues start = slightly(with, {{"body.arm.mass", 3.0}}, look_at_one());
  const NamedValues expected{{"body.arm.mass", 3.0}, {"drag @ body.arm.shape", 4.0}, {"drag @ body.arm.size", 1.1}};
  EXPECT_EQ(start, expected);
}

TEST(Slightly, LeavesWhatTheOtherHas) {
  const NamedValues start = slightly({{"drag @ body.arm.size", 6.0}}, {{"drag @ body.arm.size", 2.0}}, look_at_one());
  EXPECT_EQ(start, (NamedValues{{"drag @ body.arm.size", 2.0}}));
}

TEST(BothValues, AreThoseOfTheOneAndWhatTheOtherHasMore) {
  EXPECT_EQ(both_values({{"a", 1.0}, {"b", 2.0}}, {{"b", 3.0}}), (NamedValues{{"a", 1.0}, {"b", 3.0}}));
}

}  // namespace
}  // namespace lacuna

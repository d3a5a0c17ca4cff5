#include "diagnosis/rounds/fewer_effects.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double square_above_floor(double times_floor) { return times_floor * times_floor - 1.0; }

AboveFloor left(double none, double fewer, double answer) {
  return {square_above_floor(none), square_above_floor(fewer), square_above_floor(answer)};
}

bool is_form(double none, double fewer, double answer) { return rest_is_form({left(none, fewer, answer)}); }

TEST(RestIsForm, WhereASecondEffectLeavesTheModelNearlyAsFarAboveTheFloor) { EXPECT_TRUE(is_form(3.2, 1.55, 1.47)); }

TEST(RestIsForm, NotWhereASecondEffectTakesTheErrorToTheFloor) {
  EXPECT_FALSE(is_form(3.1, 1.9, 1.15));
  EXPECT_FALSE(is_form(3.2, 1.55, 1.0));
}

TEST(RestIsForm, NotWhereTheFirstEffectExplainsLittle) { EXPECT_FALSE(is_form(3.2, 2.9, 2.5)); }

TEST(RestIsForm, NotWhereTheFirstEffectReachesTheFloor) { EXPECT_FALSE(is_form(3.2, 1.05, 1.04)); }

TEST(RestIsForm, NotWhereASecondEffectTakesASingleChannelToTheFloor) {
  const AboveFloor first_joint = left(9.0, 2.5, 2.5);
  EXPECT_TRUE(rest_is_form({first_joint, left(1.3, 1.3, 1.3)}));
  EXPECT_FALSE(rest_is_form({first_joint, left(1.3, 1.3, 1.0)}));
}

TEST(RestIsForm, WhereWhatAChannelLosesMayBeChance) {
  EXPECT_TRUE(rest_is_form({left(9.0, 2.5, 2.5), left(1.03, 1.03, 1.01)}));
}

}  // namespace
}  // namespace lacuna

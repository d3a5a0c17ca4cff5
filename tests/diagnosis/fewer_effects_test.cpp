#include "diagnosis/fewer_effects.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double square_above_floor(double times_floor) { return times_floor * times_floor - 1.0; }

bool is_form(double none, double fewer, double answer) {
  return rest_is_form({square_above_floor(none), square_above_floor(fewer), square_above_floor(answer)});
}

TEST(RestIsForm, WhereASecondEffectLeavesTheModelNearlyAsFarAboveTheFloor) { EXPECT_TRUE(is_form(3.2, 1.55, 1.47)); }

TEST(RestIsForm, NotWhereASecondEffectTakesTheErrorToTheFloor) {
  EXPECT_FALSE(is_form(3.1, 1.9, 1.15));
  EXPECT_FALSE(is_form(3.2, 1.55, 1.0));
}

TEST(RestIsForm, NotWhereTheFirstEffectExplainsLittle) { EXPECT_FALSE(is_form(3.2, 2.9, 2.5)); }

TEST(RestIsForm, NotWhereTheFirstEffectReachesTheFloor) { EXPECT_FALSE(is_form(3.2, 1.05, 1.04)); }

}  // namespace
}  // namespace lacuna

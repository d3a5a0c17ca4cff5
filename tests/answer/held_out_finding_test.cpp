#include "answer/held_out_finding.h"

#include <gmock/gmock.h>

#include <limits>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Errors in multiples of a floor of 2 mrad; on the fit files the answer lowers them.
HorizonError error(double base_held_out, double answer_held_out) {
  return {1.0, "angle", "rad", 2e-3, 8e-3, 2e-3, 2e-3 * base_held_out, 2e-3 * answer_held_out};
}

TEST(HeldOutFinding, SaysThatTheErrorRisesWithTheAnswer) {
  EXPECT_THAT(held_out_finding({error(3.0, 6.0), error(4.0, 8.0)}),
              HasSubstr("is 3.54 × floor without it and 7.07 × floor with it"));
}

TEST(HeldOutFinding, WeighsAllHorizonsTogether) {
  EXPECT_EQ(held_out_finding({error(1.0, 1.1), error(9.0, 3.0)}), "") << "at the floor by chance; far off without it";
  EXPECT_NE(held_out_finding({error(1.2, 1.1), error(3.0, 9.0)}), "");
}

TEST(HeldOutFinding, IsNoneWhereNothingIsHeldOut) {
  EXPECT_EQ(held_out_finding({error(kUnknown, kUnknown)}), "");
  EXPECT_EQ(held_out_finding({}), "");
}

TEST(HeldOutFinding, LeavesOutWhatCouldNotBeSimulated) {
  EXPECT_EQ(held_out_finding({error(4.0, 2.0), error(1.0, kUnknown)}), "");
}

}  // namespace
}  // namespace lacuna

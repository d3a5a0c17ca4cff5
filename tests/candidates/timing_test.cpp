#include "candidates/timing.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// Commands every `interval` s, readings every 10 ms.
Trial commanded(double interval) {
  Trial trial;
  trial.measured.times = Eigen::VectorXd::LinSpaced(101, 0.0, 1.0);
  if (interval > 0.0) trial.commands.series.times = Eigen::VectorXd::LinSpaced(11, 0.0, 10.0 * interval);
  return trial;
}

TEST(WithTiming, AppendsTheOffsetOfTheCommandsWithinItsRange) {
  const std::vector<FreeValue> free = with_timing({{{"body.arm.mass", "kg", 0.1, 1.0, 0.5}}}, {-0.5, 0.25});
  ASSERT_EQ(free.size(), 2U);
  EXPECT_EQ(free[0].address, "body.arm.mass");
  EXPECT_EQ(free[1].lower, -0.5);
  EXPECT_EQ(free[1].upper, 0.25);
  EXPECT_EQ(free[1].start, 0.0) << "as recorded";
  EXPECT_EQ(free[1].scale, Scale::linear);
}

TEST(WithTiming, LetsCommandsActAnIntervalEarlierOrLaterAtMost) {
  const FreeValue offset = with_timing({}).front();
  EXPECT_EQ(offset.lower, -1.0);
  EXPECT_EQ(offset.upper, 1.0);
}

TEST(LongestCommandInterval, IsThatOfTheTrialWithTheRarestCommands) {
  EXPECT_NEAR(longest_command_interval({commanded(0.01), commanded(0.05), commanded(0.02)}), 0.05, 1e-12);
}

TEST(LongestCommandInterval, IsZeroWithoutCommands) {
  EXPECT_EQ(longest_command_interval({commanded(0.0)}), 0.0);
  EXPECT_EQ(longest_command_interval({}), 0.0);
}

}  // namespace
}  // namespace lacuna

#include "foundation/processes/interrupt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

std::int64_t fake_time = 0;  // ms
std::int64_t fake_clock() { return fake_time; }

/// Each test begins at zero and leaves no limit behind.
class TimeLimitTest : public testing::Test {
 protected:
  TimeLimitTest() { fake_time = 0; }
  ~TimeLimitTest() override { lift_time_limit(); }
};

TEST_F(TimeLimitTest, IsReachedWhenItsSecondsHavePassed) {
  begin_time_limit(2.0, "2 s", fake_clock);
  fake_time = 1999;
  EXPECT_FALSE(interrupt_requested());
  EXPECT_NO_THROW(throw_if_interrupted());
  EXPECT_FALSE(time_limit_was_reached());
  fake_time = 2000;
  EXPECT_TRUE(interrupt_requested());
  EXPECT_TRUE(time_limit_was_reached());
}

TEST_F(TimeLimitTest, SaysWhatStoppedTheWorkInTheUsersWords) {
  begin_time_limit(300.0, "5 min", fake_clock);
  fake_time = 400'000;
  try {
    throw_if_interrupted();
    FAIL() << "nothing was thrown";
  } catch (const TimeIsUp& stop) {
    EXPECT_THAT(stop.what(), testing::StartsWith("stopped by --time-limit 5 min"));
  }
}

TEST_F(TimeLimitTest, StopsNothingOnceItIsLifted) {
  begin_time_limit(1.0, "1", fake_clock);
  fake_time = 1000;
  EXPECT_THROW(throw_if_interrupted(), TimeIsUp);
  lift_time_limit();
  EXPECT_NO_THROW(throw_if_interrupted());
  EXPECT_FALSE(interrupt_requested());
  EXPECT_TRUE(time_limit_was_reached()) << "for whoever stores how the work ended";
}

TEST_F(TimeLimitTest, MayBeLongerThanAnyClock) {
  begin_time_limit(1e300, "1e300", fake_clock);
  fake_time = 1'000'000'000;
  EXPECT_FALSE(interrupt_requested());
}

}  // namespace
}  // namespace lacuna

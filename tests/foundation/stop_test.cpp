#include "foundation/processes/stop.h"
#include "foundation/work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace lacuna {
namespace {

std::int64_t fake_time = 0;  // ms
std::int64_t fake_clock() { return fake_time; }

/// Each test begins at zero.
class TimeLimitTest : public testing::Test {
 protected:
  TimeLimitTest() { fake_time = 0; }
};

TEST_F(TimeLimitTest, IsReachedWhenItsSecondsHavePassed) {
  TimeLimit limit(2.0, "2 s", fake_clock);
  const Stop stop(limit);
  fake_time = 1999;
  EXPECT_FALSE(stop.is_due());
  EXPECT_NO_THROW(stop.throw_if_due());
  EXPECT_FALSE(stop.limit_was_reached());
  fake_time = 2000;
  EXPECT_TRUE(stop.is_due());
  EXPECT_TRUE(stop.limit_was_reached());
}

TEST_F(TimeLimitTest, SaysWhatStoppedTheWorkInTheUsersWords) {
  TimeLimit limit(300.0, "5 min", fake_clock);
  fake_time = 400'000;
  try {
    Stop(limit).throw_if_due();
    FAIL() << "nothing was thrown";
  } catch (const TimeIsUp& stop) {
    EXPECT_THAT(stop.what(), testing::StartsWith("stopped by --time-limit 5 min"));
  }
}

TEST_F(TimeLimitTest, StopsNothingOnceItIsLifted) {
  TimeLimit limit(1.0, "1", fake_clock);
  const Stop stop(limit);
  fake_time = 1000;
  EXPECT_THROW(stop.throw_if_due(), TimeIsUp);
  stop.lift_limit();
  EXPECT_NO_THROW(stop.throw_if_due());
  EXPECT_FALSE(stop.is_due());
  EXPECT_TRUE(stop.limit_was_reached()) << "for whoever stores how the work ended";
}

TEST_F(TimeLimitTest, MayBeLongerThanAnyClock) {
  TimeLimit limit(1e300, "1e300", fake_clock);
  fake_time = 1'000'000'000;
  EXPECT_FALSE(Stop(limit).is_due());
}

TEST_F(TimeLimitTest, IsThatOfOnePieceOfWorkAlone) {
  TimeLimit shorter(1.0, "1 s", fake_clock), longer(2.0, "2 s", fake_clock);
  const StopRequest nobody;
  const Stop one = Stop(nobody).within(shorter), other = Stop(nobody).within(longer), unlimited(nobody);
  fake_time = 1500;
  EXPECT_THROW(one.throw_if_due(), TimeIsUp);
  EXPECT_NO_THROW(other.throw_if_due());
  one.lift_limit();
  EXPECT_NO_THROW(one.throw_if_due());
  fake_time = 2000;
  EXPECT_THROW(other.throw_if_due(), TimeIsUp) << "its limit is not lifted";
  EXPECT_NO_THROW(one.throw_if_due());
  EXPECT_NO_THROW(unlimited.throw_if_due());
  EXPECT_FALSE(unlimited.limit_was_reached());
}

TEST_F(TimeLimitTest, DoesNotEndWorkThatTheRestDependsOn) {
  TimeLimit limit(1.0, "1 s", fake_clock);
  const Stop stop(limit);
  fake_time = 5000;
  EXPECT_NO_THROW(stop.throw_if_requested());
  EXPECT_NO_THROW(stop.throw_if_kept_waiting());
}

TEST(StopTest, WithoutARequestAndALimitEndsNothing) {
  const Stop stop;
  EXPECT_FALSE(stop.is_due());
  EXPECT_NO_THROW(stop.throw_if_due());
  EXPECT_NO_THROW(stop.throw_if_requested());
  EXPECT_NO_THROW(stop.throw_if_kept_waiting());
  EXPECT_NO_THROW(stop.lift_limit());
  EXPECT_FALSE(stop.limit_was_reached());
}

TEST(StopTest, ARequestEndsTheWorkThatItIsFor) {
  StopRequest request;
  const StopRequest another;
  const Stop asked(request), not_asked(another);
  EXPECT_NO_THROW(asked.throw_if_due());
  request.make();
  EXPECT_TRUE(asked.is_due());
  EXPECT_THROW(asked.throw_if_due(), Interrupted);
  EXPECT_THROW(asked.throw_if_requested(), Interrupted);
  EXPECT_THROW(asked.pause_for(60.0), Interrupted);
  EXPECT_NO_THROW(not_asked.throw_if_due());
  EXPECT_NO_THROW(not_asked.throw_if_requested());
}

TEST(StopTest, ARequestCountsFromTheFirst) {
  StopRequest request;
  EXPECT_EQ(request.made_at(), 0);
  EXPECT_EQ(request.make(500), 500);
  EXPECT_EQ(request.make(700), 500);
  EXPECT_EQ(request.made_at(), 500);
}

TEST(StopTest, WorkThatIsUsuallyShortEndsOnlyAfterAWait) {
  constexpr std::int64_t kLong = 5000;  // ms, more than such work may go on
  StopRequest now, before;
  now.make();
  before.make(milliseconds_now() - kLong);
  EXPECT_NO_THROW(Stop(now).throw_if_kept_waiting());
  EXPECT_THROW(Stop(before).throw_if_kept_waiting(), Interrupted);
}

TEST_F(TimeLimitTest, ARequestComesBeforeALimitThatIsOver) {
  TimeLimit limit(1.0, "1 s", fake_clock);
  StopRequest request;
  const Stop stop = Stop(request).within(limit);
  request.make();
  fake_time = 1000;
  try {
    stop.throw_if_due();
    FAIL() << "nothing was thrown";
  } catch (const TimeIsUp&) {
    FAIL() << "the limit was taken for the reason";
  } catch (const Interrupted& interrupted) {
    EXPECT_THAT(interrupted.what(), testing::StartsWith("interrupted"));
  }
}

/// Counts its steps until something ends it.
struct CountedWork {
  std::atomic<int> steps = 0;
  bool ended_by_limit = false;

  void go_on(const Work& work, int most) {
    try {
      for (; steps < most; ++steps) work.stop.throw_if_due();
    } catch (const TimeIsUp&) {
      ended_by_limit = true;
    }
  }
};

TEST(StopTest, TwoPiecesOfWorkInOneProcessEndIndependently) {
  constexpr int kMost = 100'000;
  TimeLimit over(0.0, "0 s"), ample(3600.0, "1 h");
  CountedWork first, second;
  {
    const std::jthread one([&] { first.go_on({.stop = Stop(over)}, kMost); });
    const std::jthread other([&] { second.go_on({.stop = Stop(ample)}, kMost); });
  }
  EXPECT_TRUE(first.ended_by_limit);
  EXPECT_EQ(first.steps, 0);
  EXPECT_FALSE(second.ended_by_limit);
  EXPECT_EQ(second.steps, kMost);
  EXPECT_TRUE(over.was_reached());
  EXPECT_FALSE(ample.was_reached());
}

}  // namespace
}  // namespace lacuna

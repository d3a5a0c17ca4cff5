#include "app/terminal/recent_rate.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(RecentRate, IsUnknownUntilTwoMomentsAreKnown) {
  RecentRate rate;
  EXPECT_EQ(rate.per_second(), 0.0);
  rate.note(5.0, 1000);
  EXPECT_EQ(rate.per_second(), 0.0);
}

TEST(RecentRate, FollowsWhatHappenedLately) {
  RecentRate rate;
  std::uint64_t total = 0;
  for (int i = 0; i <= 100; ++i) rate.note(i, total += 500);
  EXPECT_DOUBLE_EQ(rate.per_second(), 500.0);
  for (int i = 101; i <= 120; ++i) rate.note(i, total += 20);
  EXPECT_DOUBLE_EQ(rate.per_second(), 20.0) << "an average since the beginning would be 420";
}

TEST(RecentRate, KeepsCountWhereMomentsAreClose) {
  RecentRate rate;
  for (int i = 0; i <= 100000; ++i) rate.note(1e-4 * i, static_cast<std::uint64_t>(i));
  EXPECT_NEAR(rate.per_second(), 1e4, 1.0);
}

}  // namespace
}  // namespace lacuna

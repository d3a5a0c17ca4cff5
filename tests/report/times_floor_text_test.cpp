#include "report/text/times_floor_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace lacuna {
namespace {

TEST(TimesFloorText, ShowsNoMoreDigitsThanItKnows) {
  EXPECT_EQ(times_floor_text(0.94), "0.9");
  EXPECT_EQ(times_floor_text(17.06), "17.1");
  EXPECT_EQ(times_floor_text(99.96), "100");
  EXPECT_EQ(times_floor_text(999.6), "1000");
  EXPECT_EQ(times_floor_text(3.5e7), ">1000");
  EXPECT_EQ(times_floor_text(std::numeric_limits<double>::infinity()), "-");
  EXPECT_EQ(times_floor_text(std::numeric_limits<double>::quiet_NaN()), "-");
}

}  // namespace
}  // namespace lacuna

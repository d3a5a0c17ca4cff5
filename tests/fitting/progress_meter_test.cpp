#include "fitting/numerics/progress_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lacuna::progress_meter_test {
namespace {

class ProgressMeterTest : public testing::Test {
 protected:
  std::vector<Progress> seen_;
  const ProgressCallback callback_ = [this](const Progress& now) { seen_.push_back(now); };
  ProgressMeter meter_{callback_};
};

/// An iteration is a fifth of what remains of its part.
TEST_F(ProgressMeterTest, GivesEachPartTheSameShare) {
  meter_.set_parts(2);
  meter_.begin_part("short segments");
  EXPECT_EQ(seen_.back().what, "short segments");
  EXPECT_EQ(seen_.back().fraction, 0.0);
  EXPECT_TRUE(std::isnan(seen_.back().seconds_left)) << "nothing is known yet";
  meter_.report(1);
  EXPECT_DOUBLE_EQ(seen_.back().fraction, 0.5 * 0.2);
  EXPECT_GE(seen_.back().seconds_left, 0.0);
  meter_.report(2);
  EXPECT_DOUBLE_EQ(seen_.back().fraction, 0.5 * 0.36);
  meter_.end_part();
  meter_.begin_part("free run");
  EXPECT_DOUBLE_EQ(seen_.back().fraction, 0.5);
  EXPECT_EQ(meter_.what(), "free run");
}

TEST_F(ProgressMeterTest, NeverGoesBack) {
  meter_.begin_part("search");
  meter_.report(3);
  const double fraction = seen_.back().fraction;
  meter_.report(1);  // another search of the part
  EXPECT_EQ(seen_.back().fraction, fraction);
  meter_.add_parts(5);
  meter_.report(3);
  EXPECT_EQ(seen_.back().fraction, fraction);
}

TEST(ProgressMeter, WithoutAListenerOnlyNamesItsPart) {
  const ProgressCallback nobody;
  ProgressMeter meter(nobody);
  meter.begin_part("search");
  meter.report(1);
  EXPECT_EQ(meter.what(), "search");
}

}  // namespace
}  // namespace lacuna::progress_meter_test

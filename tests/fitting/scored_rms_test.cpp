#include "fitting/numerics/scored_rms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::scored_rms_test {
namespace {

TimeSeries::Samples residuals_of_two() {
  TimeSeries::Samples residuals(5, 2);
  residuals << 9.0, 1.0, 1.0, 1.0, std::nan(""), 1.0, -2.0, 1.0, 2.0, 1.0;
  return residuals;
}

TEST(ScoredRms, IsThatOfTheMeasuredRowsFromTheFirstScoredOn) {
  EXPECT_DOUBLE_EQ(scored_rms(residuals_of_two(), 0, 1), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(scored_rms(residuals_of_two(), 0, 0), std::sqrt(90.0 / 4.0));
  EXPECT_DOUBLE_EQ(scored_rms(residuals_of_two(), 1, 1), 1.0) << "of its channel alone";
}

TEST(ScoredRms, IsNotANumberWhereNothingIsScored) {
  EXPECT_TRUE(std::isnan(scored_rms(residuals_of_two(), 0, 5)));
  EXPECT_TRUE(std::isnan(scored_rms(TimeSeries::Samples::Constant(3, 1, std::nan("")), 0, 0)));
}

}  // namespace
}  // namespace lacuna::scored_rms_test

#include "figures/estimate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hidden_effects {
namespace {

std::vector<double> ones_of(std::size_t ones, std::size_t n) {
  std::vector<double> values(n, 0.0);
  for (std::size_t i = 0; i < ones; ++i) values[i] = 1.0;
  return values;
}

struct Published {
  std::size_t ones, n;
  double lower, upper;
};

/// R. G. Newcombe, Statistics in Medicine 17 (1998) 857-872, table I, method 3.
TEST(Share, HasWilsonsInterval) {
  constexpr double kLastDigit = 5e-5;
  for (const Published& one : {Published{81, 263, 0.2553, 0.3662}, Published{15, 148, 0.0624, 0.1605},
                               Published{0, 20, 0.0, 0.1611}, Published{1, 29, 0.0061, 0.1718}}) {
    const Estimate estimate = share(ones_of(one.ones, one.n));
    EXPECT_EQ(estimate.n, one.n);
    EXPECT_NEAR(estimate.lower_95, one.lower, kLastDigit);
    EXPECT_NEAR(estimate.upper_95, one.upper, kLastDigit);
  }
}

TEST(Share, OfNothingIsNotKnown) {
  EXPECT_EQ(share({}).n, 0U);
  EXPECT_TRUE(std::isnan(share({}).value));
}

TEST(Median, IsInTheMiddle) {
  EXPECT_EQ(median({5.0, 1.0, 3.0}), 3.0);
  EXPECT_EQ(median({5.0, 1.0, 3.0, 4.0}), 3.5);
}

/// Two bins hold something: 0.9 is stated three times and right twice, 0.35 twice and right never:
/// (3 · |0.9 − 2/3| + 2 · 0.35) / 5 = 0.28.
TEST(CalibrationError, IsTheMeanGapOfTheBins) {
  const std::vector<Stated> stated = {{0.9, 1}, {0.9, 1}, {0.9, 0}, {0.35, 0}, {0.35, 0}};
  EXPECT_NEAR(calibration_error(stated), 0.28, 1e-12);
  EXPECT_NEAR(calibration_error({{1.0, 1}, {0.0, 0}}), 0.0, 1e-12);
}

/// Of a hundred verdicts of 0.9 the share that is right scatters by 0.03; the mean of what it misses by is √(2/π) of
/// it.
TEST(CalibrationError, IsNotZeroByChance) {
  const Estimate hundred = calibration_error_by_chance(std::vector<Stated>(100, {0.9, 1.0}));
  EXPECT_NEAR(hundred.value, 0.0239, 0.002);
  EXPECT_LT(hundred.lower_95, 0.005);
  EXPECT_NEAR(hundred.upper_95, 0.06, 0.011);
  EXPECT_NEAR(calibration_error_by_chance({{0.8, 0.0}}).value, 2.0 * 0.8 * 0.2, 0.02) << "one verdict";
  EXPECT_TRUE(std::isnan(calibration_error_by_chance({}).value));
}

/// The standard error of the mean of 0, 1, ..., 99 is 100/√12/√100 = 2.887.
TEST(Bootstrap, HasTheWidthOfTheNormalInterval) {
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) values.push_back(i);
  const Estimate estimate = bootstrap(values, mean);
  constexpr double kTwoThousandResamples = 0.06;  // of the width: quantiles of so many scatter by 3 %
  EXPECT_EQ(estimate.value, 49.5);
  EXPECT_NEAR((estimate.upper_95 - estimate.lower_95) / (2.0 * 1.96 * 2.887), 1.0, kTwoThousandResamples);
}

TEST(Bootstrap, GivesTheSameIntervalEachTime) {
  const std::vector<double> values = {1.0, 2.0, 4.0, 8.0};
  EXPECT_EQ(bootstrap(values, mean).upper_95, bootstrap(values, mean).upper_95);
  EXPECT_TRUE(std::isnan(bootstrap(std::vector<double>{1.0}, mean).upper_95));
}

}  // namespace
}  // namespace hidden_effects

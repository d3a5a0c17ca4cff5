#include "foundation/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

TEST(Statistics, RootMeanSquareIsOfAllPartsTogether) {
  const std::vector<Eigen::VectorXd> parts = {Eigen::VectorXd::Constant(1, 3.0), Eigen::VectorXd::Constant(3, 1.0)};
  EXPECT_DOUBLE_EQ(root_mean_square(parts), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(root_mean_square(std::vector<double>{3.0, 1.0, 1.0, 1.0}), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(root_mean_square(Eigen::VectorXd(Eigen::Vector4d(3.0, 1.0, 1.0, 1.0))), std::sqrt(3.0));
}

TEST(Statistics, WithoutValuesTheRootMeanSquareIsZeroAndAQuantileIsNotANumber) {
  std::vector<double> none;
  EXPECT_EQ(root_mean_square(none), 0.0);
  EXPECT_EQ(root_mean_square(Eigen::VectorXd()), 0.0);
  EXPECT_EQ(root_mean_square(std::vector<Eigen::VectorXd>{}), 0.0);
  EXPECT_TRUE(std::isnan(quantile_of(none, 0.5)));
  EXPECT_TRUE(std::isnan(median_of(none)));
}

TEST(Statistics, AQuantileIsOneOfTheNumbers) {
  std::vector<double> numbers = {5.0, 1.0, 4.0, 2.0, 3.0, 6.0};
  EXPECT_EQ(quantile_of(numbers, 0.0), 1.0);
  EXPECT_EQ(quantile_of(numbers, 0.5), 3.0);
  EXPECT_EQ(quantile_of(numbers, 1.0), 6.0);
  EXPECT_EQ(median_of(numbers), 4.0);
}

TEST(Statistics, IntervalsAreThoseOfTheTables) {
  EXPECT_NEAR(within_95_of_students_t(4.0), 2.7764451, 1e-6);
  EXPECT_NEAR(within_95_of_students_t(1e7), kWithin95, 1e-6);
}

}  // namespace
}  // namespace lacuna

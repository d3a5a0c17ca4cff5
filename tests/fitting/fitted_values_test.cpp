#include "fitting/fitted_values.h"

#include "fitting/analytic_models.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::fitted_values_test {
namespace {

using namespace lacuna::analytic;

TEST(BoundSide, IsThatOfABoundWhichAValueHasReached) {
  const ParameterSpace space({free_value("a", 1.0, -2.0, 4.0)});
  const auto side = [&](double value) { return bound_side(space, Eigen::VectorXd::Constant(1, value), 0); };
  EXPECT_EQ(side(-2.0), -1);
  EXPECT_EQ(side(4.0), 1);
  EXPECT_EQ(side(4.0 - 1e-10), 1) << "but for rounding";
  EXPECT_EQ(side(3.999), 0);
  EXPECT_EQ(side(-1.999), 0);
}

/// Three values at the end of a search: one on a linear scale, one on a logarithmic, one that nothing determines or
/// that has reached its bound.
class EnterValues : public testing::Test {
 protected:
  FitResult entered(double last) {
    best_ = space_.to_coordinates({2.0, 0.5, last});
    known_.covariance.resize(3, 3);
    known_.covariance << 0.04, 0.006, 0.0, 0.006, 0.09, 0.0, 0.0, 0.0, std::nan("");
    known_.quantile = 2.0;
    FitResult result;
    result.values.resize(3);
    for (FittedValue& value : result.values) value.lower_95 = value.upper_95 = value.standard_error = std::nan("");
    enter_values({space_, free_, best_, known_}, result);
    return result;
  }

  const std::vector<FreeValue> free_ = {free_value("mass", 1.0, 0.0, 10.0),
                                        free_value("stiffness", 1.0, 0.01, 100.0, Scale::logarithmic),
                                        free_value("damping", 1.0, 0.0, 3.0)};
  const ParameterSpace space_{free_};
  Eigen::VectorXd best_;
  Uncertainty known_;
};

TEST_F(EnterValues, GivesValuesWithTheirIntervals) {
  known_.determined = {true, true, true};
  const FitResult result = entered(0.0);
  EXPECT_EQ(result.values[0].value, 2.0);
  EXPECT_DOUBLE_EQ(result.values[0].standard_error, 0.2);
  EXPECT_DOUBLE_EQ(result.values[0].lower_95, 2.0 - 0.4);
  EXPECT_DOUBLE_EQ(result.values[0].upper_95, 2.0 + 0.4);
  EXPECT_TRUE(result.values[0].identified);
}

/// 30 % of the value, and factors of the same size up and down.
TEST_F(EnterValues, GivesALogarithmicValueAFactor) {
  known_.determined = {true, true, true};
  const FittedValue stiffness = entered(0.0).values[1];
  EXPECT_DOUBLE_EQ(stiffness.value, 0.5);
  EXPECT_DOUBLE_EQ(stiffness.standard_error, 0.5 * 0.3);
  EXPECT_DOUBLE_EQ(stiffness.lower_95, 0.5 * std::exp(-0.6));
  EXPECT_DOUBLE_EQ(stiffness.upper_95, 0.5 * std::exp(0.6));
}

TEST_F(EnterValues, GivesTheCovarianceInSiUnits) {
  known_.determined = {true, true, true};
  const FitResult result = entered(0.0);
  EXPECT_DOUBLE_EQ(result.covariance(0, 0), 0.04);
  EXPECT_DOUBLE_EQ(result.covariance(0, 1), 0.006 * 0.5);
  EXPECT_DOUBLE_EQ(result.covariance(1, 1), 0.09 * 0.25);
}

TEST_F(EnterValues, GivesNoIntervalAtABound) {
  known_.determined = {true, true, true};
  const FittedValue lower = entered(0.0).values[2], upper = entered(3.0).values[2];
  EXPECT_TRUE(lower.at_lower_bound);
  EXPECT_FALSE(lower.at_upper_bound);
  EXPECT_TRUE(upper.at_upper_bound);
  EXPECT_TRUE(std::isnan(lower.lower_95) && std::isnan(upper.upper_95));
}

TEST_F(EnterValues, GivesItsBoundsWhereNothingDeterminesAValue) {
  known_.determined = {true, true, false};
  const FittedValue damping = entered(1.0).values[2];
  EXPECT_FALSE(damping.identified);
  EXPECT_TRUE(std::isinf(damping.standard_error));
  EXPECT_EQ(damping.lower_95, 0.0);
  EXPECT_EQ(damping.upper_95, 3.0);
}

}  // namespace
}  // namespace lacuna::fitted_values_test

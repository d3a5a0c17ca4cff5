#include "fitting/numerics/robust_loss.h"

#include <gtest/gtest.h>

namespace lacuna::robust_loss_test {
namespace {

constexpr double kSlight = 1e-6, kTolerance = 1e-5;

TEST(RobustLoss, IsTheSquareUpToItsThresholdAndThenALineOfTheSameSlope) {
  const RobustLoss loss{3.0};
  EXPECT_DOUBLE_EQ(loss.cost(-2.0), 4.0);
  EXPECT_DOUBLE_EQ(loss.cost(3.0), 9.0);
  EXPECT_DOUBLE_EQ(loss.cost(5.0), 9.0 + 2.0 * 3.0 * 2.0);
  EXPECT_DOUBLE_EQ(loss.cost(-5.0), loss.cost(5.0));
}

/// weight · r is half the slope of the cost, and the curvature half the slope's slope.
TEST(RobustLoss, HasTheWeightAndTheCurvatureOfItsCost) {
  const RobustLoss loss{3.0};
  for (const double r : {-7.0, -1.0, 0.5, 2.9, 3.5, 20.0}) {
    const double slope = (loss.cost(r + kSlight) - loss.cost(r - kSlight)) / (2.0 * kSlight);
    EXPECT_NEAR(loss.weight(r) * r, 0.5 * slope, kTolerance) << r;
    const auto pull = [&](double at) { return loss.weight(at) * at; };
    EXPECT_NEAR(loss.curvature(r), (pull(r + kSlight) - pull(r - kSlight)) / (2.0 * kSlight), kTolerance) << r;
  }
}

TEST(RobustLoss, WithoutAThresholdIsTheSquare) {
  const RobustLoss loss;
  EXPECT_EQ(loss.cost(1e6), 1e12);
  EXPECT_EQ(loss.weight(1e6), 1.0);
  EXPECT_EQ(loss.curvature(1e6), 1.0);
}

}  // namespace
}  // namespace lacuna::robust_loss_test

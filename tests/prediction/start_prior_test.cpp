#include "prediction/start_prior.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double kAddedToDiagonal = 1e-8;

TEST(StartPrior, OfIndependentComponentsIsOneInTheirDeviations) {
  const StartPrior prior = prior_of(Eigen::Vector2d(4.0, 9.0).asDiagonal());
  EXPECT_TRUE(prior.deviation.isApprox(Eigen::Vector2d(2.0, 3.0)));
  EXPECT_TRUE(prior.precision.isApprox(Eigen::Matrix2d::Identity(), kAddedToDiagonal));
}

/// The inverse of {{1, ½}, {½, 1}}.
TEST(StartPrior, IsTheInverseOfTheCorrelation) {
  const StartPrior prior = prior_of(Eigen::Matrix2d{{4.0, 3.0}, {3.0, 9.0}});
  EXPECT_TRUE(
      prior.precision.isApprox(Eigen::Matrix2d{{4.0 / 3.0, -2.0 / 3.0}, {-2.0 / 3.0, 4.0 / 3.0}}, kAddedToDiagonal))
      << prior.precision;
}

TEST(StartPrior, IsFiniteWhereComponentsAreCertainOrMoveTogether) {
  EXPECT_TRUE(prior_of(Eigen::Matrix2d::Zero()).precision.allFinite());
  EXPECT_TRUE(prior_of(Eigen::Matrix2d::Ones()).precision.allFinite());
}

TEST(StartPrior, OfNothingIsEmpty) { EXPECT_EQ(prior_of(Eigen::MatrixXd(0, 0)).precision.size(), 0); }

}  // namespace
}  // namespace lacuna

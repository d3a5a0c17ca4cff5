#include "diagnosis/refit/jackknife.h"

#include "diagnosis/synthetic_segments.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::test {
namespace {

constexpr std::size_t kGroups = 10;
constexpr int kDraws = 300;
constexpr double kBeyond = 1.96;

/// A regression whose two true values are 0, with noise of variance 1 and, beside it, what the noise model does not
/// know: in each segment the values differ by `unknown`.
struct Regression {
  Refit fit;
  Folds folds;
  Eigen::Vector2d found;

  Regression(std::uint64_t seed, double unknown) {
    SeededNoise random(seed, 8);
    Eigen::Matrix2d gram = Eigen::Matrix2d::Zero();
    Eigen::Vector2d score = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < kSegments; ++k) {
      const Eigen::MatrixXd rows = normal(kRows, 2, random);
      const Eigen::VectorXd left = normal(kRows, 1, random) + unknown * rows * normal(2, 1, random);
      fit.segments.push_back(
          {left, rows, Eigen::MatrixXd::Zero(kRows, 0), std::vector<std::size_t>(static_cast<std::size_t>(kRows), 0)});
      gram += rows.transpose() * rows;
      score += rows.transpose() * left;
      folds.push_back({k % kGroups});
    }
    found = -gram.ldlt().solve(score);
    for (RobustSegment& segment : fit.segments) segment.residual += segment.values * found;
    fit.at_bound = {false, false};
    fit.converged = true;
    fit.covariance = gram.inverse();
  }
};

/// How often the first value's interval holds the truth.
double covered(double unknown, bool wary) {
  int count = 0;
  for (int seed = 1; seed <= kDraws; ++seed) {
    const Regression one(static_cast<std::uint64_t>(seed), unknown);
    const Eigen::MatrixXd covariance = wary ? wary_covariance(one.fit, one.folds) : one.fit.covariance;
    if (std::abs(one.found(0)) <= kBeyond * std::sqrt(covariance(0, 0))) ++count;
  }
  return static_cast<double>(count) / kDraws;
}

TEST(WaryCovariance, CoversWhereTheNoiseIsNotAsItIsModelled) {
  EXPECT_LT(covered(0.4, false), 0.75);
  EXPECT_GT(covered(0.4, true), 0.88);
}

TEST(WaryCovariance, IsHardlyWiderWhereTheNoiseIsAsItIsModelled) {
  EXPECT_GT(covered(0.0, true), 0.92);
  double width = 0.0;
  for (int seed = 1; seed <= kDraws; ++seed) {
    const Regression one(static_cast<std::uint64_t>(seed), 0.0);
    const double wider = std::sqrt(wary_covariance(one.fit, one.folds)(0, 0) / one.fit.covariance(0, 0));
    EXPECT_GE(wider, 1.0 - 1e-12);
    width += wider / kDraws;
  }
  EXPECT_LT(width, 1.2);
}

TEST(WaryCovariance, LeavesAValueAtItsBoundAsItIs) {
  Regression one(3, 0.4);
  one.fit.at_bound[1] = true;
  one.fit.covariance = Eigen::Vector2d(one.fit.covariance(0, 0), 0.0).asDiagonal();
  const Eigen::MatrixXd covariance = wary_covariance(one.fit, one.folds);
  EXPECT_EQ(covariance(1, 1), 0.0);
  EXPECT_TRUE(covariance.allFinite());
}

}  // namespace
}  // namespace lacuna::test

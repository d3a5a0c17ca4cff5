#include "diagnosis/cross_validation.h"

#include "diagnosis/synthetic_segments.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

namespace lacuna::test {
namespace {

/// A linear regression of two values, at its least squares.
Refit regression(std::uint64_t seed) {
  SeededNoise random(seed, 2);
  Refit fit;
  fit.at_bound = {false, false};
  fit.covariance = Eigen::MatrixXd::Zero(2, 2);
  Eigen::MatrixXd all(kSegments * kRows, 2);
  Eigen::VectorXd residual(kSegments * kRows);
  for (Eigen::Index k = 0; k < kSegments; ++k) {
    all.middleRows(k * kRows, kRows) = normal(kRows, 2, random);
    residual.segment(k * kRows, kRows) = normal(kRows, 1, random);
  }
  const Eigen::VectorXd best = all.householderQr().solve(residual);
  residual -= all * best;
  for (Eigen::Index k = 0; k < kSegments; ++k) {
    fit.segments.push_back(
        {residual.segment(k * kRows, kRows), all.middleRows(k * kRows, kRows), Eigen::MatrixXd::Zero(kRows, 0), kRows});
    fit.weighted.push_back(weighted(fit.segments.back(), Eigen::VectorXd::Ones(kRows)));
  }
  return fit;
}

std::vector<std::size_t> five_folds() {
  std::vector<std::size_t> folds;
  for (std::size_t k = 0; k < kSegments; ++k) folds.push_back(k % 5);
  return folds;
}

/// For a linear model the step is exact: as if the fit had been made without the fold.
TEST(CrossValidation, EqualsFitsThatLeaveAFoldOut) {
  const Refit fit = regression(1);
  const std::vector<std::size_t> folds = five_folds();
  const Eigen::VectorXd deviance = held_out_deviance(fit, folds);
  for (std::size_t left_out = 0; left_out < 5; ++left_out) {
    Eigen::MatrixXd others(0, 2);
    Eigen::VectorXd wanted(0);
    for (std::size_t k = 0; k < folds.size(); ++k) {
      if (folds[k] == left_out) continue;
      others.conservativeResize(others.rows() + kRows, 2);
      others.bottomRows(kRows) = fit.segments[k].values;
      wanted.conservativeResize(wanted.size() + kRows);
      wanted.tail(kRows) = fit.segments[k].residual;
    }
    const Eigen::VectorXd step = -others.householderQr().solve(wanted);
    for (std::size_t k = 0; k < folds.size(); ++k) {
      if (folds[k] != left_out) continue;
      EXPECT_NEAR(deviance(static_cast<Eigen::Index>(k)),
                  (fit.segments[k].residual + fit.segments[k].values * step).squaredNorm(), 1e-9);
    }
  }
}

TEST(CrossValidation, HoldsAValueAtItsBoundFast) {
  Refit fit = regression(2);
  fit.at_bound[1] = true;
  for (const Eigen::VectorXd& step : steps_without(fit, five_folds())) EXPECT_EQ(step(1), 0.0);
}

/// What a search did not reach is not held to its credit, however well the derivatives promise it.
TEST(CrossValidation, AFitThatWasGivenUpIsJudgedWhereItIs) {
  Refit fit = regression(3);
  const std::vector<std::size_t> folds = five_folds();
  const double at_best = held_out_deviance(fit, folds).sum();
  double there = 0.0;
  for (std::size_t k = 0; k < folds.size(); ++k) {
    fit.segments[k].residual += fit.segments[k].values * Eigen::Vector2d(0.3, -0.2);
    fit.weighted[k] = weighted(fit.segments[k], Eigen::VectorXd::Ones(kRows));
    there += fit.segments[k].residual.squaredNorm();
  }
  fit.converged = true;
  EXPECT_NEAR(held_out_deviance(fit, folds).sum(), at_best, 1e-6);
  fit.converged = false;
  EXPECT_GT(held_out_deviance(fit, folds).sum(), there);
  EXPECT_LT(held_out_deviance(fit, folds).sum(), 1.02 * there);
}

TEST(Gain, IsHalfTheDifferenceOfDevianceWithItsSpread) {
  Eigen::VectorXd worse = Eigen::VectorXd::Constant(100, 5.0), better = Eigen::VectorXd::Constant(100, 3.0);
  for (Eigen::Index k = 0; k < 100; ++k) better(k) += k % 2 == 0 ? 0.4 : -0.4;  // differences 1 ± 0.2
  const Gain found = gain(worse, better, 1);
  EXPECT_NEAR(found.value, 100.0, 1e-9);
  EXPECT_NEAR(found.standard_error, 0.2 * std::sqrt(100.0), 0.05);
  EXPECT_NEAR(found.lower_95, 100.0 - 1.96 * 2.0, 0.6);
  EXPECT_NEAR(found.upper_95, 100.0 + 1.96 * 2.0, 0.6);
}

TEST(Folds, AreTrialsWhereThereAreEnoughAndBlocksOfThemOtherwise) {
  const auto segments_of = [](std::size_t trials, int each) {
    std::vector<Segment> segments;
    for (std::size_t trial = 0; trial < trials; ++trial)
      for (int i = 0; i < each; ++i) {
        segments.emplace_back();
        segments.back().stretch.trial = trial;
      }
    return segments;
  };
  EXPECT_EQ(folds(segments_of(4, 2)), (std::vector<std::size_t>{0, 0, 1, 1, 2, 2, 3, 3}));
  EXPECT_EQ(folds(segments_of(2, 8)), (std::vector<std::size_t>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7}));
  EXPECT_EQ(folds(segments_of(1, 3)), (std::vector<std::size_t>{0, 1, 2}));
}

}  // namespace
}  // namespace lacuna::test

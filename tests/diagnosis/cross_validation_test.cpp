#include "diagnosis/refit/cross_validation.h"

#include "diagnosis/residual_force/force_regression.h"
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
    fit.segments.push_back({residual.segment(k * kRows, kRows), all.middleRows(k * kRows, kRows),
                            Eigen::MatrixXd::Zero(kRows, 0), std::vector<std::size_t>(kRows, 0)});
    fit.weighted.push_back(weighted(fit.segments.back(), Eigen::VectorXd::Ones(kRows)));
  }
  return fit;
}

Folds five_folds() {
  Folds folds;
  for (std::size_t k = 0; k < kSegments; ++k) folds.push_back({k % 5});
  return folds;
}

/// For a linear model the step is exact: as if the fit had been made without the fold.
TEST(CrossValidation, EqualsFitsThatLeaveAFoldOut) {
  const Refit fit = regression(1);
  const Folds folds = five_folds();
  const Eigen::VectorXd deviance = held_out_deviance(fit, folds);
  for (std::size_t left_out = 0; left_out < 5; ++left_out) {
    Eigen::MatrixXd others(0, 2);
    Eigen::VectorXd wanted(0);
    for (std::size_t k = 0; k < folds.size(); ++k) {
      if (folds[k].front() == left_out) continue;
      others.conservativeResize(others.rows() + kRows, 2);
      others.bottomRows(kRows) = fit.segments[k].values;
      wanted.conservativeResize(wanted.size() + kRows);
      wanted.tail(kRows) = fit.segments[k].residual;
    }
    const Eigen::VectorXd step = -others.householderQr().solve(wanted);
    for (std::size_t k = 0; k < folds.size(); ++k) {
      if (folds[k].front() != left_out) continue;
      EXPECT_NEAR(deviance(static_cast<Eigen::Index>(k)),
                  (fit.segments[k].residual + fit.segments[k].values * step).squaredNorm(), 1e-9);
    }
  }
}

/// A value that the first segment, which is a fold of its own, tells a million times as well as the others.
Refit regression_told_by_one() {
  Refit fit = regression(6);
  Eigen::MatrixXd all(kSegments * kRows, 2);
  Eigen::VectorXd residual(kSegments * kRows);
  for (std::size_t k = 0; k < kSegments; ++k) {
    if (k > 0) fit.segments[k].values.col(1) *= 1e-6;
    all.middleRows(static_cast<Eigen::Index>(k) * kRows, kRows) = fit.segments[k].values;
    residual.segment(static_cast<Eigen::Index>(k) * kRows, kRows) = fit.segments[k].residual;
  }
  const Eigen::VectorXd best = all.householderQr().solve(residual);
  for (RobustSegment& segment : fit.segments) segment.residual -= segment.values * best;
  return fit;
}

Folds first_apart() {
  Folds folds = five_folds();
  folds[0] = {5};
  return folds;
}

/// Without the first segment the value would go anywhere; it is judged as if a fifth of what it says had stayed.
TEST(CrossValidation, AFoldThatTellsAValueAloneIsNoExtrapolation) {
  const Refit fit = regression_told_by_one();
  const Folds folds = first_apart();
  const double left = fit.segments[0].residual.squaredNorm(), held_out = held_out_deviance(fit, folds)(0);
  EXPECT_GT(held_out, left);
  EXPECT_LT(held_out, 2.0 * left);
}

TEST(CrossValidation, BesideForcesIsTheSame) {
  const Refit fit = regression_told_by_one();
  const Folds folds = first_apart();
  SeededNoise random(9, 0);
  std::vector<Eigen::MatrixXd> factors(kSegments, Eigen::MatrixXd::Identity(kRows, kRows)), columns;
  for (int k = 0; k < kSegments; ++k) columns.push_back(normal(kRows, 3, random));
  const ForceRegression regression(fit, factors, columns, folds);
  const Eigen::VectorXd own = held_out_deviance(fit, folds), beside = regression.held_out({});
  for (Eigen::Index k = 0; k < own.size(); ++k) EXPECT_NEAR(beside(k), own(k), 1e-6 * own(k)) << k;
}

TEST(CrossValidation, OfValuesThatChangeNothingIsWhatTheyLeave) {
  Refit fit = regression(6);
  for (RobustSegment& segment : fit.segments) segment.values.setZero();
  const Eigen::VectorXd deviance = held_out_deviance(fit, five_folds());
  for (std::size_t k = 0; k < kSegments; ++k)
    EXPECT_DOUBLE_EQ(deviance(static_cast<Eigen::Index>(k)), fit.segments[k].residual.squaredNorm());
}

/// The segments of `fit`, joined to long ones of four blocks each.
Refit joined(const Refit& fit) {
  Refit result = fit;
  result.segments.clear();
  constexpr std::size_t kBlocks = 4;
  for (std::size_t k = 0; k < fit.segments.size(); k += kBlocks) {
    RobustSegment segment{Eigen::VectorXd(kBlocks * kRows),
                          Eigen::MatrixXd(kBlocks * kRows, 2),
                          Eigen::MatrixXd::Zero(kBlocks * kRows, 0),
                          {}};
    for (std::size_t block = 0; block < kBlocks; ++block) {
      const auto first = static_cast<Eigen::Index>(block) * kRows;
      segment.residual.segment(first, kRows) = fit.segments[k + block].residual;
      segment.values.middleRows(first, kRows) = fit.segments[k + block].values;
      segment.block_of.insert(segment.block_of.end(), kRows, block);
    }
    result.segments.push_back(std::move(segment));
  }
  return result;
}

TEST(CrossValidation, IsTheSameForBlocksOfLongSegments) {
  const Refit fit = regression(4);
  const Refit long_segments = joined(fit);
  Folds folds;
  for (std::size_t k = 0; k < long_segments.segments.size(); ++k) {
    folds.emplace_back();
    for (std::size_t block = 0; block < 4; ++block) folds.back().push_back((4 * k + block) % 5);
  }
  const Eigen::VectorXd apart = held_out_deviance(fit, five_folds());
  const Eigen::VectorXd together = held_out_deviance(long_segments, folds);
  ASSERT_EQ(together.size(), apart.size());
  EXPECT_LT((together - apart).cwiseAbs().maxCoeff(), 1e-9);
}

/// Leaving a block out leaves its readings out of what is known of the start, too.
TEST(CrossValidation, AStartIsToldByTheBlocksThatStay) {
  SeededNoise random(5, 2);
  const RobustSegment segment{normal(kRows, 1, random), normal(kRows, 2, random), normal(kRows, 2, random), [] {
                                std::vector<std::size_t> halves(kRows, 0);
                                std::fill(halves.begin() + kRows / 2, halves.end(), 1);
                                return halves;
                              }()};
  const Normals normals = normals_of({segment}, {Eigen::VectorXd::Ones(kRows)}, {{0, 1}});
  ASSERT_EQ(normals.without.size(), 2U);
  const Eigen::Index half = kRows / 2;
  const RobustSegment first{segment.residual.head(half), segment.values.topRows(half), segment.state.topRows(half),
                            std::vector<std::size_t>(half, 0)};
  const WeightedSegment alone = weighted(first, Eigen::VectorXd::Ones(half));
  EXPECT_TRUE(normals.without[1].gram.isApprox(alone.values.transpose() * alone.values, 1e-9));
  EXPECT_TRUE(normals.without[1].score.isApprox(alone.values.transpose() * alone.residual, 1e-9));
}

/// What is known of a value beforehand draws its estimate; no reading is predicted better or worse for it.
TEST(CrossValidation, DoesNotCountWhatIsKnownOfValuesBeforehand) {
  Refit without = regression(4);
  for (RobustSegment& segment : without.segments) segment.values.setZero();
  Refit with = without;
  for (RobustSegment& segment : with.segments) {
    segment.residual.conservativeResize(kRows + 1);
    segment.residual(kRows) = 7.0;
    segment.values = Eigen::MatrixXd::Zero(kRows + 1, segment.values.cols());
    segment.state = Eigen::MatrixXd::Zero(kRows + 1, segment.state.cols());
    segment.priors_of_values = 1;
  }
  EXPECT_EQ(held_out_deviance(with, five_folds()), held_out_deviance(without, five_folds()));
  for (RobustSegment& segment : with.segments) segment.priors_of_values = 0;
  EXPECT_NE(held_out_deviance(with, five_folds()), held_out_deviance(without, five_folds()));
}

/// A segment that is left out takes its readings along, not its share of that.
TEST(CrossValidation, LeavesInWhatIsKnownOfValuesBeforehand) {
  Refit fit = regression(4);
  const Eigen::RowVector2d prior(0.0, 3.0);
  std::vector<Eigen::VectorXd> weights(kSegments, Eigen::VectorXd::Ones(kRows + 1));
  const std::vector<RobustSegment> readings = fit.segments;
  for (RobustSegment& segment : fit.segments) {
    segment.residual.conservativeResize(kRows + 1);
    segment.residual(kRows) = 0.5;
    segment.values.conservativeResize(kRows + 1, Eigen::NoChange);
    segment.values.row(kRows) = prior;
    segment.state = Eigen::MatrixXd::Zero(kRows + 1, 0);
    segment.priors_of_values = 1;
  }
  const Folds folds = five_folds();
  const Normals normals = normals_of(fit.segments, weights, folds);
  for (std::size_t fold = 0; fold < 5; ++fold) {
    Eigen::MatrixXd gram = kSegments * prior.transpose() * prior;
    Eigen::VectorXd score = kSegments * 0.5 * prior.transpose();
    for (std::size_t k = 0; k < kSegments; ++k) {
      if (folds[k].front() == fold) continue;
      gram += readings[k].values.transpose() * readings[k].values;
      score += readings[k].values.transpose() * readings[k].residual;
    }
    EXPECT_TRUE(normals.without[fold].gram.isApprox(gram, 1e-9));
    EXPECT_LT((normals.without[fold].score - score).norm(), 1e-9);
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
  const Folds folds = five_folds();
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

/// Segments of half a second, or, of `blocks`, of as many halves.
struct Cut {
  Cut(std::size_t trials, int each, int blocks) {
    std::vector<std::vector<RowBins::Bin>> bins;
    for (std::size_t trial = 0; trial < trials; ++trial)
      for (int i = 0; i < each; ++i) {
        segments.emplace_back();
        segments.back().stretch.trial = trial;
        bins.emplace_back();
        for (double time = 0.0; time < 0.5 * blocks - 1e-9; time += 0.05) bins.back().push_back({0, time, 1.0});
      }
    rows = RowBins(std::move(bins));
  }
  std::vector<Segment> segments;
  RowBins rows{std::vector<std::vector<RowBins::Bin>>{}};
  Folds found() const { return folds(segments, rows); }
};

TEST(Folds, AreTrialsWhereThereAreEnoughAndBlocksOfThemOtherwise) {
  EXPECT_EQ(Cut(4, 2, 1).found(), (Folds{{0}, {0}, {1}, {1}, {2}, {2}, {3}, {3}}));
  EXPECT_EQ(Cut(2, 8, 1).found(),
            (Folds{{0}, {0}, {1}, {1}, {2}, {2}, {3}, {3}, {4}, {4}, {5}, {5}, {6}, {6}, {7}, {7}}));
  EXPECT_EQ(Cut(1, 3, 1).found(), (Folds{{0}, {1}, {2}}));
  EXPECT_EQ(Cut(4, 1, 2).found(), (Folds{{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
  EXPECT_EQ(Cut(2, 2, 4).found(), (Folds{{0, 0, 1, 1}, {2, 2, 3, 3}, {4, 4, 5, 5}, {6, 6, 7, 7}}));
}

}  // namespace
}  // namespace lacuna::test

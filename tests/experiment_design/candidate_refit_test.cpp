#include "experiment_design/candidate_refit.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double kRounding = 1e-10;  // relative

Eigen::VectorXd vector(std::initializer_list<double> values) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) result(i++) = value;
  return result;
}

TEST(CandidateRefit, WithoutAnythingToRefitIsTheDifference) {
  const CandidatePrediction truth{vector({1.0, 2.0, 3.0}), {}},
      candidate{vector({0.0, 2.0, 5.0}), Eigen::MatrixXd(3, 0)};
  EXPECT_EQ(unexplained(truth, candidate), vector({1.0, 0.0, -2.0}));
}

/// Of one value with sensitivity f: |d|² − (f·d)² / (1 + |f|²).
TEST(CandidateRefit, OfOneValueHasAClosedForm) {
  const CandidatePrediction truth{vector({3.0, 1.0, -2.0}), {}};
  const CandidatePrediction candidate{vector({1.0, 1.0, 1.0}), vector({2.0, 0.0, 1.0})};
  EXPECT_NEAR(unexplained(truth, candidate).squaredNorm(), 13.0 - 1.0 / 6.0, 13.0 * kRounding);
  // Three trials are three times the information: 3·13 − 9·1 / (1 + 3·5).
  EXPECT_NEAR(unexplained(truth, candidate, 3.0).squaredNorm(), 39.0 - 9.0 / 16.0, 39.0 * kRounding);
}

/// A linear model y = a t + b t², its candidate y = c t with c known to one deviation s from the data so far: least
/// squares on the new readings and the old knowledge together, by the weighing of normal equations.
TEST(CandidateRefit, OfLinearModelsIsTheirLeastSquaresFit) {
  const Eigen::Index samples = 50;
  const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(samples, 0.0, 1.0);
  const double a = 1.0, b = 0.4, c = 1.1, s = 0.3, noise = 0.01;
  const Eigen::VectorXd one = (a * t.array() + b * t.array().square()) / noise, other = c * t.array() / noise;
  const double fitted =
      (t.dot(noise * one) / (noise * noise) + c / (s * s)) / (t.squaredNorm() / (noise * noise) + 1.0 / (s * s));
  const double cost =
      (noise * one - fitted * t).squaredNorm() / (noise * noise) + (fitted - c) * (fitted - c) / (s * s);
  const Eigen::VectorXd left = unexplained({one, {}}, {other, s * t / noise});
  EXPECT_NEAR(left.squaredNorm(), cost, cost * kRounding);
  EXPECT_NEAR(left(samples), (fitted - c) / s, kRounding) << "the last row is how far the value moved";
}

TEST(CandidateRefit, OfALinearModelDoesNotDependOnHowFarItHasMoved) {
  const CandidatePrediction truth{vector({3.0, 1.0, -2.0}), {}};
  const CandidatePrediction candidate{vector({1.0, 1.0, 1.0}), vector({2.0, 0.0, 1.0})};
  const CandidatePrediction moved{candidate.readings + 0.7 * candidate.follows.col(0), candidate.follows,
                                  vector({0.7})};
  for (const double trials : {1.0, 10.0})
    EXPECT_LT((unexplained(truth, moved, trials) - unexplained(truth, candidate, trials)).norm(), kRounding);
}

/// min over u of |d − F u|² + |u|² = dᵀ (1 + F Fᵀ)⁻¹ d.
TEST(CandidateRefit, IsTheDistanceUnderTheCandidatesPredictiveCovariance) {
  const Eigen::MatrixXd follows = Eigen::MatrixXd::Random(20, 4) * 3.0;
  const Eigen::VectorXd difference = Eigen::VectorXd::Random(20);
  const Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(20, 20) + follows * follows.transpose();
  const double distance = difference.dot(covariance.inverse() * difference);
  const CandidatePrediction truth{difference, {}}, candidate{Eigen::VectorXd::Zero(20), follows};
  EXPECT_NEAR(unexplained(truth, candidate).squaredNorm(), distance, distance * kRounding);
}

}  // namespace
}  // namespace lacuna

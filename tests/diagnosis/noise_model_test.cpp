#include "diagnosis/noise/noise_model.h"

#include "diagnosis/synthetic_segments.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <cmath>
#include <memory>

namespace lacuna::test {
namespace {

constexpr double kSensor = 1.3, kForce = 0.4;

/// Residuals drawn from white sensor noise and a white random force; starts off by anything.
std::vector<LinearSegment> drawn(const NoiseModel& truth, std::uint64_t seed) {
  SeededNoise random(seed, 0);
  std::vector<LinearSegment> segments;
  for (std::size_t k = 0; k < truth.segments(); ++k) {
    const Eigen::MatrixXd factor = truth.covariance(k).llt().matrixL();
    const Eigen::MatrixXd state = free_start();
    segments.push_back(
        {factor * normal(kRows, 1, random) + state * normal(2, 1, random), normal(kRows, 2, random), state});
  }
  return segments;
}

double deviation_of(const NoiseModel& noise, NoiseComponent::Kind kind) {
  for (const NoiseComponent& one : noise.components())
    if (one.kind == kind) return one.deviation;
  return 0.0;
}

/// −2 log likelihood of all residuals at once, but for a constant: noise, free starts, and what values and columns span
/// with, a priori, the power of the residuals in each direction.
double minus_two_log_likelihood(const NoiseModel& noise, const std::vector<LinearSegment>& segments,
                                const std::vector<Eigen::MatrixXd>& columns) {
  const Eigen::Index rows = Eigen::Index{kRows} * kSegments;
  const Eigen::Index explained = segments.front().values.cols() + columns.front().cols();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(rows, rows), span(rows, explained);
  Eigen::VectorXd residual(rows);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const auto first = static_cast<Eigen::Index>(k) * kRows;
    covariance.block(first, first, kRows, kRows) =
        noise.covariance(k) + segments[k].state * segments[k].state.transpose();
    span.middleRows(first, kRows) << segments[k].values, columns[k];
    residual.segment(first, kRows) = segments[k].residual;
  }
  const Eigen::MatrixXd basis =
      Eigen::HouseholderQR<Eigen::MatrixXd>(span).householderQ() * Eigen::MatrixXd::Identity(rows, explained);
  covariance += residual.squaredNorm() * basis * basis.transpose();
  const Eigen::LLT<Eigen::MatrixXd> solver(covariance);
  return 2.0 * solver.matrixLLT().diagonal().array().log().sum() + residual.dot(solver.solve(residual));
}

class NoiseModelTest : public testing::Test {
 protected:
  NoiseModelTest() : bins_(one_channel()), truth_(bins_, pushed_mass()), estimate_(bins_, pushed_mass()) {
    truth_.set_deviations({kSensor, 0.0, kForce, 0.0});
  }
  RowBins bins_;
  NoiseModel truth_, estimate_;
};

TEST_F(NoiseModelTest, TellsSensorNoiseFromRandomForce) {
  const std::vector<Eigen::MatrixXd> none(kSegments, Eigen::MatrixXd(kRows, 0));
  estimate_noise(estimate_, drawn(truth_, 1), none, 1);
  // Standard errors are about 2 % and 7 %: 1200 rows, 400 pulses of which the start takes some.
  EXPECT_NEAR(deviation_of(estimate_, NoiseComponent::Kind::sensor), kSensor, 0.1 * kSensor);
  EXPECT_NEAR(deviation_of(estimate_, NoiseComponent::Kind::force), kForce, 0.25 * kForce);
}

/// What a candidate could explain must not pass for noise.
TEST_F(NoiseModelTest, LeavesOutWhatTheColumnsExplain) {
  SeededNoise random(3, 7);
  std::vector<LinearSegment> segments = drawn(truth_, 2);
  std::vector<Eigen::MatrixXd> columns;
  for (LinearSegment& segment : segments) {
    columns.push_back(normal(kRows, 1, random));
    segment.residual += 20.0 * columns.back();
  }
  estimate_noise(estimate_, segments, columns, 1);
  EXPECT_NEAR(deviation_of(estimate_, NoiseComponent::Kind::sensor), kSensor, 0.1 * kSensor);
}

/// Wrong slopes would end the search elsewhere. One component has a least deviation, at which it stays.
TEST_F(NoiseModelTest, EndsWhereNoOtherDeviationIsLikelier) {
  SeededNoise random(5, 7);
  const std::vector<LinearSegment> segments = drawn(truth_, 4);
  std::vector<Eigen::MatrixXd> columns;
  for (int k = 0; k < kSegments; ++k) columns.push_back(normal(kRows, 3, random));
  estimate_.require_force(0, 1.5 * kForce);
  estimate_noise(estimate_, segments, columns, 1);
  const std::vector<double> found = estimate_.deviations();
  EXPECT_NEAR(deviation_of(estimate_, NoiseComponent::Kind::force), 1.5 * kForce, 1e-9);
  const double best = minus_two_log_likelihood(estimate_, segments, columns);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const double factor : {0.9, 1.1}) {
      std::vector<double> other = found;
      other[i] = std::max(factor * other[i], estimate_.least()[i]);
      estimate_.set_deviations(other);
      EXPECT_GT(minus_two_log_likelihood(estimate_, segments, columns), best - 0.05) << i << " times " << factor;
    }
}

TEST_F(NoiseModelTest, GivesTheSameDigitsWithAnyThreads) {
  const std::vector<Eigen::MatrixXd> none(kSegments, Eigen::MatrixXd(kRows, 0));
  NoiseModel other(bins_, pushed_mass());
  estimate_noise(estimate_, drawn(truth_, 1), none, 1);
  estimate_noise(other, drawn(truth_, 1), none, 3);
  EXPECT_EQ(estimate_.deviations(), other.deviations());
}

TEST(BoundedResponses, AreTheOnesGivenUnlessADirectionReachesTooFar) {
  Eigen::MatrixXd state = free_start();
  EXPECT_EQ(bounded_responses(state), state);
  const Eigen::VectorXd own = state.col(0);
  state.col(1) = 3e6 * state.col(1) + 2.0 * own;
  const Eigen::MatrixXd bounded = bounded_responses(state);
  EXPECT_NEAR(bounded.norm(), 1e5, 1.0);
  const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd::Identity(kRows, kRows) + bounded * bounded.transpose());
  ASSERT_EQ(factor.info(), Eigen::Success);
  const Eigen::VectorXd far = state.col(1).normalized();  // what such a start can do is no evidence any more
  EXPECT_LT(far.dot(factor.solve(far)), 1e-8);
  const Eigen::VectorXd near = (own - far * far.dot(own)).normalized();  // and what it cannot stays as it was
  EXPECT_NEAR(near.dot(bounded * bounded.transpose() * near), near.dot(state * state.transpose() * near), 1.0);
}

/// White noise of deviation 1, a doubt c in every bin as one random number, and slow noise of the same size.
TEST(DoubtfulNoise, IsNeverSmallerThanTheDoubts) {
  constexpr double kDoubt = 3.0;
  const RowBins bins = one_channel();
  NoiseModel noise(bins, {}, std::vector<Eigen::MatrixXd>(kSegments, Eigen::MatrixXd::Constant(kRows, 1, kDoubt)));
  ASSERT_EQ(noise.components().back().kind, NoiseComponent::Kind::doubt);
  EXPECT_EQ(noise.least().back(), 1.0);
  const Eigen::MatrixXd covariance = noise.covariance(0);
  for (Eigen::Index a : {0, 7})
    for (Eigen::Index b = 0; b < kRows; ++b) {
      const double apart = kInterval * std::abs(static_cast<double>(a - b));
      const double expected = (a == b ? 1.0 : 0.0) + kDoubt * kDoubt * (1.0 + std::exp(-apart / kSlowSensor));
      EXPECT_NEAR(covariance(a, b), expected, 1e-12);
    }
}

/// Two channels in turns, of two and three samples a bin, without random forces.
struct TwoChannels {
  TwoChannels() {
    std::vector<RowBins::Bin> own;
    for (std::size_t row = 0; row < 7; ++row)
      own.push_back({row % 2, 0.01 * static_cast<double>(row), row % 2 == 0 ? 2.0 : 3.0});
    noise = std::make_unique<NoiseModel>(RowBins({own}), ForceResponses{});
  }

  std::unique_ptr<NoiseModel> noise;
  std::vector<double> deviations = {1.5, 0.5, 2.0, 3.0};  ///< white of each, slow of each
};

TEST(NoiseOfTwoChannels, IsOfEachAlone) {
  TwoChannels two;
  two.noise->set_deviations(two.deviations);
  const Eigen::MatrixXd covariance = two.noise->covariance(0);
  for (Eigen::Index a = 0; a < 7; ++a)
    for (Eigen::Index b = 0; b < 7; ++b) {
      const bool second = a % 2 == 1;
      const double white = second ? 0.25 / 3.0 : 2.25 / 2.0, slow = second ? 9.0 : 4.0;
      const double apart = 0.01 * static_cast<double>(std::abs(a - b));
      const double same = (a == b ? white : 0.0) + slow * std::exp(-apart / kSlowSensor);
      EXPECT_NEAR(covariance(a, b), (a - b) % 2 == 0 ? same : 0.0, 1e-12);
    }
}

TEST(NoiseOfTwoChannels, HasTheSlopesOfItsTraces) {
  constexpr double kStep = 1e-4;
  TwoChannels two;
  SeededNoise random(3, 0);
  const Eigen::MatrixXd root = normal(7, 7, random), weights = root * root.transpose();
  const auto trace = [&](std::size_t which, double step) {
    std::vector<double> moved = two.deviations;
    moved[which] *= std::exp(step);
    two.noise->set_deviations(moved);
    return (weights * two.noise->covariance(0)).trace();
  };
  two.noise->set_deviations(two.deviations);
  const Eigen::VectorXd slopes = two.noise->slopes(0, weights);
  for (std::size_t i = 0; i < two.deviations.size(); ++i)
    EXPECT_NEAR(slopes(static_cast<Eigen::Index>(i)), (trace(i, kStep) - trace(i, -kStep)) / (2.0 * kStep), 1e-5);
}

}  // namespace
}  // namespace lacuna::test

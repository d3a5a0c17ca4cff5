#include "diagnosis/noise_model.h"

#include "diagnosis/synthetic_segments.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

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

TEST_F(NoiseModelTest, GivesTheSameDigitsWithAnyThreads) {
  const std::vector<Eigen::MatrixXd> none(kSegments, Eigen::MatrixXd(kRows, 0));
  NoiseModel other(bins_, pushed_mass());
  estimate_noise(estimate_, drawn(truth_, 1), none, 1);
  estimate_noise(other, drawn(truth_, 1), none, 3);
  EXPECT_EQ(estimate_.deviations(), other.deviations());
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

}  // namespace
}  // namespace lacuna::test

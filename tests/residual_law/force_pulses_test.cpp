#include "residual_law/force_pulses.h"

#include "residual_law/pendulum_data.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

struct Pulsed {
  PendulumData data{two_recordings({.damping = 0.02})};
  PendulumData::Fitted fitted = data.fitted();
  const PredictionLadder& ladder = data.data().deciding();
  ForcePulses pulses = force_pulses(data.data(), fitted.model, ladder, joint_courses(data.data()).at(0));
};

const Pulsed& pulsed() {
  static const Pulsed one;
  return one;
}

TEST(ForcePulsesTest, CoverEachStretchWithoutAGap) {
  const Pulsed& one = pulsed();
  ASSERT_EQ(one.pulses.samples.size(), one.ladder.stretches.size());
  for (std::size_t k = 0; k < one.ladder.stretches.size(); ++k) {
    const auto& samples = one.pulses.samples[k];
    ASSERT_FALSE(samples.empty());
    EXPECT_LE(samples.size(), 12U);
    EXPECT_EQ(samples.front().first, 0);
    EXPECT_EQ(samples.back().second, one.ladder.stretches[k].stretch.size() - 1);
    for (std::size_t p = 1; p < samples.size(); ++p) EXPECT_EQ(samples[p].first, samples[p - 1].second);
    EXPECT_EQ(one.pulses.responses[k].cols(), static_cast<Eigen::Index>(samples.size()));
    EXPECT_EQ(one.pulses.responses[k].rows(), static_cast<Eigen::Index>(one.ladder.stretches[k].rows.size()));
  }
}

/// All together are a unit of force from the start on: ½ t²/I in a tenth of a second, before gravity matters.
TEST(ForcePulsesTest, TogetherAreTheResponseToAConstantForce) {
  const Pulsed& one = pulsed();
  ASSERT_EQ(one.ladder.stretches[0].length, 0U);
  const Eigen::VectorXd response = one.pulses.responses[0].rowwise().sum();
  const double seconds = 0.01 * static_cast<double>(one.ladder.stretches[0].rows.back());
  EXPECT_LT(seconds, 0.15);
  const double expected = 0.5 * seconds * seconds / kModelInertia / one.ladder.noise[0].deviation;
  EXPECT_NEAR(response(response.size() - 1), expected, 0.08 * expected);
}

TEST(ForcePulsesTest, ChangeNoReadingBeforeThem) {
  const Pulsed& one = pulsed();
  const auto& samples = one.pulses.samples[0];
  const std::size_t last = samples.size() - 1;
  const PredictedStretch& stretch = one.ladder.stretches[0];
  const Eigen::VectorXd response = one.pulses.responses[0].col(static_cast<Eigen::Index>(last));
  for (std::size_t row = 0; row < stretch.rows.size() && stretch.rows[row] <= samples[last].first; ++row)
    EXPECT_NEAR(response(static_cast<Eigen::Index>(row)), 0.0, 1e-6) << row;
  EXPECT_GT(response(response.size() - 1), 0.0);
}

}  // namespace
}  // namespace lacuna

#include "prediction/random_walk_smoother.h"

#include "fitting/numerics/seeded_noise.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

/// A swing, read with noise at times that jitter.
struct Swing {
  std::vector<double> times, positions, velocities;
  double frequency = 5.0, noise = 1e-3, velocity_noise = 0.05;

  double position(double t) const { return t < rest ? 0.0 : 0.5 * (1.0 - std::cos(frequency * (t - rest))); }
  double velocity(double t) const { return t < rest ? 0.0 : 0.5 * frequency * std::sin(frequency * (t - rest)); }
  double rest = 0.0;  ///< s before it begins

  void read(int samples, double interval, bool with_velocities = false) {
    SeededNoise random(7, 0);
    for (int i = 0; i < samples; ++i) {
      const double t = (i + 0.3 * std::sin(17.0 * i)) * interval;
      times.push_back(t);
      positions.push_back(position(t) + noise * random.normal());
      if (with_velocities) velocities.push_back(velocity(t) + velocity_noise * random.normal());
    }
  }
  /// RMS over samples of what is smoothed, off the truth, in its own standard deviations.
  double off(const SmoothedMotion& motion, int component) const {
    double squares = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double error =
          component == 0 ? motion.positions[i] - position(times[i]) : motion.velocities[i] - velocity(times[i]);
      squares += error * error / motion.covariances[i](component, component);
    }
    return std::sqrt(squares / static_cast<double>(times.size()));
  }
};

TEST(RandomWalkSmoother, KnowsHowFarOffItIs) {
  for (const double interval : {0.002, 0.02}) {
    Swing swing;
    swing.read(1000, interval);
    const SmoothedMotion motion = smooth_motion({swing.times, swing.positions, {}});
    EXPECT_NEAR(motion.position_noise, swing.noise, 0.15 * swing.noise) << interval;
    for (const int component : {0, 1}) {
      EXPECT_GT(swing.off(motion, component), 0.5) << interval;
      EXPECT_LT(swing.off(motion, component), 1.5) << interval;
    }
    EXPECT_LT(std::sqrt(motion.covariances[500](0, 0)), swing.noise);
  }
}

TEST(RandomWalkSmoother, ReadingsOfTheVelocityHelp) {
  Swing alone, both;
  alone.read(400, 0.01);
  both.velocity_noise = 0.01;
  both.read(400, 0.01, true);
  const SmoothedMotion without = smooth_motion({alone.times, alone.positions, {}});
  const SmoothedMotion with = smooth_motion({both.times, both.positions, both.velocities});
  EXPECT_NEAR(with.velocity_noise, 0.01, 0.002);
  EXPECT_LT(with.covariances[200](1, 1), 0.7 * without.covariances[200](1, 1));
  EXPECT_LT(both.off(with, 1), 1.5);
}

/// The sizes are those of the whole motion, not of the rest that it begins with.
TEST(RandomWalkSmoother, ALongRestAtFirstDoesNotBlindIt) {
  Swing swing;
  swing.rest = 20.0;
  swing.noise = 1e-4;
  swing.read(12000, 0.005);
  for (std::size_t i = 0; swing.times[i] < swing.rest; ++i) swing.positions[i] = 0.0;
  const SmoothedMotion motion = smooth_motion({swing.times, swing.positions, {}});
  for (std::size_t i = 6000; i < 12000; i += 100) {
    EXPECT_NEAR(motion.positions[i], swing.position(swing.times[i]), 1e-3);
    EXPECT_NEAR(motion.velocities[i], swing.velocity(swing.times[i]), 0.1);
  }
}

TEST(RandomWalkSmoother, WhatIsNotReadIsFilledIn) {
  Swing swing;
  swing.read(400, 0.01);
  for (std::size_t i = 1; i < 400; i += 2) swing.positions[i] = std::nan("");
  for (std::size_t i = 180; i < 220; ++i) swing.positions[i] = std::nan("");
  const SmoothedMotion motion = smooth_motion({swing.times, swing.positions, {}});
  EXPECT_LT(swing.off(motion, 0), 1.5);
  EXPECT_GT(motion.covariances[200](0, 0), 4.0 * motion.covariances[100](0, 0));
}

TEST(RandomWalkSmoother, AnOutlierMovesItLittle) {
  Swing swing;
  swing.read(400, 0.01);
  swing.positions[200] += 3.0;
  const SmoothedMotion motion = smooth_motion({swing.times, swing.positions, {}});
  EXPECT_NEAR(motion.positions[203], swing.position(swing.times[203]), 0.02);
}

TEST(RandomWalkSmoother, TooFewReadingsAreRefused) {
  const std::vector<double> times = {0.0, 0.1, 0.2, 0.3}, positions = {0.0, 1.0, 2.0, 3.0};
  EXPECT_THROW(smooth_motion({times, positions, {}}), Error);
}

}  // namespace
}  // namespace lacuna

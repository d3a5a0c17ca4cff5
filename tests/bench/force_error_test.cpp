#include "bench/force_error.h"
#include "data_checks/recorded_pendulum.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double kCutoff = 10.0;       // Hz
constexpr double kDryFriction = 0.03;  // N·m

/// Of the pendulum's model, which lacks nothing but what a recording hides.
double force_lacking(const PendulumTruth& truth) {
  const RecordedPendulum pendulum(truth);
  return force_error(*pendulum.model, pendulum.trials.front(), pendulum.values, kCutoff).rms;
}

TEST(ForceError, IsThatOfTheForceWhichTheModelLacks) {
  EXPECT_LT(force_lacking({.noise = 1e-6}), 0.1 * kDryFriction);
  EXPECT_NEAR(force_lacking({.friction = kDryFriction, .noise = 1e-6}), kDryFriction, 0.2 * kDryFriction);
}

}  // namespace
}  // namespace lacuna

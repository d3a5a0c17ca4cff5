#include "support/reference_integration.h"

#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

void harmonic(const ReferenceState& x, ReferenceState& dx, double) { dx = {x[1], -4.0 * x[0]}; }

TEST(IntegrateSmooth, FollowsAHarmonicOscillator) {
  const auto states = integrate_smooth(harmonic, {1.0, 0.0}, {0.0, 1.0, 5.0});
  ASSERT_EQ(states.size(), 3U);
  EXPECT_NEAR(states[1][0], std::cos(2.0), kRounding);
  EXPECT_NEAR(states[2][1], -2.0 * std::sin(10.0), kRounding);
}

TEST(IntegrateInSteps, FollowsAHarmonicOscillator) {
  EXPECT_NEAR(integrate_in_steps(harmonic, {1.0, 0.0}, {0.0, 5.0}, 1e-3).back()[0], std::cos(10.0), kRounding);
}

FrictionSystem rough(double push) {
  return {.inertia = 2.0,
          .force = [push](double time, double, double) { return time < 2.0 ? 0.0 : push; },
          .friction_max = [](double, double, double) { return 4.0; }};
}

TEST(IntegrateWithFriction, StopsAfterTheKnownDistanceAndStays) {
  const auto states = integrate_with_friction(rough(3.9), {0.0, -1.0}, {0.0, 0.3, 1.0, 4.0}, 1e-3);
  EXPECT_NEAR(states[1].v, -0.4, kRounding);
  EXPECT_NEAR(states[2].q, -0.25, kRounding);
  EXPECT_EQ(states[3].v, 0.0);
  EXPECT_NEAR(states[3].q, -0.25, kRounding);
}

TEST(IntegrateWithFriction, BreaksAwayAboveTheLimit) {
  const auto states = integrate_with_friction(rough(5.0), {0.0, 1.0}, {0.0, 2.0, 3.0}, 1e-3);
  EXPECT_NEAR(states[2].v, 0.5, kRounding);
}

}  // namespace
}  // namespace lacuna

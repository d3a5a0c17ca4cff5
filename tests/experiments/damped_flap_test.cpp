#include "flap.h"

#include "experiments/committed_recording.h"

#include <gtest/gtest.h>

#include <cmath>

namespace damped_flap {
namespace {

constexpr double kStep = 2e-5;  // s, as the generator's
constexpr double kIntegrationTolerance = 1e-10;

Motion run(const Truth& truth, Motion motion, double duration) {
  const long steps = std::lround(duration / kStep);
  for (long i = 0; i < steps; ++i) motion = advance(truth, motion, 0.0, 0.0, kStep);
  return motion;
}

/// Without gravity, J dv/dq = −c r² sin²(q/2), of which the integral is elementary.
TEST(DampedFlap, TheDamperTakesTheVelocityThatItsLeverArmSays) {
  Truth truth;
  truth.gravity_torque = truth.damping = 0.0;
  const double velocity = 3.0;
  const Motion end = run(truth, {-0.4, velocity}, 0.5);
  ASSERT_GT(end.angle, 0.8);
  const double strength = truth.damper * truth.damper_radius * truth.damper_radius;
  const auto taken = [&](double q) { return strength / truth.inertia * 0.5 * (q - std::sin(q)); };
  EXPECT_NEAR(end.velocity, velocity - (taken(end.angle) - taken(-0.4)), kIntegrationTolerance);
  EXPECT_LT(end.velocity, 0.97 * velocity);
}

TEST(DampedFlap, WithoutDampersEnergyIsKept) {
  Truth truth;
  truth.damper = truth.damping = 0.0;
  const auto energy = [&](const Motion& at) {
    return 0.5 * truth.inertia * at.velocity * at.velocity - truth.gravity_torque * std::cos(at.angle);
  };
  const Motion start{0.9, 0.0};
  EXPECT_NEAR(energy(run(truth, start, 1.0)), energy(start), kIntegrationTolerance);
}

TEST(DampedFlap, ACommandRampCarriesAFreeFlapAsTheCubeOfTime) {
  Truth truth;
  truth.gravity_torque = truth.damping = truth.damper = 0.0;
  const double slope = 0.02;  // N·m/s
  Motion motion;
  for (int i = 0; i < 1000; ++i) motion = advance(truth, motion, slope * kStep * i, slope, kStep);
  EXPECT_NEAR(motion.angle, slope * std::pow(1000 * kStep, 3) / 6.0 / truth.inertia, kIntegrationTolerance);
}

class Recording : public testing::TestWithParam<const char*> {};

TEST_P(Recording, IsWhatTheGeneratorWrites) {
  bench::expect_committed("damped_flap", GetParam(), recording_file(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(DampedFlap, Recording, testing::ValuesIn(kTrials),
                         [](const auto& trial) { return std::string(trial.param); });

}  // namespace
}  // namespace damped_flap

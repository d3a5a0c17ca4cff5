#include "bench.h"
#include "recording_file.h"
#include "stick_slip.h"

#include "experiments/committed_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace servo_pendulum {
namespace {

constexpr double kStep = 1e-5;  // s, as the generator's
constexpr double kIntegrationTolerance = 1e-10;

Motion run(const Pendulum& pendulum, Motion motion, const LinearTorque& torque, double duration) {
  const long steps = std::lround(duration / kStep);
  for (long i = 0; i < steps; ++i) {
    const double time = static_cast<double>(i) * kStep;
    motion = advance(pendulum, motion, {torque.at(time), torque.slope}, kStep);
  }
  return motion;
}

TEST(StickSlip, CoulombFrictionStopsTheArmAfterItsKineticEnergyIsSpent) {
  const Pendulum pendulum{.inertia = 0.03, .friction = 0.024};
  const double velocity = 1.7;
  const Motion end = run(pendulum, {0.1, velocity}, {}, 3.0);
  const double distance = 0.5 * pendulum.inertia * velocity * velocity / pendulum.friction;
  EXPECT_NEAR(end.angle, 0.1 + distance, kIntegrationTolerance);
  EXPECT_EQ(end.velocity, 0.0);
}

TEST(StickSlip, TheArmBreaksAwayWhenTheTorqueExceedsFriction) {
  const Pendulum pendulum{.inertia = 0.03, .friction = 0.024};
  const LinearTorque torque{0.0, 0.1};
  const double at = pendulum.friction / torque.slope;  // 0.24 s
  EXPECT_EQ(run(pendulum, {}, torque, at - 0.001).velocity, 0.0);
  const double after = 0.3333;
  const Motion end = run(pendulum, {}, torque, at + after);
  EXPECT_NEAR(end.velocity, torque.slope * after * after / 2 / pendulum.inertia, kIntegrationTolerance);
  EXPECT_NEAR(end.angle, torque.slope * std::pow(after, 3) / 6 / pendulum.inertia, kIntegrationTolerance);
}

TEST(StickSlip, ALargeSwingReturnsAfterThePeriodOfTheEllipticIntegral) {
  const Pendulum pendulum{.inertia = 0.03, .gravity_torque = 1.2};
  const double amplitude = 1.4;
  const double period =
      4.0 * std::sqrt(pendulum.inertia / pendulum.gravity_torque) * std::comp_ellint_1(std::sin(amplitude / 2));
  // A quarter of the way the angle passes zero, at the speed that the potential energy buys.
  const double whole_steps = std::floor(period / 4 / kStep);
  Motion motion = run(pendulum, {amplitude, 0.0}, {}, whole_steps * kStep);
  motion = advance(pendulum, motion, {}, period / 4 - whole_steps * kStep);
  const double speed = std::sqrt(2.0 * pendulum.gravity_torque * (1.0 - std::cos(amplitude)) / pendulum.inertia);
  EXPECT_NEAR(motion.angle, 0.0, kIntegrationTolerance);
  EXPECT_NEAR(motion.velocity, -speed, kIntegrationTolerance);
}

TEST(StickSlip, ViscousDampingDecaysExponentially) {
  const Pendulum pendulum{.inertia = 0.03, .damping = 0.021};
  const Motion end = run(pendulum, {0.0, 2.0}, {}, 1.0);
  EXPECT_NEAR(end.velocity, 2.0 * std::exp(-pendulum.damping / pendulum.inertia), kIntegrationTolerance);
}

TEST(Excitation, IsARestThenATorqueInWholeQuanta) {
  const Truth truth;
  for (const char* trial : kTrials) {
    const std::vector<double> commands = excitation(trial, truth);
    double largest = 0.0;
    for (std::size_t k = 0; k < commands.size(); ++k) {
      if (static_cast<double>(k) * kSampleInterval < kRest) {
        EXPECT_EQ(commands[k], 0.0) << trial;
      }
      EXPECT_NEAR(std::remainder(commands[k], truth.command_quantum), 0.0, 1e-12) << trial;
      largest = std::max(largest, std::abs(commands[k]));
    }
    EXPECT_GT(largest, 5.0 * truth.friction) << trial;
  }
}

class Recording : public testing::TestWithParam<const char*> {};

TEST_P(Recording, IsWhatTheGeneratorWrites) {
  bench::expect_committed("servo_pendulum", GetParam(), recording_file(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(ServoPendulum, Recording, testing::ValuesIn(kTrials),
                         [](const auto& trial) { return std::string(trial.param); });

}  // namespace
}  // namespace servo_pendulum

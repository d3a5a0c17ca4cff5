#include "servo.h"

#include "experiments/committed_recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lifting_servo {
namespace {

/// A weight stays where its torque is within what the gear's friction adds or takes: a goal is reached to a sag between
/// m g l sin q/(1 + r) and m g l sin q/(1 − r) over the servo's stiffness.
TEST(LiftingServo, AWeightAtRestSagsByWhatTheGearLetsPass) {
  const Truth truth;
  for (const double weight : {0.1, 0.35}) {
    const std::vector<double> angles = record(std::vector<double>(1000, 1.0), weight, truth, 1);
    const double angle = angles.back();
    EXPECT_NEAR(angle, angles[900], 2.0 * std::numbers::pi / truth.encoder_counts) << "not at rest";
    const double stiffness = truth.gain * truth.kp * truth.supply * truth.constant / truth.resistance;
    const double load = (weight + 0.5 * truth.arm_mass) * truth.arm_length * 9.81 * std::sin(angle);
    EXPECT_GT(1.0 - angle, load / (1.0 + truth.load_friction) / stiffness - 2e-3);
    EXPECT_LT(1.0 - angle, load / (1.0 - truth.load_friction) / stiffness + 2e-3);
  }
}

/// On a steady voltage without a weight's torque, kt·ω is what the voltage leaves: friction takes no share of none.
TEST(LiftingServo, AtItsLimitItRunsAtTheSpeedOfItsBackEmf) {
  Truth truth;
  truth.arm_mass = 0.0;
  truth.sensor_noise = 0.0;
  const std::vector<double> angles = record(std::vector<double>(1500, 1e4), 0.0, truth, 1);
  const double speed = (angles[1499] - angles[1249]) / (250 * kSampleInterval);
  EXPECT_NEAR(speed, truth.duty_limit * truth.supply / truth.constant, 0.01);
}

class LiftingServoRecording : public testing::TestWithParam<const char*> {};

TEST_P(LiftingServoRecording, IsWhatTheGeneratorWrites) {
  bench::expect_committed("lifting_servo", GetParam(), recording_file(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(LiftingServo, LiftingServoRecording, testing::ValuesIn(kTrials), [](const auto& trial) {
  std::string name = trial.param;
  name[name.find('-')] = '_';
  return name;
});

}  // namespace
}  // namespace lifting_servo

#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::joint_law_test {
namespace {

constexpr double kInertia = 2.0;  // kg or kg·m²
constexpr double kStep = 1e-3;

/// Each law acts on a hinge and on a slider in the same numbers.
class JointLaw : public testing::TestWithParam<JointKind> {
 protected:
  RobotSpec robot() const { return one_joint(GetParam(), kInertia); }
};

INSTANTIATE_TEST_SUITE_P(HingeAndSlider, JointLaw, testing::Values(JointKind::hinge, JointKind::slider),
                         [](const auto& test) { return test.param == JointKind::hinge ? "Hinge" : "Slider"; });

TEST_P(JointLaw, ConstantForceAcceleratesEvenly) {
  RobotSpec pushed = robot();
  pushed.joints[0].force = 3.0;
  constexpr double kEnd = 0.9;
  const auto error = [&](double step) {
    const SimulationRun run(pushed, step);
    EXPECT_NEAR(run.last("velocity", kEnd), 3.0 / kInertia * kEnd, kRounding);
    return run.last("position", kEnd) - 3.0 / kInertia * kEnd * kEnd / 2;
  };
  expect_convergence(error, kStep, 1.01 * 3.0 / kInertia * kStep * kEnd / 2);
}

TEST_P(JointLaw, DampingDecaysExponentially) {
  RobotSpec damped = robot();
  damped.joints[0].damping = 5.0;
  constexpr double kEnd = 0.6;
  const double expected = 1.5 * std::exp(-5.0 / kInertia * kEnd);
  const auto error = [&](double step) {
    return SimulationRun(damped, step).from({0.2}, {1.5}).last("velocity", kEnd) - expected;
  };
  constexpr double kDecayError = 2e-3;  // of 1.5
  expect_convergence(error, kStep, kDecayError);
}

TEST_P(JointLaw, StrongDampingIsStable) {
  RobotSpec damped = robot();
  damped.joints[0].damping = 1e6;  // an explicit step would overshoot 500-fold
  EXPECT_NEAR(SimulationRun(damped, kStep).from({0.0}, {1.0}).last("velocity", 0.1), 0.0, kRounding);
}

TEST_P(JointLaw, DryFrictionStopsAfterTheKnownDistance) {
  RobotSpec rough = robot();
  constexpr double kFriction = 4.0, kVelocity = 1.0;  // stops after 0.5 s
  rough.joints[0].dry_friction = kFriction;
  const double distance = kVelocity * kVelocity * kInertia / (2.0 * kFriction);
  const auto error = [&](double step) {
    return SimulationRun(rough, step).from({0.0}, {kVelocity}).last("position", 1.0) - distance;
  };
  expect_convergence(error, kStep, 1.01 * kVelocity * kStep / 2);
}

TEST_P(JointLaw, DryFrictionStopsTheOtherWayToo) {
  RobotSpec rough = robot();
  rough.joints[0].dry_friction = 4.0;
  const double there = SimulationRun(rough, kStep).from({0.0}, {1.0}).last("position", 1.0);
  const double back = SimulationRun(rough, kStep).from({0.0}, {-1.0}).last("position", 1.0);
  EXPECT_NEAR(there, -back, kRounding);
}

TEST_P(JointLaw, DryFrictionHoldsBelowItsLimit) {
  RobotSpec stuck = robot();
  stuck.joints[0].dry_friction = 4.0;
  stuck.joints[0].force = 0.99 * 4.0;
  constexpr double kCreep = 1e-7;  // m or rad in 2 s
  const SimulationRun run(stuck, kStep);
  EXPECT_NEAR(run.last("position", 2.0), 0.0, kCreep);
  EXPECT_NEAR(run.last("velocity", 2.0), 0.0, kCreep);
}

TEST_P(JointLaw, DryFrictionSlidesAboveItsLimit) {
  RobotSpec sliding = robot();
  sliding.joints[0].dry_friction = 4.0;
  sliding.joints[0].force = -1.1 * 4.0;
  EXPECT_NEAR(SimulationRun(sliding, kStep).last("velocity", 2.0), -0.1 * 4.0 / kInertia * 2.0, 1e-6);
}

TEST_P(JointLaw, SpringSwingsWithItsPeriodAboutItsRest) {
  RobotSpec sprung = robot();
  sprung.joints[0].stiffness = 80.0;
  sprung.joints[0].rest = 0.1;
  const double frequency = std::sqrt(80.0 / kInertia);
  constexpr double kEnd = 0.8;
  const double expected = 0.1 + 0.3 * std::cos(frequency * kEnd);
  const auto error = [&](double step) {
    return SimulationRun(sprung, step).from({0.4}, {0.0}).last("position", kEnd) - expected;
  };
  constexpr double kSpringError = 0.01;  // of an amplitude of 0.3
  expect_convergence(error, kStep, kSpringError);
}

TEST_P(JointLaw, StiffSpringIsStable) {
  RobotSpec sprung = robot();
  sprung.joints[0].stiffness = 1e8;
  sprung.joints[0].damping = 1e3;
  EXPECT_NEAR(SimulationRun(sprung, kStep).from({1e-3}, {0.0}).last("position", 0.5), 0.0, 1e-6);
}

TEST_P(JointLaw, DampedSpringAgreesWithItsSolution) {
  RobotSpec sprung = robot();
  sprung.joints[0].stiffness = 80.0;
  sprung.joints[0].damping = 6.0;
  const double decay = 6.0 / (2.0 * kInertia);
  const double frequency = std::sqrt(80.0 / kInertia - decay * decay);
  constexpr double kEnd = 0.7;
  const double expected =
      0.3 * std::exp(-decay * kEnd) * (std::cos(frequency * kEnd) + decay / frequency * std::sin(frequency * kEnd));
  const auto error = [&](double step) {
    return SimulationRun(sprung, step).from({0.3}, {0.0}).last("position", kEnd) - expected;
  };
  expect_convergence(error, kStep, 0.01);
}

TEST_P(JointLaw, ArmatureAddsToTheInertia) {
  RobotSpec heavy = robot();
  heavy.joints[0].armature = 3.0;
  heavy.joints[0].force = 10.0;
  constexpr double kArmatureError = 1e-6;
  EXPECT_NEAR(SimulationRun(heavy, kStep).last("velocity", 1.0), 10.0 / (kInertia + 3.0), kArmatureError);
}

TEST_P(JointLaw, StopsHoldOnBothSides) {
  RobotSpec stopped = robot();
  stopped.joints[0].lower = -0.2;
  stopped.joints[0].upper = 0.3;
  constexpr double kPenetration = 2e-3;  // m or rad
  for (const double push : {5.0, -5.0}) {
    stopped.joints[0].force = push;
    const SimulationRun run(stopped, kStep);
    EXPECT_NEAR(run.last("position", 3.0), push > 0.0 ? 0.3 : -0.2, kPenetration);
    EXPECT_NEAR(run.last("velocity", 3.0), 0.0, 1e-3);
  }
}

TEST_P(JointLaw, StopsDoNotActBetweenThem) {
  RobotSpec stopped = robot();
  stopped.joints[0].lower = -0.2;
  stopped.joints[0].upper = 0.3;
  EXPECT_NEAR(SimulationRun(stopped, kStep).from({0.0}, {0.5}).last("velocity", 0.5), 0.5, kRounding);
}

}  // namespace
}  // namespace lacuna::joint_law_test

#include "simulation/ode/coordinate_law.h"
#include "simulation/physics/stepped_by_ode.h"

#include <gtest/gtest.h>

#include <array>

namespace lacuna::lone_joint_test {
namespace {

constexpr double kSame = 1e-7;  // of the largest reading; ODE solves its rows with a regularisation of 1e-10
constexpr int kSamples = 400;   // 2 s

/// A body on one joint, askew, with every law that a coordinate can have.
RobotSpec rich_robot(JointKind kind) {
  RobotSpec robot = one_joint(kind, 0.2, Eigen::Vector3d(0.3, 1.0, -0.2).normalized());
  robot.gravity = Eigen::Vector3d(0.4, -0.2, -9.81);
  BodySpec& body = robot.bodies[0];
  body.mass = 1.3;
  body.com = Eigen::Vector3d(0.05, 0.02, -0.15);
  body.inertia = {.xx = 0.02, .yy = 0.03, .zz = 0.015, .xy = 0.002, .xz = -0.004, .yz = 0.003};
  JointSpec& joint = robot.joints[0];
  joint.damping = 0.05;
  joint.dry_friction = 0.1;
  joint.stiffness = 1.5;
  joint.rest = 0.1;
  joint.armature = 0.01;
  return robot;
}

/// A body on one joint moves as it does where ODE steps it.
class LoneJoint : public testing::TestWithParam<JointKind> {};

INSTANTIATE_TEST_SUITE_P(HingeAndSlider, LoneJoint, testing::Values(JointKind::hinge, JointKind::slider),
                         [](const auto& test) { return test.param == JointKind::hinge ? "Hinge" : "Slider"; });

TEST_P(LoneJoint, MovesUnderItsLaws) {
  expect_same_motion(
      rich_robot(GetParam()),
      [](SimulationRun& run) {
        run.from({0.6}, {-2.0});
        run.command("motor", {0.0, 0.5, 1.2}, {1.0, -2.0, 0.5}, Hold::zero_order);
      },
      kSame, kSamples);
}

TEST_P(LoneJoint, SticksAndSlips) {
  RobotSpec robot = rich_robot(GetParam());
  robot.joints[0].dry_friction = 3.0;
  expect_same_motion(
      robot,
      [](SimulationRun& run) {
        run.from({0.2}, {1.5});
        run.command("motor", {0.0, 0.7, 1.2}, {0.0, 12.0, 1.0}, Hold::zero_order);
      },
      kSame, kSamples);
}

TEST_P(LoneJoint, RunsIntoItsStops) {
  RobotSpec robot = rich_robot(GetParam());
  robot.joints[0].dry_friction = 0.0;  // how a stop and sticking friction share a force is up to rounding
  robot.joints[0].lower = -0.2;
  robot.joints[0].upper = 0.3;
  expect_same_motion(
      robot,
      [](SimulationRun& run) {
        run.from({0.1}, {1.0});
        run.command("motor", {0.0, 0.5}, {8.0, -12.0}, Hold::zero_order);
      },
      kSame, kSamples);
}

TEST_P(LoneJoint, FollowsAServo) {
  RobotSpec robot = rich_robot(GetParam());
  ActuatorSpec& motor = robot.actuators[0];
  motor.kind = ActuatorKind::pid;
  motor.kp = 80.0;
  motor.kd = 2.0;
  motor.force_limit = 9.0;
  expect_same_motion(
      robot,
      [](SimulationRun& run) {
        run.from({0.0}, {0.0});
        run.command("motor", {0.0, 1.0}, {0.5, -0.4}, Hold::zero_order);
      },
      kSame, kSamples);
}

TEST_P(LoneJoint, SpinsFast) {
  RobotSpec robot = rich_robot(GetParam());
  robot.joints[0].stiffness = 0.0;
  expect_same_motion(
      robot, [](SimulationRun& run) { run.from({0.0}, {25.0}).command("motor", 0.4); }, kSame, kSamples);
}

TEST(CoordinateLaws, NoneLeaveTheVelocity) { EXPECT_EQ(ode::settled_velocity(0.7, 2.0, {}), 0.7); }

TEST(CoordinateLaws, DryFrictionHoldsUpToItsLimit) {
  constexpr double kLimit = 3.0, kMobility = 0.5;
  const std::array friction = {ode::CoordinateLaw{.compliance = 1e-10, .lower = -kLimit, .upper = kLimit}};
  EXPECT_NEAR(ode::settled_velocity(0.99 * kLimit * kMobility, kMobility, friction), 0.0, 1e-9);
  EXPECT_NEAR(ode::settled_velocity(2.0 * kLimit * kMobility, kMobility, friction), kLimit * kMobility, 1e-9);
  EXPECT_NEAR(ode::settled_velocity(-2.0 * kLimit * kMobility, kMobility, friction), -kLimit * kMobility, 1e-9);
}

TEST(CoordinateLaws, AStopAndAServoShareTheForce) {
  // The servo wants 2 and may push with 1; the stop only pushes up, to a velocity of 0 at least.
  const std::array laws = {ode::CoordinateLaw{.target = 2.0, .compliance = 0.5, .lower = -1.0, .upper = 1.0},
                           ode::CoordinateLaw{.compliance = 1e-10, .lower = 0.0}};
  EXPECT_NEAR(ode::settled_velocity(-5.0, 1.0, laws), 0.0, 1e-9);  // the stop adds 4
  EXPECT_NEAR(ode::settled_velocity(0.5, 1.0, laws), 1.5, 1e-9);   // the servo at its limit
  EXPECT_NEAR(ode::settled_velocity(1.4, 1.0, laws), 1.8, 1e-9);   // the servo at (2 − 1.8)/0.5 = 0.4
}

}  // namespace
}  // namespace lacuna::lone_joint_test

#include "simulation/engine/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::testing {
namespace {

/// Two wheels on hinges of their own, the second geared to the first.
RobotSpec geared_wheels(double ratio) {
  RobotSpec robot = pendulum();
  robot.gravity.setZero();
  robot.bodies.push_back(robot.bodies[0]);
  robot.bodies[1].name = "wheel";
  robot.joints.push_back(robot.joints[0]);
  robot.joints[1].name = "second";
  robot.joints[1].child = "wheel";
  robot.couplings = {{"gear", "second", "hinge", ratio, 0.3}};
  robot.sensors = {sensor("angle", SensorKind::joint_position, "hinge"),
                   sensor("geared", SensorKind::joint_position, "second")};
  return robot;
}

/// The motor turns both inertias: J + ratio²·J.
TEST(Couplings, AGearCarriesItsWheelAlong) {
  constexpr double kRatio = -3.0, kTorque = 0.7, kInertia = 1.0 / 3.0;
  Rig rig(geared_wheels(kRatio), step_of(0.001));
  const std::vector<double> times = grid(0.0, 2.0, 0.1);
  rig.run(constant("motor", kTorque), times);
  ASSERT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  for (Eigen::Index i = 0; i < rig.result.readings.samples.rows(); ++i) {
    const double t = times[static_cast<std::size_t>(i)], q = rig.result.readings.samples(i, 0);
    EXPECT_NEAR(q, 0.5 * kTorque / (kInertia * (1.0 + kRatio * kRatio)) * t * t, 1e-6);
    EXPECT_NEAR(rig.result.readings.samples(i, 1), kRatio * q + 0.3, 1e-6);
  }
}

/// Wherever the follower is said to start, the coupling puts it right.
TEST(Couplings, TheLeaderDecidesTheStart) {
  Rig rig(geared_wheels(2.0), step_of(0.001));
  rig.options.start = {{0.5, 9.0}, {1.0, -4.0}};
  rig.run(constant("motor", 0.0), {0.0, 1.0});
  EXPECT_NEAR(rig.result.readings.samples(0, 1), 1.3, 1e-12);
  EXPECT_NEAR(rig.result.readings.samples(1, 0), 1.5, 1e-6);
  EXPECT_NEAR(rig.result.readings.samples(1, 1), 3.3, 1e-6);
}

/// A gripper whose follower meets its stop: both fingers stop, and stay together.
TEST(Couplings, AStopOfTheFollowerStopsBoth) {
  RobotSpec robot = geared_wheels(1.0);
  robot.joints[1].upper = 0.5;
  Rig rig(robot, step_of(0.001));
  rig.run(constant("motor", 0.5), grid(0.0, 3.0, 0.1));
  ASSERT_EQ(rig.result.ending, Ending::completed) << rig.result.reason;
  const auto& samples = rig.result.readings.samples;
  for (Eigen::Index i = 0; i < samples.rows(); ++i) EXPECT_NEAR(samples(i, 1), samples(i, 0) + 0.3, 1e-5) << i;
  EXPECT_NEAR(samples(samples.rows() - 1, 1), 0.5, 1e-3);
}

TEST(Couplings, ThatCannotBeAreRefused) {
  const auto compiles = [](const RobotSpec& robot, const std::string& engine) {
    EngineSettings settings = step_of(0.001);
    settings.engine = engine;
    compile({.robot = robot, .effects = {}, .parameters = {}}, settings);
  };
  RobotSpec to_itself = geared_wheels(2.0), to_nothing = geared_wheels(2.0);
  to_itself.couplings[0].follows = "second";
  to_nothing.couplings[0].follows = "third";
  EXPECT_THROW(compiles(to_itself, "articulated"), BadInput);
  EXPECT_THROW(compiles(to_nothing, "articulated"), BadInput);
  EXPECT_THROW(compiles(geared_wheels(2.0), "ode"), Error);
}

/// Two links in a row: the angle of the second against the world is the sum of both coordinates.
TEST(LinkAngles, AreSumsOfTheHingesBefore) {
  RobotSpec robot = pendulum();
  robot.bodies.push_back(robot.bodies[0]);
  robot.bodies[1].name = "second";
  robot.joints.push_back(robot.joints[0]);
  robot.joints[1].name = "elbow";
  robot.joints[1].parent = "rod";
  robot.joints[1].child = "second";
  robot.joints[1].axis = -robot.joints[0].axis;
  robot.sensors = {
      sensor("q1", SensorKind::joint_position, "hinge"), sensor("q2", SensorKind::joint_position, "elbow"),
      sensor("v1", SensorKind::joint_velocity, "hinge"), sensor("v2", SensorKind::joint_velocity, "elbow"),
      sensor("angle", SensorKind::link_angle, "elbow"),  sensor("rate", SensorKind::link_velocity, "elbow")};
  Rig rig(robot, step_of(0.001));
  rig.options.start = {{0.4, -0.7}, {1.0, 2.0}};
  rig.run(constant("motor", 0.3), grid(0.0, 1.0, 0.1));
  const auto& s = rig.result.readings.samples;
  ASSERT_EQ(s.rows(), 11);
  EXPECT_LT((s.col(4) - (s.col(1) - s.col(0))).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((s.col(5) - (s.col(3) - s.col(2))).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace lacuna::testing

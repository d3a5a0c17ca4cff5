#include "config/robots/robot_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kTolerance = 1e-12;  // relative to numbers of order one: rounding
constexpr double kOneDegree = std::numbers::pi / 180.0;

RobotSpec from_body(const std::string& body, const std::string& rest = "") {
  return read_robot_text("[robot]\nname = \"r\"\n[body.b]\n" + body + "\n" + rest, "robot.toml");
}

TEST(ReadRobot, ReadsAPendulum) {
  const RobotSpec robot = read_robot(LACUNA_SOURCE_DIRECTORY "/tests/config/good/pendulum.toml");
  EXPECT_EQ(robot.name, "pendulum");
  ASSERT_EQ(robot.joints.size(), 1U);
  EXPECT_EQ(robot.joints[0].parent, kWorld);
  EXPECT_EQ(robot.joints[0].child, "arm");
  EXPECT_NEAR(robot.joints[0].upper, 170.0 * kOneDegree, kTolerance);
  ASSERT_EQ(robot.actuators.size(), 1U);
  EXPECT_EQ(robot.actuators[0].kind, ActuatorKind::position_servo);
  EXPECT_DOUBLE_EQ(robot.actuators[0].kp, 12.0);
  ASSERT_EQ(robot.sensors.size(), 1U);
  EXPECT_EQ(robot.sensors[0].element, "hinge");
  EXPECT_NEAR(robot.sensors[0].noise, 0.05 * kOneDegree, kTolerance);
  EXPECT_TRUE(robot.bodies[0].shapes.empty());
  // Rod and bob: masses add; the moment about the hinge is that of the textbook.
  const BodySpec& arm = robot.bodies[0];
  EXPECT_NEAR(arm.mass, 0.55, kTolerance);
  EXPECT_NEAR(arm.com.z(), -(0.15 * 0.25 + 0.4 * 0.5) / 0.55, kTolerance);
  const double rod = 0.15 * (3 * 0.01 * 0.01 + 0.5 * 0.5) / 12.0 + 0.15 * 0.25 * 0.25;
  const double bob = 0.4 * 0.4 * 0.03 * 0.03 + 0.4 * 0.5 * 0.5;
  EXPECT_NEAR(arm.inertia.yy + arm.mass * arm.com.z() * arm.com.z(), rod + bob, kTolerance);
}

TEST(ReadRobot, AnActuatorMayDriveAUniversalJoint) {
  const RobotSpec robot = from_body("mass = 1\ninertia = [1, 1, 1]",
                                    "[joint.cardan]\nkind = \"universal\"\nchild = \"b\"\naxis = \"x\"\naxis2 = \"y\"\n"
                                    "[actuator.motor]\njoint = \"cardan\"\nkind = \"force\"\n");
  ASSERT_EQ(robot.actuators.size(), 1U);
  EXPECT_EQ(robot.actuators[0].joint, "cardan");
}

TEST(ReadRobot, SpreadsABodysMassOverItsShapes) {
  const RobotSpec robot = from_body(
      "mass = 3\nshapes = [{ kind = \"box\", size = [1, 1, 1], at = [0.5, 0, 0] },"
      "{ kind = \"box\", size = [2, 1, 1], at = [2, 0, 0] }]");
  const BodySpec& body = robot.bodies[0];
  EXPECT_EQ(body.shapes.size(), 2U);
  EXPECT_NEAR(body.com.x(), 1.5, kTolerance);
  EXPECT_NEAR(body.inertia.xx, 3.0 / 12.0 * 2.0, kTolerance);  // together a bar of 3 m × 1 m × 1 m
  EXPECT_NEAR(body.inertia.yy, 3.0 / 12.0 * 10.0, kTolerance);
}

TEST(ReadRobot, DerivesACapsuleLyingAlongX) {
  // Reference: numerical integration of a capsule of radius 0.1 m, length 0.5 m, density 1000 kg/m³.
  const RobotSpec robot =
      from_body("shapes = [{ kind = \"capsule\", radius = 0.1, length = 0.5, along = \"x\", density = 1000 }]");
  constexpr int kSlices = 200000;
  double mass = 0.0, along = 0.0, across = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double x = 0.7 * (i + 0.5) / kSlices - 0.35;
    const double beyond = std::max(std::abs(x) - 0.25, 0.0);
    const double squared = 0.01 - beyond * beyond;
    const double slice = 1000.0 * std::numbers::pi * squared * 0.7 / kSlices;
    mass += slice;
    along += slice * squared / 2.0;
    across += slice * (squared / 4.0 + x * x);
  }
  constexpr double kIntegration = 1e-8;
  EXPECT_NEAR(robot.bodies[0].mass, mass, kIntegration * mass);
  EXPECT_NEAR(robot.bodies[0].inertia.xx, along, kIntegration);
  EXPECT_NEAR(robot.bodies[0].inertia.yy, across, kIntegration);
  EXPECT_NEAR(robot.bodies[0].inertia.zz, across, kIntegration);
}

TEST(ReadRobot, LetsWhatIsGivenPrevail) {
  const RobotSpec robot = from_body("mass = 2\ncom = [0, 0, -1]\ninertia = [1, 2, 2.5]\nat = [1, 2, 3]");
  EXPECT_DOUBLE_EQ(robot.bodies[0].mass, 2.0);
  EXPECT_DOUBLE_EQ(robot.bodies[0].com.z(), -1.0);
  EXPECT_DOUBLE_EQ(robot.bodies[0].inertia.zz, 2.5);
}

TEST(ReadRobot, AnchorsAJointAtItsChildAndNormalisesAxes) {
  const RobotSpec robot =
      from_body("mass = 2\ninertia = [1, 1, 1]\nat = [1, 2, 3]",
                "[joint.s]\nkind = \"slider\"\nchild = \"b\"\naxis = [3, 0, 4]\ndamping = \"2 N*s/m\"");
  EXPECT_EQ(robot.joints[0].anchor, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(robot.joints[0].axis.x(), 0.6, kTolerance);
  EXPECT_DOUBLE_EQ(robot.joints[0].damping, 2.0);
}

TEST(ReadRobot, TurnsByRollPitchYaw) {
  const RobotSpec robot = from_body("mass = 1\ninertia = [1, 1, 1]\nrpy = [\"90 deg\", 0, \"90 deg\"]");
  // z goes to −y by the roll, then −y goes to x by the yaw.
  const Eigen::Vector3d z = robot.bodies[0].orientation * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR((z - Eigen::Vector3d::UnitX()).norm(), 0.0, kTolerance);
}

}  // namespace
}  // namespace lacuna

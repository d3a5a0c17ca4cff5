#include "plugins/built_catalog.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kGeometryTolerance = 1e-12;  // of lengths, angles and moments of order one
constexpr double kThirtyDegrees = std::numbers::pi / 6.0;

class QuadrupedTest : public testing::Test {
 protected:
  QuadrupedTest() {
    for (const ParameterDeclaration& declaration : plugin_.parameters()) values_.push_back(declaration.default_value);
    robot_ = plugin_.build({values_, nullptr});
  }
  template <class Spec>
  static const Spec& named(const std::vector<Spec>& specs, const std::string& name) {
    const auto found = std::find_if(specs.begin(), specs.end(), [&](const Spec& spec) { return spec.name == name; });
    if (found == specs.end()) throw Error("no element " + name);
    return *found;
  }
  const BodySpec& body(const std::string& name) const { return named(robot_.bodies, name); }
  const JointSpec& joint(const std::string& name) const { return named(robot_.joints, name); }

  const RobotDefinition& plugin_ = built_catalog().get<RobotDefinition>("quadruped");
  std::vector<double> values_;
  RobotSpec robot_;
};

TEST_F(QuadrupedTest, HasThePartsOfTheSource) {
  EXPECT_EQ(robot_.bodies.size(), 9U);
  EXPECT_EQ(robot_.joints.size(), 8U);
  EXPECT_EQ(robot_.actuators.size(), 8U);
  EXPECT_EQ(std::count_if(robot_.sensors.begin(), robot_.sensors.end(),
                          [](const SensorSpec& sensor) { return sensor.kind == SensorKind::touch; }),
            4);
  EXPECT_EQ(robot_.sensors.size(), 8U);
}

TEST_F(QuadrupedTest, StandsWithFourFeetOnTheGround) {
  for (const char* leg : {"front_left", "front_right", "rear_left", "rear_right"}) {
    const BodySpec& lower = body(std::string(leg) + "_lower");
    const ShapeSpec& shape = lower.shapes.at(0);
    const Eigen::Vector3d along = lower.orientation * Eigen::Vector3d::UnitZ();
    const double lowest = lower.position.z() - std::abs(along.z()) * 0.5 * shape.size[1] - shape.size[0];
    EXPECT_NEAR(lowest, 0.0, kGeometryTolerance) << leg;
  }
}

TEST_F(QuadrupedTest, FrontIsForwardAndLeftIsLeft) {
  EXPECT_TRUE(body("front_left_lower").position.isApprox(Eigen::Vector3d(1.0, 1.0, 0.85), kGeometryTolerance));
  EXPECT_TRUE(body("rear_right_upper").position.isApprox(Eigen::Vector3d(-0.5, -0.5, 1.225), kGeometryTolerance));
  EXPECT_TRUE(joint("front_right_knee").anchor.isApprox(Eigen::Vector3d(1.0, -1.0, 1.6), kGeometryTolerance));
  EXPECT_TRUE(joint("front_right_hip").anchor.isApprox(Eigen::Vector3d(0.0, 0.0, 0.85), kGeometryTolerance));
}

TEST_F(QuadrupedTest, UpperLegsPointFromHipToKnee) {
  for (const char* leg : {"front_left", "rear_right"}) {
    const std::string name = leg;
    const Eigen::Vector3d along = body(name + "_upper").orientation * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d leg_line = joint(name + "_knee").anchor - joint(name + "_hip").anchor;
    EXPECT_NEAR(along.dot(leg_line.normalized()), 1.0, kGeometryTolerance);
  }
}

TEST_F(QuadrupedTest, PositiveAnglesLiftTheKneeAndSwingTheFootOutward) {
  for (const char* leg : {"front_left", "front_right", "rear_left", "rear_right"}) {
    const std::string name = leg;
    const Eigen::Vector3d hip = joint(name + "_hip").anchor, knee = joint(name + "_knee").anchor;
    EXPECT_GT(joint(name + "_hip").axis.cross(knee - hip).z(), 0.0);
    const Eigen::Vector3d foot_motion = joint(name + "_knee").axis.cross(Eigen::Vector3d(0.0, 0.0, -1.0));
    EXPECT_GT(foot_motion.dot(knee - hip), 0.0);
    EXPECT_NEAR(joint(name + "_hip").axis.z(), 0.0, kGeometryTolerance);
  }
}

TEST_F(QuadrupedTest, OnlyTorsoAndLowerLegsTouchTheGround) {
  for (const BodySpec& part : robot_.bodies) EXPECT_EQ(part.shapes.empty(), part.name.ends_with("_upper")) << part.name;
  EXPECT_TRUE(robot_.contact.ground);
  EXPECT_EQ(robot_.gravity.z(), -9.8);
}

TEST_F(QuadrupedTest, ServosWantEightTimesTheErrorAsSpeedAndCommandsSpanTheRange) {
  for (const ActuatorSpec& servo : robot_.actuators) {
    EXPECT_NEAR(servo.kp / servo.kd, 8.0, kGeometryTolerance);
    EXPECT_EQ(servo.force_limit, 40.0);
    EXPECT_NEAR(servo.gain * 1.0, kThirtyDegrees, kGeometryTolerance);
    EXPECT_NEAR(joint(servo.joint).upper, kThirtyDegrees, kGeometryTolerance);
    EXPECT_NEAR(joint(servo.joint).lower, -kThirtyDegrees, kGeometryTolerance);
  }
}

TEST_F(QuadrupedTest, KneeSensorsReadOneAtTheStop) {
  const SensorSpec& sensor = named(robot_.sensors, "angle_front_left");
  EXPECT_EQ(sensor.element, "front_left_knee");
  EXPECT_NEAR(sensor.scale * kThirtyDegrees, 1.0, kGeometryTolerance);
}

TEST_F(QuadrupedTest, MassesAreParametersAndScaleTheInertia) {
  const ParameterDeclarations declarations = plugin_.parameters();
  const auto mass = std::find_if(declarations.begin(), declarations.end(), [](const ParameterDeclaration& declaration) {
    return declaration.name == "rear_left_upper_mass";
  });
  ASSERT_NE(mass, declarations.end());
  const InertiaSpec light = body("rear_left_upper").inertia;
  values_[static_cast<std::size_t>(mass - declarations.begin())] = 3.0;
  robot_ = plugin_.build({values_, nullptr});
  EXPECT_EQ(body("rear_left_upper").mass, 3.0);
  EXPECT_NEAR(body("rear_left_upper").inertia.xx, 3.0 * light.xx, kGeometryTolerance);
  EXPECT_EQ(body("torso").mass, 1.0);
}

/// Moments of a solid capsule by summing thin discs along its axis.
TEST_F(QuadrupedTest, LegInertiaIsThatOfASolidCapsule) {
  constexpr double kRadius = 0.1, kLength = 1.5;
  constexpr int kDiscs = 200000;
  const double half = 0.5 * kLength + kRadius, thickness = 2.0 * half / kDiscs;
  double volume = 0.0, along = 0.0, across = 0.0;
  for (int i = 0; i < kDiscs; ++i) {
    const double z = -half + (i + 0.5) * thickness;
    const double beyond = std::max(std::abs(z) - 0.5 * kLength, 0.0);
    const double r2 = kRadius * kRadius - beyond * beyond;
    const double disc = r2 * thickness;
    volume += disc;
    along += disc * r2 / 2.0;
    across += disc * (r2 / 4.0 + z * z);
  }
  constexpr double kQuadrature = 1e-8;
  const InertiaSpec& inertia = body("front_left_lower").inertia;
  EXPECT_NEAR(inertia.zz, along / volume, kQuadrature);
  EXPECT_NEAR(inertia.xx, across / volume, kQuadrature);
  EXPECT_NEAR(inertia.yy, across / volume, kQuadrature);
}

/// With all servos at their middle the robot stays as it stands, all four feet on the ground.
TEST_F(QuadrupedTest, StandsStillWhereNothingIsCommanded) {
  constexpr double kEnd = 2.0, kSourceStep = 0.01;  // s; the source's step
  constexpr double kSag = 0.05;                     // m, of servos that give way under the weight
  SensorSpec height;
  height.name = "height";
  height.kind = SensorKind::body_position;
  height.element = "torso";
  robot_.sensors.push_back(height);
  SimulationRun run(robot_, kSourceStep);
  for (const ActuatorSpec& actuator : robot_.actuators) run.command(actuator.name, 0.0);
  const TimeSeries readings = run.run({0.0, kEnd}).readings;
  EXPECT_NEAR(last_vector(readings, "height").z(), 0.85, kSag);
  EXPECT_NEAR(last_vector(readings, "height").x(), 0.0, kSag);
  for (const char* leg : {"front_left", "front_right", "rear_left", "rear_right"}) {
    EXPECT_EQ(column(readings, std::string("touch_") + leg)(1), 1.0);
    EXPECT_NEAR(column(readings, std::string("angle_") + leg)(1), 0.0, 0.1);
  }
}

}  // namespace
}  // namespace lacuna

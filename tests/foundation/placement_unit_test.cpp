#include "foundation/placement_unit.h"

#include "foundation/address.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// A hinge and a slider, each with a motor and a sensor.
RobotSpec rig() {
  RobotSpec robot;
  robot.joints.resize(2);
  robot.joints[0].name = "hinge";
  robot.joints[1].name = "rail";
  robot.joints[1].kind = JointKind::slider;
  robot.actuators.resize(2);
  robot.actuators[0].joint = "hinge";
  robot.actuators[1].joint = "rail";
  robot.actuators[1].kind = ActuatorKind::velocity_servo;
  robot.sensors.resize(2);
  robot.sensors[0].element = "hinge";
  robot.sensors[1].element = "rail";
  robot.sensors[1].kind = SensorKind::joint_velocity;
  return robot;
}

TEST(UnitAt, JointsOfBothKinds) {
  const RobotSpec robot = rig();
  EXPECT_EQ(unit_at("{force}", robot, ElementKind::joint, 0), "N*m");
  EXPECT_EQ(unit_at("{force}", robot, ElementKind::joint, 1), "N");
  EXPECT_EQ(unit_at("{force}*s/{position}", robot, ElementKind::joint, 0), "N*m*s/rad");
  EXPECT_EQ(unit_at("{force}*s/{position}", robot, ElementKind::joint, 1), "N*s/m");
  EXPECT_EQ(unit_at("{inertia}", robot, ElementKind::joint, 0), "kg*m^2");
  EXPECT_EQ(unit_at("{inertia}", robot, ElementKind::joint, 1), "kg");
}

TEST(UnitAt, AProductBehindADivisionStaysTogether) {
  EXPECT_EQ(unit_at("1/{force}", rig(), ElementKind::joint, 0), "1/(N*m)");
}

TEST(UnitAt, CommandsAndChannels) {
  const RobotSpec robot = rig();
  EXPECT_EQ(unit_at("{command}", robot, ElementKind::actuator, 0), "N*m");
  EXPECT_EQ(unit_at("{command}", robot, ElementKind::actuator, 1), "m/s");
  EXPECT_EQ(unit_at("{force}", robot, ElementKind::actuator, 1), "N");
  EXPECT_EQ(unit_at("{channel}", robot, ElementKind::sensor, 0), "rad");
  EXPECT_EQ(unit_at("{channel}/s", robot, ElementKind::sensor, 1), "m/s/s");
}

/// Effects act on what is commanded and read, between gain and scale.
TEST(UnitAt, OfWhatIsRelativeIsThatOfTheJoint) {
  RobotSpec robot = rig();
  robot.actuators[0].relative = robot.sensors[0].relative = true;
  EXPECT_EQ(command_channels(robot)[0].unit, "1");
  EXPECT_EQ(command_channels(robot)[1].unit, "m/s");
  EXPECT_EQ(sensor_channels(robot)[0].unit, "1");
  EXPECT_EQ(unit_at("{command}", robot, ElementKind::actuator, 0), "N*m");
  EXPECT_EQ(unit_at("{channel}", robot, ElementKind::sensor, 0), "rad");
}

TEST(UnitAt, PlainUnitsStay) { EXPECT_EQ(unit_at("kg", rig(), ElementKind::body, 0), "kg"); }

TEST(UnitInWords, NamesBothKindsOfJoint) {
  EXPECT_EQ(unit_in_words("{force}"), "N*m (N on a slider)");
  EXPECT_EQ(unit_in_words("{force}*s/{position}"), "N*m*s/rad (N*s/m on a slider)");
  EXPECT_EQ(unit_in_words("{channel}"), "the channel's unit");
  EXPECT_EQ(unit_in_words("s"), "s");
}

}  // namespace
}  // namespace lacuna

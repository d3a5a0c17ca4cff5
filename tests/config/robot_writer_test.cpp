#include "config/robots/robot_reader.h"
#include "config/robots/robot_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <lacuna/error.h>

namespace lacuna {
namespace {

using testing::HasSubstr;

RobotSpec with_all() {
  return read_robot_text(R"([robot]
name = "all"
[world]
gravity = [0.0, 0.1, -9.8]
[body.a]
mass = 2.0
com = [0.1, 0.2, 0.3]
inertia = { xx = 0.1, yy = 0.2, zz = 0.25, xy = 0.01, xz = -0.02, yz = 0.03 }
at = [1.0, 2.0, 3.0]
rpy = [0.1, -0.2, 0.3]
shapes = [{ kind = "capsule", radius = 0.1, length = 0.4, at = [0.0, 0.0, 0.1], along = "x" }, { kind = "box", size = [0.1, 0.2, 0.3] }]
[body.b]
mass = 1.0
com = [0.0, 0.0, 0.0]
inertia = [0.1, 0.1, 0.1]
inertia_scales_with_mass = false
[joint.j]
kind = "slider"
parent = "a"
child = "b"
axis = [1.0, 1.0, 0.0]
anchor = [0.0, 0.0, 1.0]
lower = -1.0
damping = 0.1
dry_friction = 0.2
stiffness = 3.0
rest = 0.01
armature = 0.02
force = 0.3
[actuator.m]
joint = "j"
kind = "position_servo"
kp = 10.0
kd = 0.5
gain = 1.1
offset = 0.05
delay = 0.01
force_limit = 9.0
command_lower = -2.0
transmission = { ratio = 50.0, rotor_inertia = 1e-5 }
[sensor.s]
kind = "joint_position"
joint = "j"
noise = 1e-3
quantum = 1e-4
[sensor.imu]
kind = "accelerometer"
body = "b"
at = [0.0, 0.0, 0.2]
[contact]
ground = true
friction = 0.7
)",
                         "robot.toml");
}

void expect_same_bodies(const RobotSpec& a, const RobotSpec& b) {
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].mass, b.bodies[i].mass);
    EXPECT_EQ(a.bodies[i].com, b.bodies[i].com);
    EXPECT_EQ(a.bodies[i].inertia.yz, b.bodies[i].inertia.yz);
    EXPECT_EQ(a.bodies[i].position, b.bodies[i].position);
    EXPECT_TRUE(a.bodies[i].orientation.isApprox(b.bodies[i].orientation, 1e-14));
    EXPECT_EQ(a.bodies[i].inertia_scales_with_mass, b.bodies[i].inertia_scales_with_mass);
    ASSERT_EQ(a.bodies[i].shapes.size(), b.bodies[i].shapes.size());
    for (std::size_t s = 0; s < a.bodies[i].shapes.size(); ++s) {
      EXPECT_EQ(a.bodies[i].shapes[s].size, b.bodies[i].shapes[s].size);
      EXPECT_TRUE(a.bodies[i].shapes[s].orientation.toRotationMatrix().isApprox(
          b.bodies[i].shapes[s].orientation.toRotationMatrix(), 1e-12));
    }
  }
}

TEST(RobotToml, IsReadBackAsTheSameRobot) {
  const RobotSpec robot = with_all();
  const std::string text = robot_toml(robot, "of a test\nin two lines");
  EXPECT_THAT(text, HasSubstr("# of a test\n# in two lines\n"));
  const RobotSpec back = read_robot_text(text, "back.toml");
  expect_same_bodies(robot, back);
  const JointSpec &joint = robot.joints.at(0), &joint_back = back.joints.at(0);
  EXPECT_EQ(joint.kind, joint_back.kind);
  EXPECT_TRUE(joint.axis.isApprox(joint_back.axis, 1e-15));
  EXPECT_EQ(joint.lower, joint_back.lower);
  EXPECT_EQ(joint.upper, joint_back.upper);
  EXPECT_EQ(joint.force, joint_back.force);
  const ActuatorSpec &motor = robot.actuators.at(0), &motor_back = back.actuators.at(0);
  EXPECT_EQ(motor.kind, motor_back.kind);
  EXPECT_EQ(motor.transmission.rotor_inertia, motor_back.transmission.rotor_inertia);
  EXPECT_EQ(motor.command_lower, motor_back.command_lower);
  EXPECT_EQ(back.sensors.at(1).at, robot.sensors.at(1).at);
  EXPECT_EQ(back.gravity, robot.gravity);
  EXPECT_EQ(back.contact.friction, 0.7);
  EXPECT_EQ(robot_toml(back, ""), robot_toml(read_robot_text(robot_toml(back, ""), "again.toml"), ""));
}

constexpr const char* kWritten =
    "[robot]\nname = \"r\"  # mine\n[body.b]\nmass = \"500 g\" # scale\ncom = [0.0, 0.0, 0.1]\n"
    "inertia = [0.1, 0.1, 0.1]\n\n[joint.j]\nchild = \"b\"\n# the end\n";

TEST(RobotValues, ReplaceWhatIsWrittenAndAddWhatIsNot) {
  RobotSpec robot = read_robot_text(kWritten, "r.toml");
  robot.bodies[0].inertia = {0.2, 0.2, 0.2, 0.0, 0.0, 0.0};
  const std::string text = with_robot_values(kWritten, robot,
                                             {{"body.b.mass", 0.75},
                                              {"body.b.com.z", 0.2},
                                              {"body.b.inertia.xx", 0.2},
                                              {"body.b.inertia.yy", 0.2},
                                              {"body.b.inertia.zz", 0.2},
                                              {"joint.j.damping", 0.3},
                                              {"joint.j.armature", 0.01}});
  EXPECT_EQ(text,
            "[robot]\nname = \"r\"  # mine\n[body.b]\nmass = 0.75 # scale\ncom = [0.0, 0.0, 0.2]\n"
            "inertia = [0.2, 0.2, 0.2]\n\n[joint.j]\nchild = \"b\"\narmature = 0.01\ndamping = 0.3\n# the end\n");
}

TEST(RobotValues, AreRefusedWhereTheyHaveNoPlace) {
  const RobotSpec robot = read_robot_text(kWritten, "r.toml");
  EXPECT_THROW(with_robot_values(kWritten, robot, {{"contact.friction", 0.5}}), Error);
}

}  // namespace
}  // namespace lacuna

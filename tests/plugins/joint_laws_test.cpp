#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <array>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Three joints in a row: hinge, slider, ball.
RobotSpec row_of_joints() {
  RobotSpec robot;
  robot.joints.resize(3);
  robot.joints[0].name = "hinge";
  robot.joints[1].name = "rail";
  robot.joints[1].kind = JointKind::slider;
  robot.joints[2].name = "socket";
  robot.joints[2].kind = JointKind::ball;
  return robot;
}

RobotSpec amended(const std::string& effect, double value, std::vector<int> joints) {
  RobotSpec robot = row_of_joints();
  const std::array<double, 1> parameters = {value};
  built_catalog().get<PhysicalEffect>(effect).amend(robot, {parameters, joints, ElementKind::joint, 0.001});
  return robot;
}

TEST(CoulombFriction, AddsItsTorqueToTheJointsDryFriction) {
  const RobotSpec robot = amended("coulomb_friction", 0.25, {0, 1});
  EXPECT_EQ(robot.joints[0].dry_friction, 0.25);
  EXPECT_EQ(robot.joints[1].dry_friction, 0.25);
  EXPECT_EQ(robot.joints[0].damping, 0.0);
}

TEST(ViscousFriction, AddsItsDampingToTheJoints) {
  const RobotSpec robot = amended("viscous_friction", 3.5, {1});
  EXPECT_EQ(robot.joints[1].damping, 3.5);
  EXPECT_EQ(robot.joints[0].damping, 0.0);
}

TEST(JointOffsetTorque, AddsItsTorqueWithItsSign) {
  EXPECT_EQ(amended("joint_offset_torque", -3.2, {0}).joints[0].force, -3.2);
}

TEST(JointLaws, EffectsRefuseJointsWithoutThem) {
  for (const char* effect : {"coulomb_friction", "viscous_friction", "joint_offset_torque"})
    EXPECT_THAT([&] { amended(effect, 1.0, {2}); }, ThrowsMessage<Error>(HasSubstr("joint.socket is a ball joint")));
}

TEST(JointLaws, AtTheirNeutralValueEffectsChangeNothing) {
  for (const char* effect : {"coulomb_friction", "viscous_friction", "joint_offset_torque"}) {
    const double neutral = built_catalog().get<PhysicalEffect>(effect).describe().parameters[0].default_value;
    const JointSpec joint = amended(effect, neutral, {0}).joints[0];
    EXPECT_EQ(joint.dry_friction, 0.0);
    EXPECT_EQ(joint.damping, 0.0);
    EXPECT_EQ(joint.force, 0.0);
  }
}

}  // namespace
}  // namespace lacuna

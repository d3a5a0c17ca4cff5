#include "evaluation/robots/robot_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

RobotSpec compared_arm() {
  RobotSpec robot;
  BodySpec body;
  body.name = "arm";
  body.com = {0.1, 0.0, -0.2};
  body.inertia = {0.02, 0.03, 0.04, 0.001, 0.002, 0.003};
  robot.bodies.push_back(body);
  JointSpec joint;
  joint.name = "hinge";
  joint.child = "arm";
  robot.joints.push_back(joint);
  return robot;
}

TEST(CompareRobots, FindsValuesThatDiffer) {
  const RobotSpec other = compared_arm();
  RobotSpec wanted = other;
  wanted.joints[0].armature = 0.01;
  const RobotComparison comparison = compare_robots(wanted, other);
  EXPECT_THAT(comparison.set, ElementsAre(Pair("joint.hinge.armature", 0.01)));
  EXPECT_THAT(comparison.other, IsEmpty());
}

/// A mass that is set takes the inertia along, so all of it is set with it.
TEST(CompareRobots, SetsTheInertiaWithAMass) {
  const RobotSpec other = compared_arm();
  RobotSpec wanted = other;
  wanted.bodies[0].mass = 2.0;
  EXPECT_EQ(compare_robots(wanted, other).set.size(), 7U);
}

TEST(CompareRobots, DoesNotMindAFrameThatStandsElsewhere) {
  const RobotSpec wanted = compared_arm();
  RobotSpec other = wanted;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()));
  BodySpec& body = other.bodies[0];
  body.position = {1.0, 0.0, 0.0};
  body.orientation = turn;
  body.com = turn.conjugate() * (wanted.bodies[0].com - body.position);
  Eigen::Matrix3d inertia;
  const InertiaSpec& i = wanted.bodies[0].inertia;
  inertia << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
  inertia = turn.conjugate().toRotationMatrix() * inertia * turn.toRotationMatrix();
  body.inertia = {inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2)};
  const RobotComparison comparison = compare_robots(wanted, other);
  EXPECT_THAT(comparison.set, IsEmpty());
  EXPECT_THAT(comparison.other, IsEmpty());
}

TEST(CompareRobots, NamesWhatOnlyOneHas) {
  RobotSpec wanted = compared_arm(), other = compared_arm();
  ActuatorSpec motor;
  motor.name = "motor";
  motor.joint = "hinge";
  wanted.actuators.push_back(motor);
  other.joints[0].axis = {1.0, 0.0, 0.0};
  EXPECT_THAT(compare_robots(wanted, other).other,
              ElementsAre(HasSubstr("has no actuator motor"), HasSubstr("joint hinge has another place in the file")));
}

}  // namespace
}  // namespace lacuna

#include "fitting/starts/restarts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace lacuna {
namespace {

RobotSpec driven_arm(int joints, ActuatorKind kind) {
  RobotSpec robot;
  for (int i = 0; i < joints; ++i) {
    ActuatorSpec motor;
    motor.name = "m" + std::to_string(i);
    motor.joint = "j" + std::to_string(i);
    motor.kind = kind;
    robot.actuators.push_back(motor);
    JointSpec joint;
    joint.name = motor.joint;
    joint.parent = i == 0 ? "world" : "link" + std::to_string(i - 1);
    joint.child = "link" + std::to_string(i);
    robot.joints.push_back(joint);
  }
  return robot;
}

Trial commanded(const RobotSpec& robot) {
  Trial trial;
  for (const ActuatorSpec& motor : robot.actuators) trial.commands.series.channels.push_back({motor.name, "N*m"});
  return trial;
}

TEST(Restarts, AreOfArmsThatRecordedTorquesDriveInOpenLoop) {
  const RobotSpec arm = driven_arm(3, ActuatorKind::force);
  Trial trial = commanded(arm);
  EXPECT_EQ(restart_interval(arm, trial), kRestart);
  trial.closed_loop = true;
  EXPECT_TRUE(std::isinf(restart_interval(arm, trial))) << "a controller corrects the model";
}

TEST(Restarts, AreNotOfServosFewJointsOrJointsThatNothingCommands) {
  const RobotSpec servos = driven_arm(6, ActuatorKind::position_servo), two = driven_arm(2, ActuatorKind::force);
  EXPECT_TRUE(std::isinf(restart_interval(servos, commanded(servos))));
  EXPECT_TRUE(std::isinf(restart_interval(two, commanded(two))));
  EXPECT_TRUE(std::isinf(restart_interval(driven_arm(3, ActuatorKind::force), commanded(two))));
}

TEST(Restarts, AreNotOfJointsSideBySide) {
  RobotSpec robot = driven_arm(4, ActuatorKind::force);
  for (JointSpec& joint : robot.joints) joint.parent = "world";
  EXPECT_TRUE(std::isinf(restart_interval(robot, commanded(robot))));
}

}  // namespace
}  // namespace lacuna

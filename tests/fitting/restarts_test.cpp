#include "fitting/restarts.h"

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

}  // namespace
}  // namespace lacuna

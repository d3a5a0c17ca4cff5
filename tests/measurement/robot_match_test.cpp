#include "measurement/guesses/logged_drives.h"
#include "measurement/rig_guess.h"
#include "measurement_fixture.h"

#include <fmt/format.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

RobotSpec bare_arm(const std::vector<std::string>& joints) {
  RobotSpec robot;
  for (const std::string& name : joints) {
    BodySpec body;
    body.name = name + "_link";
    robot.bodies.push_back(body);
    JointSpec joint;
    joint.name = name;
    joint.child = body.name;
    robot.joints.push_back(joint);
  }
  return robot;
}

void add_sensor(RobotSpec& robot, const std::string& name, SensorKind kind, const std::string& joint) {
  SensorSpec sensor;
  sensor.name = name;
  sensor.kind = kind;
  sensor.element = joint;
  robot.sensors.push_back(sensor);
}

void add_motor(RobotSpec& robot, const std::string& name, const std::string& joint,
               ActuatorKind kind = ActuatorKind::force) {
  ActuatorSpec motor;
  motor.name = name;
  motor.joint = joint;
  motor.kind = kind;
  robot.actuators.push_back(motor);
}

/// An encoder on one joint and a motor, which no draft would call by these names.
RobotSpec one_joint() {
  RobotSpec robot = bare_arm({"pivot"});
  add_sensor(robot, "encoder", SensorKind::joint_position, "pivot");
  add_motor(robot, "drive", "pivot");
  return robot;
}

RobotSpec two_joints() {
  RobotSpec robot = bare_arm({"hip", "knee"});
  add_sensor(robot, "hip_encoder", SensorKind::joint_position, "hip");
  add_sensor(robot, "knee_encoder", SensorKind::joint_position, "knee");
  add_sensor(robot, "knee_tacho", SensorKind::joint_velocity, "knee");
  add_motor(robot, "m1", "hip");
  add_motor(robot, "m2", "knee");
  return robot;
}

/// The position of each joint, under names that say so.
RobotSpec shoulder_and_elbow() {
  RobotSpec robot = bare_arm({"shoulder", "elbow"});
  add_sensor(robot, "shoulder_position", SensorKind::joint_position, "shoulder");
  add_sensor(robot, "elbow_position", SensorKind::joint_position, "elbow");
  return robot;
}

class MatchRobot : public testing::Test {
 protected:
  /// Guesses for a recording with these columns behind the time.
  RigGuess guess(const std::string& columns, const RobotSpec& robot, const ColumnHints& hints = {}) const {
    std::string text = "t_s," + columns + "\n";
    for (int row = 0; row < 5; ++row) {
      text += fmt::format("{}", 0.01 * row);
      for (int c = 0; c <= std::count(columns.begin(), columns.end(), ','); ++c)
        text += fmt::format(",{}", (c + row * row) % 3);
      text += "\n";
    }
    return guess_rig({sample_file(folder_.write("run.csv", text))}, hints, robot);
  }

  /// "hip_encoder=q1", sensors before actuators.
  static std::vector<std::string> pairs(const RigGuess& guess) {
    std::vector<std::string> all;
    for (const auto* matches : {&guess.sensors, &guess.commands})
      for (const MatchedColumn& match : *matches) all.push_back(match.channel.name + "=" + match.column.name);
    return all;
  }

  static std::vector<std::string> unmatched(const RigGuess& guess) {
    std::vector<std::string> all;
    for (const UnmatchedChannel& left : guess.unmatched) all.push_back(left.channel.name);
    return all;
  }

  TestFolder folder_;
};

TEST_F(MatchRobot, TakesTheOnlyColumnOfAUnit) {
  const RigGuess rig = guess("theta_deg,tau_Nm", one_joint());
  EXPECT_THAT(pairs(rig), ElementsAre("encoder=theta_deg", "drive=tau_Nm"));
  EXPECT_EQ(rig.sensors[0].channel.unit, "rad");
  EXPECT_THAT(rig.unmatched, IsEmpty());
  const RecordingSource source = source_of(rig, {{"run.csv"}});
  EXPECT_EQ(source.sensors[0].channel, "encoder");
  EXPECT_EQ(source.commands[0].channel, "drive");
}

TEST_F(MatchRobot, GivesNoJointAColumnThatFitsAnother) {
  const RigGuess rig = guess("theta_deg,knee_vel", two_joints());
  EXPECT_THAT(pairs(rig), ElementsAre("knee_tacho=knee_vel"));
  EXPECT_THAT(unmatched(rig), testing::IsSupersetOf({"hip_encoder", "knee_encoder"}));
}

TEST_F(MatchRobot, GoesByNamesBeforeUnits) {
  const RigGuess rig = guess("knee_pos_deg,hip_pos_deg,knee_vel,m2_A,m1_A", two_joints());
  EXPECT_THAT(pairs(rig), ElementsAre("hip_encoder=hip_pos_deg", "knee_encoder=knee_pos_deg", "knee_tacho=knee_vel",
                                      "m1=m1_A", "m2=m2_A"));
}

TEST_F(MatchRobot, TakesAsManyColumnsAsChannelsInTheirOrder) {
  const RigGuess rig = guess("qa_rad,qb_rad,ua_Nm,ub_Nm", two_joints());
  EXPECT_THAT(pairs(rig), ElementsAre("hip_encoder=qa_rad", "knee_encoder=qb_rad", "m1=ua_Nm", "m2=ub_Nm"));
  EXPECT_THAT(unmatched(rig), ElementsAre("knee_tacho"));
}

RobotSpec wrist() {
  RobotSpec robot = bare_arm({"elbow", "wrist_1", "wrist_2"});
  for (const char* joint : {"elbow", "wrist_1", "wrist_2"}) {
    add_sensor(robot, std::string(joint) + "_position", SensorKind::joint_position, joint);
    add_motor(robot, std::string(joint) + "_motor", joint);
  }
  return robot;
}

/// The index of a list is no unit, and no joint's number.
TEST_F(MatchRobot, TakesListsInTheirOrder) {
  EXPECT_THAT(pairs(guess("q[0],q[1],q[2],tau[0],tau[1],tau[2]", wrist())),
              ElementsAre("elbow_position=q[0]", "wrist_1_position=q[1]", "wrist_2_position=q[2]", "elbow_motor=tau[0]",
                          "wrist_1_motor=tau[1]", "wrist_2_motor=tau[2]"));
  EXPECT_THAT(pairs(guess("q_2,q_0,q_1", wrist())),
              ElementsAre("elbow_position=q_0", "wrist_1_position=q_1", "wrist_2_position=q_2"));
}

TEST_F(MatchRobot, TakesNumbersThatAllBelongToJoints) {
  EXPECT_THAT(pairs(guess("q2_rad,tau2_Nm", wrist())), ElementsAre("wrist_2_position=q2_rad", "wrist_2_motor=tau2_Nm"));
  EXPECT_THAT(pairs(guess("q_0,q_1,tau_0,tau_1", two_joints())),
              ElementsAre("hip_encoder=q_0", "knee_encoder=q_1", "m1=tau_0", "m2=tau_1"));
}

/// q1 has the name of joint q1, and is the second all the same.
TEST_F(MatchRobot, DoesNotCrossListsThatCountFromZero) {
  RobotSpec robot = bare_arm({"q1", "q2", "q3"});
  for (const char* joint : {"q1", "q2", "q3"}) {
    add_sensor(robot, joint, SensorKind::joint_position, joint);
    add_motor(robot, joint, joint);
  }
  const RigGuess rig = guess("q0,q1,q2,tau_0,tau_1,tau_2", robot);
  EXPECT_THAT(pairs(rig), ElementsAre("q1=q0", "q2=q1", "q3=q2", "q1=tau_0", "q2=tau_1", "q3=tau_2"));
  EXPECT_EQ(rig.sensors[0].column.reason, "its number, counted from 0; joints are counted from 1");
  EXPECT_THAT(pairs(guess("q1,q2,q3", robot)), ElementsAre("q1=q1", "q2=q2", "q3=q3"));
  EXPECT_THAT(pairs(guess("q2,q3", robot)), ElementsAre("q2=q2", "q3=q3")) << "not all joints";
}

/// As drivers of industrial arms log them.
TEST_F(MatchRobot, TellsTorquesFromCurrentsGoalsTemperaturesAndSupplies) {
  const RigGuess rig = guess(
      "target_q_0,target_q_1,actual_q_0,actual_q_1,actual_current_0,actual_current_1,effort_0,effort_1,"
      "joint_temperatures_0,joint_temperatures_1,main_voltage",
      two_joints());
  EXPECT_THAT(pairs(rig),
              ElementsAre("hip_encoder=actual_q_0", "knee_encoder=actual_q_1", "m1=effort_0", "m2=effort_1"));
}

TEST_F(MatchRobot, LeavesOpenWhatIsAmbiguous) {
  RobotSpec robot = one_joint();
  add_sensor(robot, "tacho", SensorKind::joint_velocity, "pivot");
  const RigGuess rig = guess("a_deg,b_deg,speed_rpm,tau_Nm", robot);
  EXPECT_THAT(pairs(rig), ElementsAre("tacho=speed_rpm", "drive=tau_Nm"));
  ASSERT_EQ(rig.unmatched.size(), 1u);
  EXPECT_THAT(rig.unmatched[0].candidates, ElementsAre("a_deg", "b_deg"));
  EXPECT_THAT(pairs(guess("encoder_deg,b_deg,tau_Nm", one_joint())),
              ElementsAre("encoder=encoder_deg", "drive=tau_Nm"));
}

TEST_F(MatchRobot, SaysWhatHasNoColumn) {
  EXPECT_THAT([&] { guess("speed_rpm,tau_Nm", one_joint()); },
              ThrowsMessage<Error>(HasSubstr("no column fits a sensor of the robot (encoder in rad); name one with "
                                             "--position or --velocity")));
  const RigGuess rig = guess("q_rad,blue", one_joint());
  EXPECT_THAT(unmatched(rig), ElementsAre("drive"));
  EXPECT_TRUE(rig.unmatched[0].is_actuator);
  EXPECT_THAT(rig.unused.at(0).name, "blue");
}

TEST_F(MatchRobot, BelievesTheUser) {
  ColumnHints hints;
  hints.positions = {"b_V"};
  const RigGuess rig = guess("a_rad,b_V,tau_Nm", one_joint(), hints);
  EXPECT_THAT(pairs(rig), ElementsAre("encoder=b_V", "drive=tau_Nm"));
}

TEST_F(MatchRobot, GivesAServoTheReference) {
  RobotSpec robot = one_joint();
  robot.actuators[0].kind = ActuatorKind::position_servo;
  EXPECT_THAT(pairs(guess("angle_deg,angle_ref_deg", robot)), ElementsAre("encoder=angle_deg", "drive=angle_ref_deg"));
  EXPECT_THAT(pairs(guess("angle_deg,angle_ref_deg", one_joint())), ElementsAre("encoder=angle_deg"));
}

class LoggedDrives : public testing::Test {
 protected:
  std::optional<ActuatorKind> drive(const std::string& columns, const RobotSpec& robot) const {
    std::string text = "t_s," + columns + "\n";
    for (int row = 0; row < 5; ++row) {
      text += fmt::format("{}", 0.01 * row);
      for (int c = 0; c <= std::count(columns.begin(), columns.end(), ','); ++c)
        text += fmt::format(",{}", (c + row * row) % 3);
      text += "\n";
    }
    return logged_drive(sample_file(folder_.write("run.csv", text)), {}, robot);
  }
  TestFolder folder_;
};

TEST_F(LoggedDrives, AreServosWhereGoalsWereLoggedAndNoTorques) {
  EXPECT_EQ(drive("q0,q1,goal_q0,goal_q1", two_joints()), ActuatorKind::position_servo);
  EXPECT_EQ(drive("v0_rad_s,v1_rad_s,cmd_v0_rad_s,cmd_v1_rad_s", two_joints()), ActuatorKind::velocity_servo);
  EXPECT_EQ(drive("q0,q1,goal_q0,goal_q1,effort_0,effort_1", two_joints()), std::nullopt);
  EXPECT_EQ(drive("q0,q1,effort_0,effort_1", two_joints()), std::nullopt) << "as the robot has it";
}

TEST_F(LoggedDrives, AreTorquesOfServosWhoseGoalsWereNotLogged) {
  RobotSpec servos = two_joints();
  for (ActuatorSpec& actuator : servos.actuators) actuator.kind = ActuatorKind::position_servo;
  EXPECT_EQ(drive("q0,q1,effort_0,effort_1", servos), ActuatorKind::force);
  EXPECT_EQ(drive("q0,q1,goal_q0,goal_q1,effort_0,effort_1", servos), std::nullopt);
}

/// "position" is in the names of both sensors.
TEST_F(MatchRobot, AWordOfAllSensorsIsNoReason) {
  const RigGuess found = guess("position_shoulder,position_wrist", shoulder_and_elbow());
  ASSERT_EQ(found.sensors.size(), 2U);
  EXPECT_EQ(found.sensors[0].column.name, "position_shoulder");
  EXPECT_EQ(found.sensors[0].column.reason, "its name");
  EXPECT_EQ(found.sensors[1].column.name, "position_wrist");
  EXPECT_EQ(found.sensors[1].column.reason, "the only column that fits");
}

}  // namespace
}  // namespace lacuna

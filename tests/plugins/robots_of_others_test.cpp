#include "plugins/built_catalog.h"
#include "support/test_folder.h"

#include <lacuna/robot_format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Robot files as their authors wrote them (tests/robots/README.md). The figures were taken from the files by hand.
namespace lacuna {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::filesystem::path kRobots = std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests/robots";

class FolderOfFile : public FilesBeside {
 public:
  explicit FolderOfFile(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::optional<std::string> text_of(const std::string& path) const override {
    return std::filesystem::exists(folder_ / path) ? std::optional(read_bytes(folder_ / path)) : std::nullopt;
  }

 private:
  std::filesystem::path folder_;
};

ReadRobot read(const std::string& format, const std::string& name) {
  const std::filesystem::path file = kRobots / name;
  const FolderOfFile beside(file.parent_path());
  const ReadRobot robot =
      built_catalog().get<RobotFormat>(format).read({file.filename().string(), read_bytes(file), {}, &beside});
  std::vector<std::string> problems;
  for (const RobotFileProblem& problem : robot.problems) problems.push_back(problem.text);
  EXPECT_THAT(problems, IsEmpty()) << name;
  return robot;
}

std::vector<std::string> moving_joints(const RobotSpec& robot) {
  std::vector<std::string> names;
  for (const JointSpec& joint : robot.joints)
    if (joint.kind == JointKind::hinge || joint.kind == JointKind::slider) names.push_back(joint.name);
  return names;
}

double mass_of(const RobotSpec& robot) {
  double mass = 0.0;
  for (const BodySpec& body : robot.bodies) mass += body.mass;
  return mass;
}

std::vector<std::string> remarks(const ReadRobot& read, RobotRemarkKind kind) {
  std::vector<std::string> texts;
  for (const RobotRemark& remark : read.remarks)
    if (remark.kind == kind) texts.push_back(remark.text);
  return texts;
}

TEST(RobotsOfOthers, ArmOfSixJointsInUrdf) {
  const ReadRobot arm = read("urdf", "dart/kr5_sixx_r650.urdf");
  EXPECT_THAT(moving_joints(arm.robot),
              ElementsAre("shoulder_yaw", "shoulder_pitch", "elbow_pitch", "elbow_roll", "wrist_pitch", "wrist_roll"));
  EXPECT_NEAR(mass_of(arm.robot), 17.256865, 1e-6) << "its base is held by the world";
  EXPECT_EQ(arm.robot.actuators.size(), 6U);
  EXPECT_EQ(arm.robot.actuators[0].force_limit, kInfinity) << "an effort of 0 says nothing";
  EXPECT_DOUBLE_EQ(arm.robot.joints[0].upper, 2.9671);
  EXPECT_THAT(remarks(arm, RobotRemarkKind::repaired), IsEmpty());
}

TEST(RobotsOfOthers, ArmOfSevenJointsInUrdf) {
  const ReadRobot arm = read("urdf", "dart/wam.urdf");
  EXPECT_THAT(moving_joints(arm.robot), ElementsAre("_j1", "_j2", "_j3", "_j4", "_j5", "_j6", "_j7"));
  EXPECT_NEAR(mass_of(arm.robot), 19.455456, 1e-6);
  EXPECT_THAT(remarks(arm, RobotRemarkKind::repaired), Contains(HasSubstr("/j1")));
  EXPECT_THAT(remarks(arm, RobotRemarkKind::guessed), ElementsAre(HasSubstr("fixed to the world")));
}

TEST(RobotsOfOthers, BodyOnFourLegsInMjcf) {
  const ReadRobot ant = read("mjcf", "gym/ant.xml");
  EXPECT_EQ(moving_joints(ant.robot).size(), 8U);
  EXPECT_EQ(ant.robot.actuators.size(), 8U);
  EXPECT_EQ(ant.robot.joints.size(), 9U) << "and the one on which it floats";
  EXPECT_THAT(remarks(ant, RobotRemarkKind::guessed), Not(Contains(HasSubstr("held"))));
}

TEST(RobotsOfOthers, RunnerInMjcfWeighsWhatTheCompilerSays) {
  const ReadRobot runner = read("mjcf", "gym/half_cheetah.xml");
  EXPECT_EQ(moving_joints(runner.robot).size(), 9U);
  EXPECT_NEAR(mass_of(runner.robot), 14.0, 1e-6) << "settotalmass";
}

TEST(RobotsOfOthers, MobileArmOfThreeFilesInMjcf) {
  const ReadRobot fetch = read("mjcf", "gym/fetch/reach.xml");
  const std::vector<std::string> joints = moving_joints(fetch.robot);
  for (const char* joint : {"robot0_shoulder_pan_joint", "robot0_wrist_roll_joint", "robot0_l_gripper_finger_joint"})
    EXPECT_THAT(joints, Contains(joint));
  EXPECT_THAT(remarks(fetch, RobotRemarkKind::left_out), Contains(HasSubstr("mocap body")));
  EXPECT_THAT(remarks(fetch, RobotRemarkKind::left_out), Contains(HasSubstr("meshes")));
}

TEST(RobotsOfOthers, HumanoidInMjcf) {
  const ReadRobot humanoid = read("mjcf", "mujoco/humanoid.xml");
  EXPECT_EQ(moving_joints(humanoid.robot).size(), 21U);
  EXPECT_EQ(humanoid.robot.actuators.size(), 21U);
  EXPECT_THAT(remarks(humanoid, RobotRemarkKind::left_out), Contains(HasSubstr("touches nothing")));
}

}  // namespace
}  // namespace lacuna

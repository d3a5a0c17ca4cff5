#include "plugins/built_catalog.h"

#include <lacuna/robot_format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kDegree = std::numbers::pi / 180.0;

class Parts : public FilesBeside {
 public:
  explicit Parts(std::map<std::string, std::string> texts) : texts_(std::move(texts)) {}
  std::optional<std::string> text_of(const std::string& path) const override {
    const auto found = texts_.find(path);
    return found == texts_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::string, std::string> texts_;
};

ReadRobot read_mjcf(const std::string& text, RobotBase base = RobotBase::as_written,
                    const FilesBeside* beside = nullptr) {
  return built_catalog().get<RobotFormat>("mjcf").read({"robot.xml", text, base, beside});
}

constexpr const char* kInertial = "<inertial pos=\"0 0 -0.1\" mass=\"2\" diaginertia=\"0.02 0.03 0.04\"/>";

std::string mujoco(const std::string& inside) { return "<mujoco>\n" + inside + "</mujoco>\n"; }
std::string body(const std::string& name, const std::string& inside) {
  return "<body name=\"" + name + "\">" + inside + "</body>\n";
}
/// One body on one joint, and what stands beside the bodies.
std::string one_joint(const std::string& joint, const std::string& beside = "") {
  return mujoco(beside + "<worldbody>\n" + body("arm", kInertial + joint) + "</worldbody>");
}

std::string only_mjcf_problem(const std::string& text) {
  const ReadRobot made = read_mjcf(text);
  EXPECT_EQ(made.problems.size(), 1U) << text;
  return made.problems.empty() ? "" : made.problems.front().text;
}

bool mjcf_says(const ReadRobot& made, RobotRemarkKind kind, const std::string& text) {
  for (const RobotRemark& remark : made.remarks)
    if (remark.kind == kind && remark.text.find(text) != std::string::npos) return true;
  return false;
}

TEST(Mjcf, ReadsAnglesInDegreesUnlessTheFileSaysRadians) {
  const std::string joint = "<joint name=\"j\" range=\"-90 45\" frictionloss=\"0.2\"/>";
  const JointSpec degrees = read_mjcf(one_joint(joint)).robot.joints.at(0);
  EXPECT_NEAR(degrees.lower, -90.0 * kDegree, 1e-15);
  EXPECT_NEAR(degrees.upper, 45.0 * kDegree, 1e-15);
  EXPECT_DOUBLE_EQ(degrees.dry_friction, 0.2);
  EXPECT_DOUBLE_EQ(read_mjcf(one_joint(joint, "<compiler angle=\"radian\"/>")).robot.joints.at(0).upper, 45.0);
  const std::string slide = "<joint name=\"j\" type=\"slide\" range=\"-1 2\"/>";
  EXPECT_DOUBLE_EQ(read_mjcf(one_joint(slide)).robot.joints.at(0).upper, 2.0) << "metres stay";
}

TEST(Mjcf, TakesARangeForStopsAsTheCompilerSays) {
  const std::string joint = "<joint name=\"j\" range=\"-10 10\"/>";
  EXPECT_TRUE(std::isfinite(read_mjcf(one_joint(joint)).robot.joints.at(0).upper));
  EXPECT_TRUE(std::isinf(read_mjcf(one_joint(joint, "<compiler autolimits=\"false\"/>")).robot.joints.at(0).upper));
  EXPECT_TRUE(std::isinf(read_mjcf(one_joint("<joint limited=\"false\" range=\"-10 10\"/>")).robot.joints.at(0).upper));
  EXPECT_THAT(only_mjcf_problem(one_joint("<joint limited=\"true\"/>")), HasSubstr("joint is limited"));
}

/// A ratio of 1 on an inertia of J = 0.03 + 2·0.1² (about y through the origin) and a kp of 50 is 2·√(50·J).
TEST(Mjcf, MakesServosOfActuators) {
  const ReadRobot made = read_mjcf(one_joint("<joint name=\"j\" axis=\"0 1 0\"/>",
                                             "<actuator><position name=\"p\" joint=\"j\" kp=\"50\" dampratio=\"1\" "
                                             "forcerange=\"-5 8\" ctrlrange=\"-1 1\"/>"
                                             "<position name=\"q\" joint=\"j\" kp=\"50\" kv=\"4\"/></actuator>"));
  ASSERT_THAT(made.problems, IsEmpty());
  ASSERT_EQ(made.robot.actuators.size(), 2U);
  const ActuatorSpec& servo = made.robot.actuators[0];
  EXPECT_EQ(servo.kind, ActuatorKind::position_servo);
  EXPECT_DOUBLE_EQ(servo.kp, 50.0);
  EXPECT_NEAR(servo.kd, 2.0 * std::sqrt(50.0 * 0.05), 1e-12);
  EXPECT_DOUBLE_EQ(servo.force_limit, 8.0);
  EXPECT_DOUBLE_EQ(servo.command_lower, -1.0);
  EXPECT_TRUE(mjcf_says(made, RobotRemarkKind::left_out, "forcerange is not symmetrical"));
  EXPECT_DOUBLE_EQ(made.robot.actuators[1].kd, 4.0);
}

TEST(Mjcf, LeavesOutWhatDrivesNoJoint) {
  const ReadRobot made =
      read_mjcf(one_joint("<joint name=\"j\"/>",
                          "<tendon><fixed name=\"t\"><joint joint=\"j\" coef=\"1\"/></fixed></tendon>"
                          "<equality><weld body1=\"arm\"/></equality>"
                          "<actuator><motor name=\"m\" tendon=\"t\"/><muscle name=\"n\" joint=\"j\"/></actuator>"));
  ASSERT_THAT(made.problems, IsEmpty());
  EXPECT_THAT(made.robot.actuators, IsEmpty());
  EXPECT_TRUE(mjcf_says(made, RobotRemarkKind::left_out, "actuator m: it drives no joint"));
  EXPECT_TRUE(mjcf_says(made, RobotRemarkKind::left_out, "actuator n: <muscle>"));
  EXPECT_TRUE(mjcf_says(made, RobotRemarkKind::left_out, "tendons"));
  EXPECT_TRUE(mjcf_says(made, RobotRemarkKind::left_out, "equality constraints of these kinds: weld"));
}

TEST(Mjcf, MakesCouplingsOfStraightEqualities) {
  const ReadRobot made = read_mjcf(
      mujoco("<worldbody>" + body("l", std::string(kInertial) + "<joint name=\"l\" type=\"slide\"/>") +
             body("r", std::string(kInertial) + "<joint name=\"r\" type=\"slide\"/>") +
             "</worldbody><equality><joint joint1=\"r\" joint2=\"l\" polycoef=\"0.01 -1 0 0 0\"/></equality>"));
  ASSERT_THAT(made.problems, IsEmpty());
  ASSERT_EQ(made.robot.couplings.size(), 1U);
  EXPECT_DOUBLE_EQ(made.robot.couplings[0].ratio, -1.0);
  EXPECT_DOUBLE_EQ(made.robot.couplings[0].offset, 0.01);
  EXPECT_EQ(made.robot.actuators.size(), 1U) << "a motor is guessed for what follows no other";
}

TEST(Mjcf, NamesSensorsAsTheFileDoes) {
  const ReadRobot made =
      read_mjcf(one_joint("<joint name=\"j\" ref=\"90\"/><site name=\"imu\" pos=\"0 0 0.2\"/>",
                          "<sensor><jointpos name=\"angle\" joint=\"j\"/><accelerometer name=\"acc\" site=\"imu\"/>"
                          "<force name=\"f\" site=\"imu\"/></sensor>"));
  ASSERT_THAT(made.problems, IsEmpty());
  ASSERT_EQ(made.robot.sensors.size(), 3U);
  EXPECT_EQ(made.robot.sensors[0].name, "angle");
  EXPECT_NEAR(made.robot.sensors[0].offset, 90.0 * kDegree, 1e-15);
  EXPECT_EQ(made.robot.sensors[1].kind, SensorKind::accelerometer);
  EXPECT_TRUE(made.robot.sensors[1].at.isApprox(Eigen::Vector3d(0.0, 0.0, 0.2)));
  EXPECT_EQ(made.robot.sensors[2].name, "j_velocity");
  EXPECT_TRUE(mjcf_says(made, RobotRemarkKind::left_out, "sensors of these kinds: force"));
}

TEST(Mjcf, NeedsNoMeshes) {
  const ReadRobot made = read_mjcf(one_joint("<joint name=\"j\"/><geom type=\"mesh\" mesh=\"arm\"/>",
                                             "<asset><mesh name=\"arm\" file=\"gone.stl\"/></asset>"));
  EXPECT_THAT(made.problems, IsEmpty());
  EXPECT_TRUE(mjcf_says(made, RobotRemarkKind::left_out, "meshes"));
  EXPECT_DOUBLE_EQ(made.robot.bodies.at(0).mass, 2.0);
  const ReadRobot bare =
      read_mjcf(mujoco("<worldbody>" + body("a", "<joint/><geom type=\"mesh\" mesh=\"arm\"/>") + "</worldbody>"));
  EXPECT_DOUBLE_EQ(bare.robot.bodies.at(0).mass, 1e-3);
  EXPECT_TRUE(mjcf_says(bare, RobotRemarkKind::guessed, "meshes without a mass"));
}

TEST(Mjcf, FloatsOrIsHeldAsAsked) {
  const std::string floating = mujoco("<worldbody>" +
                                      body("trunk", std::string("<freejoint/>") + kInertial +
                                                        body("leg", std::string("<joint name=\"hip\"/>") + kInertial)) +
                                      "</worldbody>");
  EXPECT_EQ(read_mjcf(floating).robot.joints.at(0).kind, JointKind::free);
  const ReadRobot held = read_mjcf(floating, RobotBase::held);
  ASSERT_EQ(held.robot.joints.size(), 1U);
  EXPECT_EQ(held.robot.joints[0].parent, kWorld);
  std::string standing = floating;
  standing.erase(standing.find("<freejoint/>"), std::string("<freejoint/>").size());
  EXPECT_EQ(read_mjcf(standing).robot.bodies.size(), 1U);
  const ReadRobot freed = read_mjcf(standing, RobotBase::free);
  ASSERT_EQ(freed.robot.joints.size(), 2U);
  EXPECT_EQ(freed.robot.joints[0].kind, JointKind::free);
  EXPECT_EQ(freed.robot.joints[1].parent, "trunk");
  const ReadRobot hinged = read_mjcf(one_joint("<joint/>"), RobotBase::free);
  ASSERT_EQ(hinged.problems.size(), 1U);
  EXPECT_THAT(hinged.problems[0].text, HasSubstr("only a fixed body can be set free"));
}

TEST(Mjcf, ReadsWhatItIncludes) {
  const Parts parts(
      {{"parts/arm.xml", "<mujocoinclude>" + body("arm", std::string("<joint/>") + kInertial) + "</mujocoinclude>"},
       {"bad.xml", "<mujocoinclude>\n<geom size=\"x\"/></mujocoinclude>"},
       {"loop.xml", "<mujocoinclude><include file=\"loop.xml\"/></mujocoinclude>"}});
  const auto with = [&](const std::string& file) {
    return read_mjcf(mujoco("<worldbody><include file=\"" + file + "\"/></worldbody>"), RobotBase::as_written, &parts);
  };
  EXPECT_EQ(with("parts/arm.xml").robot.bodies.at(0).name, "arm");
  EXPECT_THAT(with("loop.xml").problems.at(0).text, HasSubstr("is already a part of this model"));
  EXPECT_EQ(with("loop.xml").problems.at(0).file, "loop.xml");
  EXPECT_THAT(with("../secret.xml").problems.at(0).text, HasSubstr("is not in the folder of the robot file"));
  const ReadRobot bad =
      read_mjcf(mujoco("<worldbody>" + body("a", std::string("<joint/><include file=\"bad.xml\"/>")) + "</worldbody>"),
                RobotBase::as_written, &parts);
  ASSERT_FALSE(bad.problems.empty());
  EXPECT_EQ(bad.problems[0].file, "bad.xml");
  EXPECT_EQ(bad.problems[0].line, 2);
}

/// The squares of their lengths are no numbers.
TEST(Mjcf, TakesDirectionsHoweverLongTheyAreWritten) {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.0, 1.0, 1.0) / std::sqrt(2.0);
  const ReadRobot made = read_mjcf(one_joint("<joint name=\"j\" axis=\"0 1e300 1e300\"/>", ""));
  ASSERT_THAT(made.problems, IsEmpty());
  EXPECT_TRUE(made.robot.joints.at(0).axis.isApprox(axis));
  const double half = std::sqrt(0.5);
  for (const char* turn : {"quat=\"1e300 0 1e300 0\"", "axisangle=\"0 1e300 0 90\"", "zaxis=\"1e300 0 0\"",
                           "xyaxes=\"0 0 -1e300 0 1e300 1e300\""}) {
    const ReadRobot turned = read_mjcf(mujoco("<worldbody><body name=\"a\" " + std::string(turn) +
                                              "><joint/><geom type=\"sphere\" size=\"0.1\"/></body></worldbody>"));
    ASSERT_THAT(turned.problems, IsEmpty()) << turn;
    const Eigen::Quaterniond wanted(half, 0.0, half, 0.0);
    EXPECT_LT(turned.robot.bodies.at(0).orientation.angularDistance(wanted), 1e-9) << turn;
  }
}

TEST(Mjcf, RefusesWhatIsTooLargeToComputeWith) {
  const std::string far = "<body name=\"tool\" pos=\"0 1e308 0\">" + std::string(kInertial) + "</body>";
  EXPECT_THAT(only_mjcf_problem(one_joint("<joint/>" + far)),
              HasSubstr("position of arm is too large to compute with"));
}

TEST(Mjcf, TellsAllProblemsAtTheirLines) {
  const ReadRobot made = read_mjcf(
      "<mujoco>\n<worldbody>\n<body name=\"a\">\n<joint axis=\"0 0 0\"/>\n<geom size=\"nan\"/>\n"
      "<body name=\"a\"><joint type=\"screw\" class=\"none\"/></body>\n</body></worldbody>\n</mujoco>");
  std::vector<int> lines;
  for (const RobotFileProblem& problem : made.problems) lines.push_back(problem.line);
  EXPECT_THAT(lines, testing::IsSupersetOf({4, 5, 6}));
  EXPECT_GE(lines.size(), 5U);
}

TEST(Mjcf, RefusesWhatIsNoMjcf) {
  EXPECT_THAT(only_mjcf_problem("<mujoco/>\nbody<!-- -->"), HasSubstr("text follows the outermost element"));
  EXPECT_THAT(only_mjcf_problem("<robot/>"), HasSubstr("its root is not <mujoco>"));
  EXPECT_THAT(only_mjcf_problem("<mujoco>"), HasSubstr("is not a complete XML document"));
  EXPECT_THAT(only_mjcf_problem(""), HasSubstr("is not a complete XML document"));
  EXPECT_THAT(only_mjcf_problem("<mujoco/>"), HasSubstr("nothing in it moves"));
  std::string deep = "<mujoco><worldbody>";
  for (int i = 0; i < 100000; ++i) deep += "<body>";
  EXPECT_THAT(only_mjcf_problem(deep), HasSubstr("is not a complete XML document"));
  EXPECT_THAT(only_mjcf_problem("<!DOCTYPE m [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]><mujoco model=\"&c;\"/>"),
              HasSubstr("nothing in it moves"))
      << "entities are not expanded";
}

TEST(Mjcf, ReadsTwentyThousandJoints) {
  std::string text = "<worldbody>";
  for (int i = 0; i < 20000; ++i) text += body("b" + std::to_string(i), std::string("<joint/>") + kInertial);
  const ReadRobot made = read_mjcf(mujoco(text + "</worldbody>"));
  EXPECT_THAT(made.problems, IsEmpty());
  EXPECT_EQ(made.robot.joints.size(), 20000U);
}

}  // namespace
}  // namespace lacuna

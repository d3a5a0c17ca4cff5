#include "plugins/built_catalog.h"

#include <lacuna/robot_format.h>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

ReadRobot read(const std::string& text) { return built_catalog().get<RobotFormat>("urdf").read({"robot.urdf", text}); }

std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name=\"" + name + "\">" + inside + "</link>\n";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& inside = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + inside + "</joint>\n";
}

std::string robot(const std::string& inside) { return "<robot name=\"arm\">\n" + inside + "</robot>\n"; }

constexpr const char* kUrdfInertial =
    "<inertial><origin xyz=\"0 0 0.1\"/><mass value=\"2\"/>"
    "<inertia ixx=\"0.02\" ixy=\"0\" ixz=\"0\" iyy=\"0.03\" iyz=\"0\" izz=\"0.04\"/></inertial>";

std::string one_link(const std::string& inertial, const std::string& of_joint = "", const char* type = "continuous") {
  return robot(link("base") + link("arm", inertial) + joint("hinge", type, "base", "arm", of_joint));
}

std::string only_problem(const std::string& text) {
  const ReadRobot made = read(text);
  EXPECT_EQ(made.problems.size(), 1U) << text;
  return made.problems.empty() ? "" : made.problems.front().text;
}

bool says(const ReadRobot& made, RobotRemarkKind kind, const std::string& text) {
  for (const RobotRemark& remark : made.remarks)
    if (remark.kind == kind && remark.text.find(text) != std::string::npos) return true;
  return false;
}

/// The joint's frame is turned by a quarter about x, so that its z lies along −y of the world.
TEST(Urdf, PlacesJointsAndLinksInTheWorld) {
  const ReadRobot made = read(one_link(kUrdfInertial,
                                       "<origin xyz=\"0.1 0 0.5\" rpy=\"1.5707963267948966 0 0\"/><axis xyz=\"0 0 2\"/>"
                                       "<limit lower=\"-1\" upper=\"2\" effort=\"30\" velocity=\"3\"/>"
                                       "<dynamics damping=\"0.5\" friction=\"0.2\"/>",
                                       "revolute"));
  ASSERT_THAT(made.problems, IsEmpty());
  ASSERT_EQ(made.robot.bodies.size(), 1U) << "the root is the world";
  const JointSpec& hinge = made.robot.joints.at(0);
  EXPECT_EQ(hinge.parent, kWorld);
  EXPECT_EQ(hinge.kind, JointKind::hinge);
  EXPECT_TRUE(hinge.anchor.isApprox(Eigen::Vector3d(0.1, 0.0, 0.5)));
  EXPECT_TRUE(hinge.axis.isApprox(Eigen::Vector3d(0.0, -1.0, 0.0)));
  EXPECT_DOUBLE_EQ(hinge.lower, -1.0);
  EXPECT_DOUBLE_EQ(hinge.upper, 2.0);
  EXPECT_DOUBLE_EQ(hinge.damping, 0.5);
  EXPECT_DOUBLE_EQ(hinge.dry_friction, 0.2);
  EXPECT_DOUBLE_EQ(made.robot.actuators.at(0).force_limit, 30.0);
  const BodySpec& arm = made.robot.bodies.at(0);
  EXPECT_TRUE((arm.position + arm.orientation * arm.com).isApprox(Eigen::Vector3d(0.1, -0.1, 0.5)));
  EXPECT_TRUE(says(made, RobotRemarkKind::left_out, "1 velocity limit"));
  EXPECT_TRUE(says(made, RobotRemarkKind::guessed, "base is fixed to the world"));
}

/// Two balls of 1 kg, half a metre apart: the centre lies between, and the inertia is that of both.
TEST(Urdf, JoinsWhatFixedJointsHold) {
  const std::string ball =
      "<inertial><mass value=\"1\"/><inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/>"
      "</inertial>";
  const ReadRobot made =
      read(robot(link("base") + link("arm", ball) + link("tool", ball) + joint("hinge", "continuous", "base", "arm") +
                 joint("mount", "fixed", "arm", "tool", "<origin xyz=\"0.5 0 0\"/>")));
  ASSERT_THAT(made.problems, IsEmpty());
  ASSERT_EQ(made.robot.bodies.size(), 1U);
  const BodySpec& arm = made.robot.bodies[0];
  EXPECT_DOUBLE_EQ(arm.mass, 2.0);
  EXPECT_TRUE(arm.com.isApprox(Eigen::Vector3d(0.25, 0.0, 0.0)));
  EXPECT_NEAR(arm.inertia.xx, 0.02, 1e-12);
  EXPECT_NEAR(arm.inertia.yy, 0.02 + 2.0 * 0.25 * 0.25, 1e-12);
  EXPECT_EQ(made.robot.joints.size(), 1U);
}

TEST(Urdf, RepairsInertiasThatNoBodyHas) {
  const ReadRobot made = read(one_link(
      "<inertial><mass value=\"1\"/><inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" iyy=\"0.01\" iyz=\"0\" izz=\"0.05\"/>"
      "</inertial>"));
  ASSERT_THAT(made.problems, IsEmpty());
  const InertiaSpec& inertia = made.robot.bodies.at(0).inertia;
  EXPECT_NEAR(inertia.xx, 0.02, 1e-12);
  EXPECT_NEAR(inertia.yy, 0.02, 1e-12);
  EXPECT_NEAR(inertia.zz, 0.04, 1e-12);
  EXPECT_TRUE(says(made, RobotRemarkKind::repaired, "link arm"));
  const ReadRobot none = read(one_link("<inertial><mass value=\"1\"/></inertial>"));
  EXPECT_NEAR(none.robot.bodies.at(0).inertia.xx, 0.4 * 0.05 * 0.05, 1e-12) << "a ball of 5 cm";
}

TEST(Urdf, GivesAMassToWhatMovesAndHasNone) {
  const ReadRobot made = read(one_link(""));
  EXPECT_DOUBLE_EQ(made.robot.bodies.at(0).mass, 1e-3);
  EXPECT_TRUE(says(made, RobotRemarkKind::guessed, "1 g is used"));
}

TEST(Urdf, MakesCouplingsOfMimics) {
  const ReadRobot made =
      read(robot(link("base") + link("left", kUrdfInertial) + link("right", kUrdfInertial) +
                 joint("l", "prismatic", "base", "left") +
                 joint("r", "prismatic", "base", "right", "<mimic joint=\"l\" multiplier=\"-1\" offset=\"0.01\"/>")));
  ASSERT_THAT(made.problems, IsEmpty());
  ASSERT_EQ(made.robot.couplings.size(), 1U);
  EXPECT_EQ(made.robot.couplings[0].joint, "r");
  EXPECT_EQ(made.robot.couplings[0].follows, "l");
  EXPECT_DOUBLE_EQ(made.robot.couplings[0].ratio, -1.0);
  EXPECT_DOUBLE_EQ(made.robot.couplings[0].offset, 0.01);
  EXPECT_EQ(made.robot.actuators.size(), 1U) << "what follows has no motor";
  EXPECT_EQ(made.robot.sensors.size(), 4U);
}

std::string controlled(const std::string& interfaces, const std::string& limit = "") {
  return robot(link("base") + link("arm", kUrdfInertial) + link("free", kUrdfInertial) +
               joint("hinge", "continuous", "base", "arm", limit) + joint("loose", "continuous", "arm", "free") +
               "<ros2_control name=\"c\" type=\"system\"><joint name=\"hinge\">" + interfaces +
               "<state_interface name=\"position\"/></joint></ros2_control>\n");
}

TEST(Urdf, DrivesWhatHasACommandInterface) {
  const ReadRobot force = read(controlled("<command_interface name=\"effort\"/>"));
  ASSERT_THAT(force.problems, IsEmpty());
  ASSERT_EQ(force.robot.actuators.size(), 1U);
  EXPECT_EQ(force.robot.actuators[0].kind, ActuatorKind::force);
  EXPECT_TRUE(says(force, RobotRemarkKind::guessed, "joint loose has no command interface"));
  const ReadRobot servo =
      read(controlled("<command_interface name=\"position\"><param name=\"min\">-1</param></command_interface>",
                      "<limit effort=\"20\" velocity=\"1\"/>"));
  ASSERT_THAT(servo.problems, IsEmpty());
  EXPECT_EQ(servo.robot.actuators.at(0).kind, ActuatorKind::position_servo);
  EXPECT_DOUBLE_EQ(servo.robot.actuators[0].kp, 200.0);
  EXPECT_DOUBLE_EQ(servo.robot.actuators[0].force_limit, 20.0);
  EXPECT_TRUE(says(servo, RobotRemarkKind::guessed, "kp = 200 and kd = 20 are used"));
  const ReadRobot both = read(controlled("<command_interface name=\"velocity\"/><command_interface name=\"effort\"/>"));
  EXPECT_EQ(both.robot.actuators.at(0).kind, ActuatorKind::force);
  EXPECT_TRUE(says(both, RobotRemarkKind::guessed, "several command interfaces"));
}

TEST(Urdf, ReadsTransmissionsOfRosOne) {
  const ReadRobot made =
      read(robot(link("base") + link("arm", kUrdfInertial) + joint("hinge", "continuous", "base", "arm") +
                 "<transmission name=\"t\"><type>transmission_interface/SimpleTransmission</type><joint name=\"hinge\">"
                 "<hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface></joint>"
                 "<actuator name=\"m\"><mechanicalReduction>50</mechanicalReduction></actuator></transmission>"));
  ASSERT_THAT(made.problems, IsEmpty());
  EXPECT_EQ(made.robot.actuators.at(0).kind, ActuatorKind::velocity_servo);
  EXPECT_DOUBLE_EQ(made.robot.actuators[0].transmission.ratio, 50.0);
  EXPECT_FALSE(says(made, RobotRemarkKind::left_out, "transmission"));
}

TEST(Urdf, FloatsOrIsHeldAsAsked) {
  const std::string text = one_link(kUrdfInertial);
  const auto with = [&](RobotBase base, const std::string& file) {
    return built_catalog().get<RobotFormat>("urdf").read({"robot.urdf", file, base, nullptr});
  };
  const ReadRobot freed = with(RobotBase::free, text);
  ASSERT_THAT(freed.problems, IsEmpty());
  ASSERT_EQ(freed.robot.joints.size(), 2U);
  EXPECT_EQ(freed.robot.joints[0].kind, JointKind::free);
  EXPECT_EQ(freed.robot.joints[1].parent, "base");
  const std::string floating =
      robot(link("world") + link("trunk", kUrdfInertial) + joint("root", "floating", "world", "trunk") +
            link("leg", kUrdfInertial) + joint("hip", "continuous", "trunk", "leg"));
  EXPECT_EQ(with(RobotBase::as_written, floating).robot.joints.at(0).kind, JointKind::free);
  const ReadRobot held = with(RobotBase::held, floating);
  ASSERT_EQ(held.robot.joints.size(), 1U);
  EXPECT_EQ(held.robot.joints[0].parent, kWorld);
}

/// Many files begin with a link "world" that a fixed joint holds to the first one that weighs.
TEST(Urdf, FloatsAlsoWhereItsRootIsCalledWorld) {
  const std::string text =
      robot(link("world") + link("trunk", kUrdfInertial) + joint("mount", "fixed", "world", "trunk") +
            link("leg", kUrdfInertial) + joint("hip", "continuous", "trunk", "leg"));
  const RobotText file{"robot.urdf", text, RobotBase::free, nullptr};
  const ReadRobot freed = built_catalog().get<RobotFormat>("urdf").read(file);
  ASSERT_THAT(freed.problems, IsEmpty());
  ASSERT_EQ(freed.robot.bodies.size(), 2U);
  EXPECT_EQ(freed.robot.bodies[0].name, "world_body");
  EXPECT_DOUBLE_EQ(freed.robot.bodies[0].mass, 2.0);
  EXPECT_EQ(freed.robot.joints.at(1).parent, "world_body") << "the leg hangs on the body, not on the world";
  EXPECT_TRUE(says(freed, RobotRemarkKind::repaired, "link world moves and gets the name world_body"));
  EXPECT_EQ(read(text).robot.joints.at(0).parent, kWorld);
  RobotSpec heavier = freed.robot;
  heavier.bodies[0].mass = 3.0;
  const WrittenRobot written = built_catalog().get<RobotFormat>("urdf").write({heavier, file, ""});
  const ReadRobot again =
      built_catalog().get<RobotFormat>("urdf").read({"robot.urdf", written.text, RobotBase::free, nullptr});
  EXPECT_DOUBLE_EQ(again.robot.bodies.at(0).mass, 3.0);
}

/// What several links have together is changed at the one that the joint moves.
TEST(Urdf, WritesIntoTheFileThatItRead) {
  const std::string text = robot("<!-- mine -->" + link("base") +
                                 link("arm", std::string(kUrdfInertial) + "<visual/>") + link("tool", kUrdfInertial) +
                                 joint("mount", "fixed", "arm", "tool", "<origin xyz=\"0 0 0.3\" rpy=\"0 0.2 0\"/>") +
                                 joint("hinge", "continuous", "base", "arm", "<dynamics damping=\"0.1\"/>"));
  const RobotFormat& format = built_catalog().get<RobotFormat>("urdf");
  RobotToWrite wanted{format.read({"robot.urdf", text}).robot, RobotText{"robot.urdf", text}, "found -- today"};
  BodySpec& arm = wanted.robot.bodies.at(0);
  arm.mass = 4.5;
  arm.com = {0.01, 0.02, 0.2};
  wanted.robot.joints.at(0).dry_friction = 0.25;
  const WrittenRobot written = format.write(wanted);
  ASSERT_THAT(written.problems, IsEmpty());
  EXPECT_THAT(written.text, testing::AllOf(HasSubstr("<!-- mine -->"), HasSubstr("<visual/>"),
                                           HasSubstr("found - - today"), HasSubstr("friction=\"0.25\"")));
  const RobotSpec back = format.read({"robot.urdf", written.text}).robot;
  EXPECT_NEAR(back.bodies.at(0).mass, 4.5, 1e-14);
  EXPECT_TRUE(back.bodies[0].com.isApprox(arm.com, 1e-13));
  EXPECT_NEAR(back.bodies[0].inertia.yy, arm.inertia.yy, 1e-14);
  EXPECT_NEAR(back.bodies[0].inertia.xz, arm.inertia.xz, 1e-14);
  EXPECT_DOUBLE_EQ(back.joints.at(0).damping, 0.1);
  EXPECT_DOUBLE_EQ(back.joints[0].dry_friction, 0.25);
}

/// Only what is another number than before is another text.
TEST(Urdf, KeepsTheTextOfTheFileThatItRead) {
  const auto file = [](const std::string& head, const std::string& mass, const std::string& friction) {
    return "<?xml version='1.0'?>\n<!-- mine -->\n" + head +
           "<robot\tname='arm' >\n\n<link name=\"base\"/> <!-- > -->\n"
           "\t<link name=\"arm\"  ><inertial><origin xyz=\"0 0 -0.2\" rpy=\"0 0 0\"/>\n\t\t<mass   value = '" +
           mass +
           "' />\n<inertia ixx=\"0.020\" ixy=\"0\" ixz=\"0.\" iyy=\"2e-2\" iyz=\"0\" izz=\"0.01\"/></inertial></link>\n"
           "  <joint name=\"hinge\" type=\"continuous\">\n      <parent link=\"base\"/><child link=\"arm\"/>" +
           friction + "\n  </joint>\n</robot>\n<!-- end -->\n";
  };
  const std::string text = file("", "1.50", "");
  const RobotFormat& format = built_catalog().get<RobotFormat>("urdf");
  RobotToWrite wanted{format.read({"robot.urdf", text}).robot, RobotText{"robot.urdf", text}, ""};
  EXPECT_EQ(format.write(wanted).text, text);
  wanted.comment = "Identified by Lacuna: today\n";
  wanted.robot.bodies.at(0).mass = 2.25;
  wanted.robot.joints.at(0).dry_friction = 0.25;
  const std::string edited =
      file("<!--\nIdentified by Lacuna: today\n-->\n", "2.25", "\n      <dynamics damping=\"0\" friction=\"0.25\"/>");
  EXPECT_EQ(format.write(wanted).text, edited);
  wanted.original->text = edited;
  EXPECT_EQ(format.write(wanted).text, edited) << "the comment of an earlier export is replaced";
}

TEST(Urdf, NamesElementsAsTheProgramCan) {
  const ReadRobot made =
      read(robot(link("base") + link("arm.1", kUrdfInertial) + joint("j/1", "continuous", "base", "arm.1")));
  ASSERT_THAT(made.problems, IsEmpty());
  EXPECT_EQ(made.robot.bodies.at(0).name, "arm_1");
  EXPECT_EQ(made.robot.joints.at(0).child, "arm_1");
  EXPECT_TRUE(says(made, RobotRemarkKind::repaired, "\"arm.1\" gets the name arm_1"));
}

/// The square of its length is no number.
TEST(Urdf, TakesTheDirectionOfAnAxisHoweverLongItIs) {
  const ReadRobot made = read(robot(link("base") + link("arm", kUrdfInertial) +
                                    joint("hinge", "continuous", "base", "arm", "<axis xyz=\"0 -1e308 1e308\"/>")));
  ASSERT_THAT(made.problems, IsEmpty());
  EXPECT_TRUE(made.robot.joints.at(0).axis.isApprox(Eigen::Vector3d(0.0, -1.0, 1.0) / std::sqrt(2.0)));
}

TEST(Urdf, RefusesWhatIsTooLargeToComputeWith) {
  EXPECT_THAT(only_problem(robot(link("base") + link("arm", kUrdfInertial) + link("tool", kUrdfInertial) +
                                 joint("hinge", "continuous", "base", "arm") +
                                 joint("mount", "fixed", "arm", "tool", "<origin xyz=\"0 1e308 0\"/>"))),
              HasSubstr("position of arm is too large to compute with"));
}

TEST(Urdf, TakesNothingForANumberThatIsNone) {
  const std::string comma = "<inertial><mass value=\"1,5\"/></inertial>";
  EXPECT_THAT(only_problem(one_link(comma)), HasSubstr("mass's value \"1,5\" is not a number"));
  EXPECT_THAT(only_problem(one_link("<inertial><mass value=\"nan\"/></inertial>")), HasSubstr("is not a number"));
  EXPECT_THAT(only_problem(one_link(kUrdfInertial, "<axis xyz=\"0 1\"/>")), HasSubstr("must be three numbers"));
  EXPECT_THAT(only_problem(one_link(kUrdfInertial, "<axis xyz=\"0 0 0\"/>")), HasSubstr("has no direction"));
  EXPECT_EQ(read(one_link(comma)).problems.front().line, 3);
}

TEST(Urdf, SaysWhatIsWrongWithATree) {
  EXPECT_THAT(only_problem(robot(link("a") + link("b", kUrdfInertial) + joint("j", "continuous", "a", "c"))),
              HasSubstr("names the link \"c\", which does not exist"));
  EXPECT_THAT(only_problem(robot(link("a") + link("b"))), HasSubstr("are both without a parent"));
  EXPECT_THAT(
      only_problem(robot(link("a") + link("b") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a"))),
      HasSubstr("form a loop"));
  EXPECT_THAT(only_problem(robot(link("a") + link("b") + link("c") + joint("j", "fixed", "a", "c") +
                                 joint("k", "fixed", "b", "c"))),
              HasSubstr("is the child of two joints"));
  EXPECT_THAT(only_problem(robot(link("a") + link("b") + joint("j", "elastic", "a", "b"))),
              HasSubstr("\"elastic\" is unknown"));
}

/// As old xacro writes it, a comment first.
TEST(Urdf, ReadsADeclarationBehindAComment) {
  const std::string head = "<!-- made by xacro -->\n<?xml version=\"1.0\" ?>\n";
  EXPECT_THAT(read(head + one_link(kUrdfInertial)).problems, IsEmpty());
  EXPECT_EQ(read(head + one_link("<inertial><mass value=\"x\"/></inertial>")).problems.at(0).line, 5);
}

TEST(Urdf, RefusesWhatIsNoUrdf) {
  EXPECT_THAT(only_problem("<robot name=\"x\"><link name=\"a\">"), HasSubstr("is not a complete XML document"));
  EXPECT_THAT(only_problem("<mujoco/>"), HasSubstr("its root is not <robot>"));
  EXPECT_THAT(only_problem("<robot xmlns:xacro=\"http://wiki.ros.org/xacro\"><xacro:include filename=\"a\"/></robot>"),
              HasSubstr("is a xacro file"));
  EXPECT_THAT(only_problem("<robot><link name=\"a\"/><xacro:arm prefix=\"${p}\"/></robot>"),
              HasSubstr("make it with xacro FILE > robot.urdf"));
  EXPECT_THAT(read("<robot name=\"x\"><!-- from <xacro:arm/>, xacro:a --><link name=\"a\"/></robot>").problems,
              IsEmpty());
  EXPECT_THAT(only_problem("<robot name=\"x\"/>"), HasSubstr("has no <link>"));
  EXPECT_THAT(only_problem("<robot name=\"x\"><link name=\"a\"/></robot>\nlink<!-- -->"),
              HasSubstr("text follows the outermost element"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THAT(only_problem(deep), HasSubstr("is not a complete XML document"));
}

/// Entities of a document's own are not expanded, however often each names the one before.
TEST(Urdf, DoesNotExpandEntities) {
  EXPECT_THAT(only_problem("<!DOCTYPE r [<!ENTITY a \"1\"><!ENTITY b \"&a;&a;\">]>" +
                           one_link("<inertial><mass value=\"&b;\"/></inertial>")),
              HasSubstr("\"&b;\" is not a number"));
}

TEST(Urdf, TakesNoInertiaThatIsNoNumber) {
  EXPECT_THAT(
      only_problem(one_link("<inertial><mass value=\"1\"/>\n<inertia ixx=\"NaN\" iyy=\"1\" izz=\"1\"/></inertial>")),
      HasSubstr("inertia's ixx \"NaN\" is not a number"));
}

/// A chain of as many links as nobody builds ends, too.
TEST(Urdf, ReadsTwentyThousandJoints) {
  std::string text = link("l0");
  for (int i = 1; i <= 20000; ++i) {
    const std::string before = "l" + std::to_string(i - 1), name = "l" + std::to_string(i);
    text += link(name, kUrdfInertial) + joint("j" + std::to_string(i), "continuous", before, name);
  }
  const ReadRobot made = read(robot(text));
  EXPECT_THAT(made.problems, IsEmpty());
  EXPECT_EQ(made.robot.joints.size(), 20000U);
}

}  // namespace
}  // namespace lacuna

#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kUrdfArm = R"(<robot name="arm">
  <link name="base"/>
  <link name="arm">
    <inertial><origin xyz="0 0 -0.2"/><mass value="1.0"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.03"/></inertial>
  </link>
  <joint name="hinge" type="continuous">
    <parent link="base"/><child link="arm"/><axis xyz="0 1 0"/><limit effort="5" velocity="2"/>
  </joint>
</robot>
)";

constexpr const char* kExperiment = R"([experiment]
name = "arm"
seed = 1
[target]
kind = "simulated"
file = "arm.urdf"
noise = { "sensor.hinge_position" = "1 mrad" }
effects = [ { id = "stick", effect = "coulomb_friction", where = "joint.hinge", start = { torque = 0.1 } } ]
[model]
file = "arm.urdf"
free = { "body.arm.mass" = [0.5, 2.0] }
effects = []
[engine]
step = "4 ms"
)";

class RobotFormatFiles : public testing::Test {
 protected:
  RobotFormatFiles() {
    program_.write("arm.urdf", kUrdfArm);
    program_.write("arm.toml", kExperiment);
  }
  const Program program_;
};

TEST_F(RobotFormatFiles, AreCheckedWithWhatWasGuessedRepairedAndLeftOut) {
  const Outcome check = program_.run({"check", "arm.toml"});
  ASSERT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output,
              AllOf(HasSubstr("joints    hinge"), HasSubstr("arm.urdf:3: repaired: the inertia of link"),
                    HasSubstr("left out: 1 velocity limit"), HasSubstr("guessed: link base is fixed to the world")));
  const std::size_t first = check.output.find("repaired");
  EXPECT_EQ(check.output.find("repaired", first + 1), std::string::npos) << "model and target have one file";
}

TEST_F(RobotFormatFiles, AreDiagnosedLikeOthers) {
  ASSERT_EQ(program_.run({"trial", "arm.toml", "--test", "multisine hinge 1 N*m 0.2-2 Hz 5 s seed 3"}).exit_code, 0);
  const Outcome diagnosis = program_.run({"diagnose", "arm.toml", "--among", "coulomb_friction", "viscous_friction"});
  ASSERT_EQ(diagnosis.exit_code, 0) << diagnosis.errors;
  EXPECT_THAT(diagnosis.output, HasSubstr("1  coulomb_friction @ joint.hinge"));
}

TEST_F(RobotFormatFiles, AreRefusedWithEveryProblemAtItsLine) {
  std::string bad = kUrdfArm;
  bad.replace(bad.find("1.0"), 3, "1,0");
  bad.replace(bad.find("continuous"), 10, "elastic");
  program_.write("arm.urdf", bad);
  const Outcome check = program_.run({"check", "arm.toml"});
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.errors, AllOf(HasSubstr("arm.urdf:4: mass's value \"1,0\" is not a number"),
                                  HasSubstr("arm.urdf:6: joint's type \"elastic\" is unknown")));
  program_.write("arm.urdf", "");
  EXPECT_THAT(program_.run({"check", "arm.toml"}).errors, HasSubstr("arm.urdf: is not a complete XML document"));
  program_.write("arm.xml", kUrdfArm);
  EXPECT_EQ(program_.run({"check", "arm.toml", "--set", "model.file=\"arm.xml\"", "--set", "target.file=\"arm.xml\""})
                .exit_code,
            0)
      << "the root element tells the formats of .xml apart";
  program_.write("arm.sdf", kUrdfArm);
  const Outcome other = program_.run({"check", "arm.toml", "--set", "model.file=\"arm.sdf\""});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, HasSubstr("its name ends with none of .mjcf, .toml, .urdf, .xml"));
  program_.write("arm.urdf.xacro", kUrdfArm);
  EXPECT_THAT(program_.run({"check", "arm.toml", "--set", "model.file=\"arm.urdf.xacro\""}).errors,
              HasSubstr("type xacro arm.urdf.xacro > arm.urdf"));
}

constexpr const char* kScene = R"(<mujoco model="arm">
  <include file="parts/defaults.xml"/>
  <worldbody>
    <body name="arm"><joint name="hinge" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 -0.4" size="0.03"/>
      <body name="hand" pos="0 0 -0.4"><joint name="finger" axis="0 1 0"/><geom type="sphere" size="0.02"/></body>
    </body>
  </worldbody>
  <actuator><motor name="hinge" joint="hinge" ctrlrange="-1 1"/></actuator>
</mujoco>
)";

/// A file that it includes is part of it: what is wrong there is said with its place, and what changes there counts.
TEST_F(RobotFormatFiles, MayIncludeOthersBelowTheirFolder) {
  std::filesystem::create_directory(program_.folder() / "parts");
  program_.write("parts/defaults.xml", "<mujocoinclude><default><joint damping=\"0.1\"/></default></mujocoinclude>\n");
  program_.write("arm.xml", kScene);
  const std::vector<std::string> check = {
      "check", "arm.toml", "--set", "model.file=\"arm.xml\"", "--set", "target.file=\"arm.xml\""};
  const Outcome good = program_.run(check);
  EXPECT_EQ(good.exit_code, 0) << good.errors;
  EXPECT_THAT(good.output, HasSubstr("joints    hinge, finger"));
  program_.write("parts/defaults.xml", "<mujocoinclude><default>\n<joint damping=\"x\"/></default></mujocoinclude>\n");
  const Outcome bad = program_.run(check);
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.errors, HasSubstr("parts/defaults.xml:2: joint's damping \"x\" is not a number"));
  std::string beyond = kScene;
  beyond.replace(beyond.find("parts/defaults.xml"), 18, "../arm.toml");
  program_.write("arm.xml", beyond);
  EXPECT_THAT(program_.run(check).errors, HasSubstr("arm.xml:2: include's file"));
}

TEST_F(RobotFormatFiles, AreHeldOrFreeAsTheModelSays) {
  std::filesystem::create_directory(program_.folder() / "parts");
  program_.write("parts/defaults.xml", "<mujocoinclude/>");
  program_.write("arm.xml", kScene);
  std::string experiment = kExperiment;
  for (std::size_t at; (at = experiment.find("arm.urdf")) != std::string::npos;) experiment.replace(at, 8, "arm.xml");
  experiment.insert(experiment.find("free = {"), "held = [\"joint.fin*\"]\n");
  program_.write("arm.toml", experiment);
  const Outcome held = program_.run({"check", "arm.toml"});
  EXPECT_EQ(held.exit_code, 0) << held.errors;
  const Outcome none = program_.run({"check", "arm.toml", "--set", "model.held=[\"joint.toe\"]"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.errors, HasSubstr("the robot has no joint \"joint.toe\""));
  program_.write("arm.toml", kExperiment);
  const Outcome floats =
      program_.run({"check", "arm.toml", "--set", "model.base=\"free\"", "--set", "target.base=\"free\""});
  EXPECT_EQ(floats.exit_code, 0) << floats.errors;
  EXPECT_THAT(floats.output, HasSubstr("base_free"));
}

/// Columns find the joints of the robot by name.
TEST_F(RobotFormatFiles, AreWhatNewDraftsARigFor) {
  std::string log = "time_s,hinge_position_rad,hinge_effort_Nm\n";
  for (int i = 0; i < 400; ++i)
    log += std::to_string(0.01 * i) + "," + std::to_string(0.3 * std::sin(0.03 * i)) + "," +
           std::to_string(0.5 * std::sin(0.03 * i + 0.4)) + "\n";
  program_.write("log.csv", log);
  const Outcome drafted = program_.run({"new", "rig.toml", "--robot", "arm.urdf", "--from", "log.csv"});
  ASSERT_EQ(drafted.exit_code, 0) << drafted.errors;
  EXPECT_THAT(drafted.output, AllOf(HasSubstr("sensor.hinge_position  rad    hinge_position_rad  rad"),
                                    HasSubstr("actuator.hinge         N*m    hinge_effort_Nm     N*m")));
  EXPECT_EQ(program_.run({"compare", "rig.toml"}).exit_code, 0);
}

}  // namespace
}  // namespace lacuna

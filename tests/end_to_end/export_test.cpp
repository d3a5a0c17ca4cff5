#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kSamePrediction = 1e-9;  ///< rad

constexpr const char* kUrdf = R"(<robot name="arm">
  <!-- the foot stands on the table -->
  <link name="base"/>
  <link name="arm">
    <inertial><origin xyz="0 0 -0.2"/><mass value="1.0"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.01"/></inertial>
    <visual><geometry><mesh filename="meshes/arm.stl"/></geometry></visual>
  </link>
  <joint name="hinge" type="continuous">
    <parent link="base"/><child link="arm"/><axis xyz="0 1 0"/><limit effort="5" velocity="2"/>
  </joint>
  <link name="tool"><inertial><mass value="0.2"/><inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial></link>
  <joint name="mount" type="fixed"><parent link="arm"/><child link="tool"/><origin xyz="0 0 -0.4"/></joint>
</robot>
)";

constexpr const char* kToml = R"(# my arm
[robot]
name = "arm"
[body.arm]
mass = "1 kg"            # weighed
com = [0.0, 0.0, -0.2]
inertia = [0.02, 0.02, 0.01]
[joint.hinge]
parent = "world"
child = "arm"
axis = "y"
[actuator.hinge]
joint = "hinge"
[sensor.hinge_position]
kind = "joint_position"
joint = "hinge"
[sensor.hinge_velocity]
kind = "joint_velocity"
joint = "hinge"
)";

constexpr const char* kMjcf = R"(<mujoco model="arm">
  <!-- the foot stands on the table -->
  <default><joint damping="0.05"/></default>
  <asset><mesh name="arm" file="meshes/arm.stl"/></asset>
  <worldbody>
    <body name="arm">
      <joint name="hinge" axis="0 1 0"/>
      <inertial pos="0 0 -0.2" mass="1.0" diaginertia="0.02 0.02 0.01"/>
      <geom type="mesh" mesh="arm" mass="0"/>
    </body>
  </worldbody>
  <actuator><motor name="hinge" joint="hinge" gear="1"/></actuator>
</mujoco>
)";

std::string experiment_of(const std::string& name, const std::string& robot, const std::string& model) {
  return "[experiment]\nname = \"" + name + "\"\nseed = 1\n[target]\nkind = \"simulated\"\nfile = \"" + robot +
         "\"\nset = { \"body.arm.mass\" = 1.3 }\nnoise = { \"sensor.hinge_position\" = \"1 mrad\" }\n"
         "effects = [ { effect = \"coulomb_friction\", where = \"joint.hinge\", start = { torque = 0.1 } },\n"
         "  { effect = \"viscous_friction\", where = \"joint.hinge\", start = { damping = 0.2 } } ]\n"
         "[engine]\nstep = \"4 ms\"\nsubsteps = 2\n" +
         model;
}

std::string fitted_model(const std::string& robot) {
  return "[model]\nfile = \"" + robot +
         "\"\nset = { \"joint.hinge.armature\" = 0.003 }\n"
         "free = { \"body.arm.mass\" = [0.5, 3.0] }\n"
         "effects = [ { effect = \"coulomb_friction\", where = \"joint.hinge\" },\n"
         "  { effect = \"viscous_friction\", where = \"joint.hinge\" },\n"
         "  { effect = \"command_delay\", where = \"actuator.hinge\", start = { delay = 0.004 }, fixed = [\"delay\"] } "
         "]\n";
}

constexpr const char* kExportTest = "multisine hinge 1 N*m 0.5-2 Hz 3 s seed 5";

class Exported : public testing::Test {
 protected:
  /// Fits the model to a trial of the target, and exports it; the command's output.
  std::string exported_as(const std::string& option, const std::string& file) const {
    EXPECT_EQ(program_.run({"trial", "rig.toml", "--test", "multisine hinge 1 N*m 0.5-2 Hz 4 s seed 3"}).exit_code, 0);
    const Outcome outcome = program_.run({"export", "rig.toml", option, file});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return outcome.output;
  }

  std::vector<double> prediction(const std::string& experiment) const {
    const Outcome outcome = program_.run({"predict", experiment, "--test", kExportTest, "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    std::vector<double> values;
    const nlohmann::json read = nlohmann::json::parse(outcome.output);
    for (const nlohmann::json& part : read.at("predictions"))
      for (const nlohmann::json& channel : part.at("channels"))
        for (const nlohmann::json& value : channel.at("predicted")) values.push_back(value.get<double>());
    EXPECT_GT(values.size(), 100U);
    return values;
  }

  /// The exported model in an experiment of its own predicts what the fitted one does.
  void expect_same_prediction(const std::string& robot) {
    program_.write("back.toml", experiment_of("back", robot, program_.read(robot + ".model.toml")));
    const std::vector<double> fitted = prediction("rig.toml"), back = prediction("back.toml");
    ASSERT_EQ(fitted.size(), back.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < fitted.size(); ++i) largest = std::max(largest, std::abs(fitted[i] - back[i]));
    EXPECT_LT(largest, kSamePrediction);
  }

  const Program program_;
};

TEST_F(Exported, AsUrdfIsTheFileWithTheIdentifiedValues) {
  program_.write("arm.urdf", kUrdf);
  program_.write("rig.toml", experiment_of("rig", "arm.urdf", fitted_model("arm.urdf")));
  EXPECT_THAT(exported_as("--urdf", "found.urdf"),
              AllOf(HasSubstr("coulomb_friction @ joint.hinge is joint.hinge.dry_friction there"),
                    HasSubstr("joint.hinge.armature = 0.003"), HasSubstr("actuator.hinge.delay = 0.004")));
  EXPECT_THAT(program_.read("found.urdf"),
              AllOf(HasSubstr("the foot stands on the table"), HasSubstr("meshes/arm.stl"), HasSubstr("friction="),
                    HasSubstr("Identified by Lacuna: rig, revision 1"), HasSubstr("body.arm.mass = ")));
  expect_same_prediction("found.urdf");
}

TEST_F(Exported, AsTomlIsTheFileWithTheIdentifiedValues) {
  program_.write("arm.toml", kToml);
  program_.write("rig.toml", experiment_of("rig", "arm.toml", fitted_model("arm.toml")));
  EXPECT_THAT(exported_as("--toml", "found.toml"),
              AllOf(HasSubstr("the model's file"), HasSubstr("values that this format cannot hold: none")));
  EXPECT_THAT(program_.read("found.toml"),
              AllOf(HasSubstr("# my arm"), HasSubstr("# weighed"), Not(HasSubstr("1 kg")),
                    HasSubstr("armature = 0.003"), HasSubstr("dry_friction = "), HasSubstr("delay = 0.004")));
  expect_same_prediction("found.toml");
}

TEST_F(Exported, AsMjcfIsTheFileWithTheIdentifiedValues) {
  program_.write("arm.xml", kMjcf);
  program_.write("rig.toml", experiment_of("rig", "arm.xml", fitted_model("arm.xml")));
  exported_as("--mjcf", "found.xml");
  EXPECT_THAT(program_.read("found.xml"),
              AllOf(HasSubstr("the foot stands on the table"), HasSubstr("meshes/arm.stl"), HasSubstr("frictionloss="),
                    HasSubstr("armature=\"0.003\""), HasSubstr("Identified by Lacuna: rig, revision 1")));
  expect_same_prediction("found.xml");
}

TEST_F(Exported, IntoAnotherFormatIsARobotOfItsOwn) {
  program_.write("arm.toml", kToml);
  program_.write("rig.toml", experiment_of("rig", "arm.toml", fitted_model("arm.toml")));
  exported_as("--urdf", "found.urdf");
  expect_same_prediction("found.urdf");
  ASSERT_EQ(program_.run({"export", "rig.toml", "--mjcf", "found.xml"}).exit_code, 0);
  expect_same_prediction("found.xml");
}

TEST_F(Exported, FromUrdfAsTomlIsARobotOfItsOwn) {
  program_.write("arm.urdf", kUrdf);
  program_.write("rig.toml", experiment_of("rig", "arm.urdf", fitted_model("arm.urdf")));
  exported_as("--toml", "found.toml");
  expect_same_prediction("found.toml");
}

TEST_F(Exported, AnEarlierRevisionStaysEarlier) {
  program_.write("arm.urdf", kUrdf);
  program_.write("rig.toml", experiment_of("rig", "arm.urdf", fitted_model("arm.urdf")));
  exported_as("--urdf", "first.urdf");
  ASSERT_EQ(program_.run({"add", "rig.toml", "stribeck_friction", "--where", "joint.hinge"}).exit_code, 0);
  const Outcome first = program_.run({"export", "rig.toml", "--urdf", "again.urdf", "--revision", "1"});
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  EXPECT_EQ(program_.read("first.urdf"), program_.read("again.urdf"));
  EXPECT_THAT(program_.run({"history", "rig.toml"}).output, HasSubstr("2*"));
  const Outcome none = program_.run({"export", "rig.toml", "--urdf", "none.urdf", "--revision", "9"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.errors, HasSubstr("has no such revision"));
}

TEST_F(Exported, InThreeFormatsAtOnceHasAFileBesideEach) {
  program_.write("arm.toml", kToml);
  program_.write("rig.toml", experiment_of("rig", "arm.toml", fitted_model("arm.toml")));
  exported_as("--toml", "found.toml");
  const Outcome again =
      program_.run({"export", "rig.toml", "--urdf", "all.urdf", "--mjcf", "all.xml", "--toml", "all.toml"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(program_.read("all.urdf.model.toml"), HasSubstr("file = \"all.urdf\""));
  EXPECT_THAT(program_.read("all.xml.model.toml"), HasSubstr("file = \"all.xml\""));
  EXPECT_THAT(program_.read("all.toml.model.toml"), HasSubstr("file = \"all.toml\""));
  EXPECT_EQ(program_.read("all.toml"), program_.read("found.toml"));
}

TEST_F(Exported, ReplacesNoFileUnlessForced) {
  program_.write("arm.urdf", kUrdf);
  program_.write("rig.toml", experiment_of("rig", "arm.urdf", fitted_model("arm.urdf")));
  exported_as("--urdf", "found.urdf");
  const std::string before = program_.read("found.urdf.model.toml");
  std::filesystem::remove(program_.folder() / "found.urdf");
  const Outcome refused = program_.run({"export", "rig.toml", "--urdf", "found.urdf"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("found.urdf.model.toml: exists already"), HasSubstr("--force")));
  EXPECT_FALSE(std::filesystem::exists(program_.folder() / "found.urdf"));
  program_.write("found.urdf.model.toml", "mine\n");
  EXPECT_EQ(program_.run({"export", "rig.toml", "--urdf", "found.urdf", "--force"}).exit_code, 0);
  EXPECT_EQ(program_.read("found.urdf.model.toml"), before);
}

TEST_F(Exported, NeedsAFileThatIsNotRead) {
  program_.write("arm.urdf", kUrdf);
  program_.write("rig.toml", experiment_of("rig", "arm.urdf", fitted_model("arm.urdf")));
  const Outcome nothing = program_.run({"export", "rig.toml"});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.errors, HasSubstr("say what to write: --toml robot.toml"));
  const Outcome itself = program_.run({"export", "rig.toml", "--urdf", "arm.urdf"});
  EXPECT_EQ(itself.exit_code, 2);
  EXPECT_EQ(program_.read("arm.urdf"), kUrdf);
}

}  // namespace
}  // namespace lacuna

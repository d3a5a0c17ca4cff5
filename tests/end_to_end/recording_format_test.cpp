#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kRecordedArm = R"(<robot name="arm">
  <link name="base"/>
  <link name="arm">
    <inertial><origin xyz="0 0 -0.2"/><mass value="1.0"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.003"/></inertial>
  </link>
  <joint name="hinge" type="continuous">
    <parent link="base"/><child link="arm"/><axis xyz="0 1 0"/><limit effort="5" velocity="20"/>
  </joint>
</robot>
)";

/// A file, and the columns that the joint's sensors and its actuator are to get.
struct Recorded {
  std::string file, position, effort;
};

class RecordingFormats : public testing::TestWithParam<Recorded> {
 protected:
  RecordingFormats() {
    program_.write("arm.urdf", kRecordedArm);
    const std::filesystem::path source =
        std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests/plugins/recordings" / GetParam().file;
    if (std::filesystem::exists(source)) std::filesystem::copy(source, program_.folder() / GetParam().file);
    if (GetParam().file == "arm.jsonl") program_.write("arm.jsonl", json_lines());
  }

  static std::string json_lines() {
    std::string text;
    for (int i = 0; i < 200; ++i)
      text += "{\"t\": " + std::to_string(0.01 * i) + ", \"state\": {\"name\": [\"hinge\"], \"position\": [" +
              std::to_string(0.3 * std::sin(0.03 * i)) + "], \"effort\": [" + std::to_string(0.5 * std::sin(0.03 * i)) +
              "]}}\n";
    return text;
  }

  /// With the units that arrays and objects do not tell.
  static std::string filled(std::string text) {
    const std::pair<std::string, std::string> kUnits[] = {
        {"hinge_position = ", "rad"}, {"hinge_velocity = ", "rad/s"}, {"hinge = ", "N*m"}};
    for (const auto& [key, unit] : kUnits) {
      const std::size_t line = text.find("\n" + key);
      const std::size_t blank = line == text.npos ? line : text.find("\"FILL IN\"", line);
      if (blank < text.find('\n', line + 1)) text.replace(blank, 9, "\"" + unit + "\"");
    }
    return text;
  }

  const Program program_;
};

TEST_P(RecordingFormats, AreDraftedCheckedAndCompared) {
  const Outcome drafted = program_.run({"new", "rig.toml", "--robot", "arm.urdf", "--from", GetParam().file});
  ASSERT_EQ(drafted.exit_code, 0) << drafted.errors;
  EXPECT_THAT(drafted.output, AllOf(HasSubstr("sensor.hinge_position  rad    " + GetParam().position),
                                    HasSubstr("actuator.hinge         N*m    " + GetParam().effort)));
  program_.write("rig.toml", filled(program_.read("rig.toml")));
  const Outcome check = program_.run({"check", "rig.toml"});
  EXPECT_EQ(check.exit_code, 0) << check.errors << program_.read("rig.toml");
  const Outcome comparison = program_.run({"compare", "rig.toml"});
  EXPECT_EQ(comparison.exit_code, 0) << comparison.errors;
  EXPECT_THAT(comparison.output, HasSubstr("hinge_position"));
}

INSTANTIATE_TEST_SUITE_P(OfOtherPrograms, RecordingFormats,
                         testing::Values(Recorded{"arm.jsonl", "state.position[hinge]", "state.effort[hinge]"},
                                         Recorded{"arm.npz", "hinge_position", "hinge_effort"},
                                         Recorded{"arm.mat", "log.hinge_position", "log.hinge_effort"},
                                         Recorded{"run.db3", "/joint_states.position[hinge]  rad",
                                                  "/joint_states.effort[hinge]    N*m"},
                                         Recorded{"run_lz4.mcap", "/joint_states.position[hinge]  rad",
                                                  "/joint_states.effort[hinge]    N*m"}),
                         [](const auto& test) {
                           std::string name = test.param.file;
                           for (char& c : name)
                             if (c == '.') c = '_';
                           return name;
                         });

/// Shells complete its name with a slash.
TEST(FolderOfABag, IsTheRecordingInIt) {
  const Program program;
  program.copy_bags();
  std::filesystem::create_directory(program.folder() / "run");
  std::filesystem::rename(program.folder() / "arm.db3", program.folder() / "run" / "run_0.db3");
  const Outcome without = program.run({"new", "rig.toml", "--robot", "arm.urdf", "--from", "run/"});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.errors, HasSubstr("a folder of ROS 2 has a metadata.yaml"));
  program.write("run/metadata.yaml", "rosbag2_bagfile_information:\n  relative_file_paths:\n    - run_0.db3\n");
  const Outcome drafted = program.run({"new", "rig.toml", "--robot", "arm.urdf", "--from", "run/"});
  ASSERT_EQ(drafted.exit_code, 0) << drafted.errors;
  EXPECT_THAT(program.read("rig.toml"), HasSubstr("files = [\"run\"]"));
  const Outcome check = program.run({"check", "rig.toml"});
  EXPECT_EQ(check.exit_code, 0) << check.errors;
  EXPECT_THAT(check.output, HasSubstr("run from 0 s to 8.99 s"));
}

}  // namespace
}  // namespace lacuna

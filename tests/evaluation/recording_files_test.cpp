// From files of other programs to trials, by the plugins of this build.

#include "evaluation/recording_files.h"
#include "measurement/guesses/file_sample.h"
#include "measurement/recording.h"
#include "measurement/rig_guess.h"
#include "plugins/built_catalog.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr const char* kArm = R"(<robot name="arm">
  <link name="base"/>
  <link name="arm">
    <inertial><origin xyz="0 0 -0.2"/><mass value="1.0"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.003"/></inertial>
  </link>
  <joint name="hinge" type="continuous">
    <parent link="base"/><child link="arm"/><axis xyz="0 1 0"/><limit effort="5" velocity="20"/>
  </joint>
</robot>
)";

RobotSpec arm() { return built_catalog().get<RobotFormat>("urdf").read({"arm.urdf", kArm}).robot; }

std::filesystem::path recorded(const std::string& name) {
  return std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "tests/plugins/recordings" / name;
}

/// The torque at 0.01 s·i, as the generators of the files have it.
double torque(int i) { return 0.5 * std::sin(0.03 * i) + 0.2 * std::sin(0.11 * i); }

ColumnMapping mapping(const std::string& channel, const std::string& column, const std::string& unit) {
  ColumnMapping mapping;
  mapping.channel = channel;
  mapping.column = column;
  mapping.unit = unit;
  return mapping;
}

/// A file, and the columns that the joint's sensor of position and its actuator are to get.
struct RecordedArm {
  std::string file, position, effort;
};

class RecordedArms : public testing::TestWithParam<RecordedArm> {
 protected:
  const PluginRecordingFormats formats_{built_catalog()};
};

TEST_P(RecordedArms, AreMatchedWithARobotAndRead) {
  const std::filesystem::path file = recorded(GetParam().file);
  const RobotSpec robot = arm();
  ASSERT_TRUE(formats_.reads(file));
  const RigGuess guess = guess_rig({sample_file(file, &formats_)}, {}, robot);
  ASSERT_EQ(guess.sensors.size(), 2U);
  EXPECT_EQ(guess.sensors[0].column.name, GetParam().position);
  ASSERT_EQ(guess.commands.size(), 1U);
  EXPECT_EQ(guess.commands[0].column.name, GetParam().effort);
  const Recording recording = read_recording(source_of(guess, {{file}}), robot, &formats_);
  const Trial& trial = recording.trials.front();
  ASSERT_GE(trial.measured.times.size(), 30);
  for (Eigen::Index i = 0; i < 30; ++i) {
    EXPECT_NEAR(trial.measured.times[i], 0.01 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(trial.commands.series.samples(i, 0), torque(static_cast<int>(i)), 1e-12);
  }
  EXPECT_NEAR(trial.measured.samples(0, 0), 0.1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    OfOtherPrograms, RecordedArms,
    testing::Values(RecordedArm{"arm.npz", "hinge_position", "hinge_effort"},
                    RecordedArm{"arm.mat", "log.hinge_position", "log.hinge_effort"},
                    RecordedArm{"run.db3", "/joint_states.position[hinge]", "/joint_states.effort[hinge]"},
                    RecordedArm{"run_lz4.mcap", "/joint_states.position[hinge]", "/joint_states.effort[hinge]"}),
    [](const auto& test) {
      std::string name = test.param.file;
      for (char& c : name)
        if (c == '.') c = '_';
      return name;
    });

/// Commands of a controller come half as often, 1 ms after the states.
TEST(RecordedBags, JoinTopicsByTheirTimes) {
  const PluginRecordingFormats formats(built_catalog());
  const RobotSpec robot = arm();
  RecordingSource source;
  source.files = {{.path = recorded("run_zstd.mcap")}};
  source.sensors = {mapping("hinge_position", "/joint_states.position[hinge]", "rad")};
  source.commands = {mapping("hinge", "/effort_controller/commands.data[0]", "N*m")};
  const Recording recording = read_recording(source, robot, &formats);
  const Trial& trial = recording.trials.front();
  ASSERT_GT(trial.measured.times.size(), 250)
      << "200 states and 100 commands, but for what is before the first command";
  EXPECT_EQ(trial.commands.series.samples(0, 0), torque(0));
  EXPECT_NEAR(trial.measured.times[1] - trial.measured.times[0], 0.009, 1e-9);
  std::string notes;
  for (const ReadingNote& note : recording.notes) notes += note.message + "\n";
  EXPECT_THAT(notes, HasSubstr("times of /joint_states are the stamps in its headers"));
  EXPECT_THAT(notes, HasSubstr("/robot_description holds a robot description"));
}

TEST(RecordedFiles, KeepTheirFormatWhateverTheCaseOfTheirEnding) {
  const PluginRecordingFormats formats(built_catalog());
  EXPECT_TRUE(formats.reads("RUN.MCAP"));
  EXPECT_TRUE(formats.reads("a.b.npz"));
  EXPECT_FALSE(formats.reads("run.csv"));
  EXPECT_FALSE(formats.reads("mcap"));
}

}  // namespace
}  // namespace lacuna

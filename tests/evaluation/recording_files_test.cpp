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
  EXPECT_THAT(notes, HasSubstr("/robot_description contains a robot description"));
}

/// A folder as `ros2 bag record` leaves it, with files of another format, which are easier to write.
class RecordingFolders : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directory(folder_ / "run"); }
  void write_metadata(const std::string& list) const {
    folder_.write("run/metadata.yaml", "rosbag2_bagfile_information:\n  version: 5\n" + list + "  duration:\n");
  }
  ReadRows read(std::size_t most = 100) const {
    return formats_.read(folder_ / "run", {{"", {"t", "q", "late"}, most}});
  }
  std::string problem() const {
    const RecordingContents contents = formats_.contents(folder_ / "run");
    return contents.problems.empty() ? "" : contents.problems.front().text;
  }

  TestFolder folder_;
  const PluginRecordingFormats formats_{built_catalog()};
};

TEST_F(RecordingFolders, AreReadFileByFileInTheOrderOfTheirMetadata) {
  write_metadata("  relative_file_paths:\n    - run/b.jsonl\n    - 'a.jsonl'\n");
  folder_.write("run/b.jsonl", "{\"t\": 0.0, \"q\": 1}\n{\"t\": 0.1, \"q\": 2}\n");
  folder_.write("run/a.jsonl", "{\"t\": 0.2, \"q\": 3, \"late\": 7}\n");
  folder_.write("run/other.jsonl", "{\"t\": 9, \"q\": 9}\n");
  ASSERT_TRUE(formats_.reads(folder_ / "run"));
  const RecordedRows rows = read().tables.at(0);
  EXPECT_THAT(rows.columns.at(0), testing::ElementsAre(0.0, 0.1, 0.2));
  EXPECT_THAT(rows.columns.at(1), testing::ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(rows.columns.at(2), testing::ElementsAre(testing::IsNan(), testing::IsNan(), 7.0));
  EXPECT_THAT(read(2).tables.at(0).columns.at(0), testing::ElementsAre(0.0, 0.1));
}

TEST_F(RecordingFolders, WithoutAListAreReadByTheNumbersInTheNames) {
  write_metadata("");
  folder_.write("run/run_10.jsonl", "{\"t\": 1.0, \"q\": 2, \"late\": 0}\n");
  folder_.write("run/run_9.jsonl", "{\"t\": 0.0, \"q\": 1, \"late\": 0}\n");
  EXPECT_THAT(read().tables.at(0).columns.at(1), testing::ElementsAre(1.0, 2.0));
}

/// Nanoseconds since 1970 are counted from another time in each file.
TEST_F(RecordingFolders, GiveTheRowsOfTheBagInThem) {
  write_metadata("  relative_file_paths:\n    - run_0.db3\n    - run_1.db3\n");
  for (const char* part : {"run_0.db3", "run_1.db3"})
    std::filesystem::copy_file(recorded("run.db3"), folder_ / "run" / part);
  const TableQuery query = {"/joint_states", {"t", "position[hinge]"}};
  const RecordedRows alone = formats_.read(recorded("run.db3"), {query}).tables.at(0);
  const RecordedRows twice = formats_.read(folder_ / "run", {query}).tables.at(0);
  const std::size_t rows = alone.columns.at(0).size();
  ASSERT_EQ(twice.columns.at(0).size(), 2 * rows);
  EXPECT_EQ(twice.origins, alone.origins);
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t row = 0; row < 2 * rows; ++row)
      EXPECT_EQ(twice.columns[c][row], alone.columns[c][row % rows]) << c << " " << row;
}

TEST_F(RecordingFolders, SayWhatIsMissing) {
  EXPECT_FALSE(formats_.reads(folder_ / "run")) << "it has no metadata.yaml";
  write_metadata("");
  EXPECT_THAT(problem(), HasSubstr("no recording beside it"));
  folder_.write("run/run_0.db3.zstd", "");
  EXPECT_THAT(problem(), HasSubstr("no file that can be read as a recording, only run_0.db3.zstd"));
  write_metadata("  relative_file_paths:\n    - run_0.mcap\n");
  EXPECT_THAT(problem(), HasSubstr("its file run_0.mcap: there is no such file; copy it there"));
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

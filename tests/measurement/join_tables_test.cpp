#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Torques by one logger, angles by another.
class JoinedFiles : public testing::Test {
 protected:
  TestFolder folder;

  std::string drive = "t,u\n0.0,1\n0.1,2\n0.2,3\n0.3,4\n0.4,5\n";
  std::string camera = "t,q\n10.05,0.05\n10.15,0.15\n10.25,0.25\n10.95,0.95\n";
  FurtherFile with{.offset = -10.0};

  RecordingSource source() {
    folder.write("drive.csv", drive);
    RecordingSource read = pendulum_source(folder.path() / "drive.csv");
    with.path = folder.write("camera.csv", camera);
    with.location = {"rig.toml", 5, 9};
    read.files.front().with = {with};
    return read;
  }
};

TEST_F(JoinedFiles, ReadingsKeepTheirOwnTimes) {
  const Recording recording = read_pendulum(source());
  ASSERT_EQ(recording.trials.size(), 1u);
  const Trial& trial = recording.trials.front();
  const double times[] = {0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4};
  const double commands[] = {1, 1, 2, 2, 3, 3, 4, 5};
  ASSERT_EQ(trial.measured.times.size(), 8);
  for (Eigen::Index i = 0; i < 8; ++i) {
    EXPECT_NEAR(trial.measured.times[i], times[i], 1e-12);
    EXPECT_EQ(trial.commands.series.samples(i, 0), commands[i]);
    const bool is_reading = i == 1 || i == 3 || i == 5;
    EXPECT_EQ(std::isnan(trial.measured.samples(i, 0)), !is_reading);
    if (is_reading) {
      EXPECT_NEAR(trial.measured.samples(i, 0), times[i], 1e-12);
    }
  }
  EXPECT_EQ(trial.name, "drive.csv");
}

/// offset + skew·(time since the file's first sample).
TEST_F(JoinedFiles, ASkewStretchesTheOtherClock) {
  with.skew = 0.5;
  const Trial trial = read_pendulum(source()).trials.front();
  for (Eigen::Index i = 0; i < trial.measured.times.size(); ++i)
    if (const double angle = trial.measured.samples(i, 0); !std::isnan(angle)) {
      EXPECT_NEAR(trial.measured.times[i], angle + 0.5 * (angle - 0.05), 1e-12);
    }
}

TEST_F(JoinedFiles, SamplesAtTheSameTimeShareARow) {
  camera = "t,q\n10.1,0.1\n10.2,0.2\n10.3,0.3\n";
  EXPECT_EQ(read_pendulum(source()).trials.front().measured.times.size(), 5);
}

/// Where the commands come from the other file, only the time counts in which they are known.
TEST_F(JoinedFiles, CommandsMustBeKnown) {
  std::swap(drive, camera);
  with.offset = 10.12;
  const Recording recording = read_pendulum(source());
  const Trial& trial = recording.trials.front();
  EXPECT_TRUE(std::isnan(trial.measured.samples(0, 0)));  // the first row is a command's
  EXPECT_EQ(trial.commands.series.samples(0, 0), 1.0);
  EXPECT_NEAR(trial.measured.times[1], 0.03, 1e-9);  // the angle at 10.15 s
  EXPECT_THAT(notes_of(recording),
              HasSubstr("used from 10.12 s to 10.52 s, where the commands of the other files are"));
}

TEST_F(JoinedFiles, AnotherUnitAndColumnOfTime) {
  camera = "stamp,q\n10050,0.05\n10150,0.15\n10250,0.25\n";
  with.time_column = "stamp";
  with.time_unit = "ms";
  EXPECT_NEAR(read_pendulum(source()).trials.front().measured.times[1], 0.05, 1e-12);
}

TEST_F(JoinedFiles, NoTimeInCommonIsAProblem) {
  with.offset = 0.0;
  EXPECT_THAT(
      complaint_of(source()),
      HasSubstr("camera.csv: has no time in common with drive.csv: it covers 10.05 s to 10.95 s on the clock of "
                "drive.csv, which covers 0 s to 0.4 s. State the difference of the clocks, as in offset = \"-3 s\""));
}

TEST_F(JoinedFiles, AColumnThatNoneHasIsAProblem) {
  camera = "t,angle\n10.05,0.05\n10.15,0.15\n";
  EXPECT_THAT(complaint_of(source()), HasSubstr("no column `q`"));
}

TEST_F(JoinedFiles, AColumnThatBothHaveIsTheFirstOnesUnlessNamed) {
  drive = "t,u,q\n0.0,1,7\n0.1,2,7\n0.2,3,7\n0.3,4,7\n0.4,5,7\n";
  EXPECT_EQ(read_pendulum(source()).trials.front().measured.samples(0, 0), 7.0);
  with.columns = {"q"};
  EXPECT_NEAR(read_pendulum(source()).trials.front().measured.samples(1, 0), 0.05, 1e-12);
}

TEST_F(JoinedFiles, BothFilesProblemsAreTold) {
  drive = "t,u\n0.0,1\n0.1,x\n";
  camera = "t,q\n10.05,0.05\n10.01,0.15\n";
  const std::string told = complaint_of(source());
  EXPECT_THAT(told, HasSubstr("drive.csv:3"));
  EXPECT_THAT(told, HasSubstr("camera.csv:3"));
}

TEST_F(JoinedFiles, AFileIsNamedOnce) {
  RecordingSource twice = source();
  twice.files.front().with.front().path = twice.files.front().path;
  EXPECT_THAT(complaint_of(twice), HasSubstr("drive.csv is named twice"));
}

/// A smooth chirp of torque on an inertia of 0.1 kg·m², filmed at 50 Hz with a clock that shows 3.2 s less.
TEST_F(JoinedFiles, AnOffsetIsFoundAndNoted) {
  drive = "t,u\n";
  camera = "t,q\n";
  const auto angle = [](double t) { return 0.3 * std::sin(2.0 * t + 0.15 * t * t); };
  const auto bend = [&](double t) { return (angle(t + 1e-4) + angle(t - 1e-4) - 2.0 * angle(t)) / 1e-8; };
  for (int i = 0; i <= 2000; ++i) drive += fmt::format("{:.3f},{:.6f}\n", 0.005 * i, 0.1 * bend(0.005 * i + 0.0025));
  for (int i = 0; i <= 500; ++i) camera += fmt::format("{:.3f},{:.6f}\n", 0.02 * i - 3.2, angle(0.02 * i));
  with.offset = std::nullopt;
  const Recording recording = read_pendulum(source());
  EXPECT_THAT(notes_of(recording), HasSubstr("its clock was compared with that of drive.csv by `motor`: offset = 3.2"));
  const Trial& trial = recording.trials.front();
  double largest = 0.0;
  for (Eigen::Index i = 0; i < trial.measured.times.size(); ++i)
    if (const double read = trial.measured.samples(i, 0); !std::isnan(read))
      largest = std::max(largest, std::abs(read - angle(trial.measured.times[i])));
  EXPECT_LT(largest, 2e-3);
  with.between = {-1.0, 1.0};
  EXPECT_THAT(complaint_of(source()), HasSubstr("offset of its clock against that of drive.csv was not found"));
}

/// Intervals of the table are no clock's: those of each file are looked at.
TEST_F(JoinedFiles, IntervalsAreThoseOfEachFile) {
  camera = "t,q\n10.01,0.01\n10.11,0.11\n10.21,0.21\n10.31,0.31\n";
  EXPECT_EQ(notes_of(read_pendulum(source())), "");
  camera = "t,q\n10.01,0.01\n10.02,0.02\n10.03,0.03\n10.04,0.04\n10.31,0.31\n";
  EXPECT_THAT(notes_of(read_pendulum(source())), HasSubstr("camera.csv:6: about 26 samples of 31 are missing"));
}

/// A command that pauses is held, which nobody knows to be right.
TEST_F(JoinedFiles, APauseOfCommandsIsAProblem) {
  drive = "t,q\n0.0,0\n0.1,0.1\n0.2,0.2\n0.3,0.3\n0.4,0.4\n";
  camera = "t,u\n10.00,1\n10.01,2\n10.02,3\n10.03,4\n10.38,5\n";
  EXPECT_THAT(complaint_of(source()), HasSubstr("camera.csv:6: a gap of 0.35 s before this sample"));
}

TEST_F(JoinedFiles, ARowThatRepeatsIsLeftOut) {
  camera = "t,q\n10.05,0.05\n10.05,0.05\n10.15,0.15\n10.25,0.25\n";
  EXPECT_EQ(read_pendulum(source()).trials.front().measured.times.size(), 8);
  drive += "0.4,5\n";
  EXPECT_EQ(read_pendulum(source()).trials.front().measured.times.size(), 8);
}

/// A piece may begin at a row of either file: its commands are known.
TEST_F(JoinedFiles, PiecesBeginAtAnyRow) {
  for (const double from : {0.12, 0.16}) {  // before a reading, before a command
    RecordingSource cut = source();
    cut.use = {{from, 0.4}};
    const Trial trial = read_pendulum(cut).trials.front();
    EXPECT_EQ(trial.commands.series.samples(0, 0), from < 0.15 ? 2.0 : 3.0);
    EXPECT_EQ(trial.commands.before[0], 2.0);
  }
  RecordingSource held = source();
  held.files.front().holdout = {{0.22, 0.4}};
  const Recording recording = read_pendulum(held);
  ASSERT_EQ(recording.trials.size(), 2u);
  EXPECT_EQ(recording.trials[1].commands.series.samples(0, 0), 3.0);
}

TEST_F(JoinedFiles, AFileThatCannotBeReadIsOneProblem) {
  drive = "";
  camera = "stamp,q\n10.05,0.05\n10.15,0.15\n";
  EXPECT_THAT(complaint_of(source()), HasSubstr("drive.csv"));
}

TEST_F(JoinedFiles, AColumnNamedInVainIsAProblem) {
  with.columns = {"qq"};
  EXPECT_THAT(
      complaint_of(source()),
      HasSubstr(
          "columns names `qq` (did you mean \"q\"?), which the experiment reads from no file; it reads `q`, `u`"));
}

/// The first file's own time begins with its first date, wherever the trial does.
TEST_F(JoinedFiles, DatesCountFromTheFirstFiles) {
  drive =
      "t,q\n2024-05-01T12:00:00Z,0\n2024-05-01T12:00:01Z,1\n2024-05-01T12:00:02Z,2\n2024-05-01T12:00:03Z,3\n"
      "2024-05-01T12:00:04Z,4\n";
  camera = "t,u\n2024-05-01T12:00:01.5Z,1\n2024-05-01T12:00:02.5Z,2\n2024-05-01T12:00:03.5Z,3\n";
  with.offset = 0.0;
  RecordingSource cut = source();
  cut.use = {{1.9, 3.2}};
  const Recording recording = read_pendulum(cut);
  EXPECT_EQ(recording.trials.front().measured.samples(0, 0), 2.0);
  EXPECT_THAT(notes_of(recording), HasSubstr("used from 1.5 s to 3.5 s"));
}

TEST_F(JoinedFiles, ReadingsThatBeginLateAreNoted) {
  camera = "t,q\n10.15,0.15\n10.25,0.25\n10.35,0.35\n";
  EXPECT_THAT(
      notes_of(read_pendulum(source())),
      HasSubstr(
          "there are no readings before 0.15 s: begin there, as in use = [[0.15, 0.4]], or state the initial state"));
}

TEST_F(JoinedFiles, ThreeFilesAreOneTrial) {
  drive = "t\n0.0\n0.1\n0.2\n0.3\n0.4\n";
  RecordingSource three = source();
  FurtherFile motor{.path = folder.write("motor.csv", "t,u\n5.02,7\n5.12,8\n5.35,9\n"), .offset = -5.0};
  three.files.front().with.push_back(motor);
  const Trial trial = read_pendulum(three).trials.front();
  EXPECT_NEAR(trial.measured.times[1], 0.03, 1e-9);  // the reading of 10.05 s after the command of 5.02 s
  EXPECT_EQ(trial.commands.series.samples(1, 0), 7.0);
}

}  // namespace
}  // namespace lacuna

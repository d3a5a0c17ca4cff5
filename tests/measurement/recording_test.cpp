#include "measurement/recording.h"

#include "measurement_fixture.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;

constexpr double kDegree = std::numbers::pi / 180.0;

class ReadRecording : public testing::Test {
 protected:
  TestFolder folder_;
};

TEST_F(ReadRecording, GivesSiUnitsUnderTheRobotsNames) {
  RecordingSource source =
      pendulum_source(folder_.write("run.csv", "time_ms,volt,angle_deg,rate\n0,1,0,0.5\n2,2,90,1.5\n4,3,-180,2.5\n"));
  source.time_column = "time_ms";
  source.time_unit = "ms";
  source.sensors[0].column = "angle_deg";
  source.sensors[0].unit = "deg";
  source.sensors[0].offset = 0.25;
  source.sensors.insert(source.sensors.begin(), source.sensors[0]);
  source.sensors[0].channel = "rate";
  source.sensors[0].column = "rate";
  source.sensors[0].unit = "rad/s";
  source.sensors[0].offset = 0.0;
  source.sensors[0].noise = 0.01;
  source.commands[0].column = "volt";
  source.commands[0].unit = "V";
  source.commands[0].gain = 0.5;
  source.commands[0].gain_unit = "N*m/V";

  const Recording recording = read_pendulum(source);
  ASSERT_EQ(recording.trials.size(), 1u);
  const Trial& trial = recording.trials.front();
  EXPECT_EQ(trial.name, "run.csv");
  EXPECT_EQ(trial.measured.channels, kPendulumChannels);  // the robot's order, not the file's
  EXPECT_EQ(trial.commands.series.channels, kPendulumActuators);
  EXPECT_THAT(std::vector<double>(trial.measured.times.begin(), trial.measured.times.end()),
              ElementsAre(0.0, 0.002, 0.004));
  EXPECT_DOUBLE_EQ(trial.measured.samples(1, 0), 90.0 * kDegree + 0.25);
  EXPECT_DOUBLE_EQ(trial.measured.samples(2, 1), 2.5);
  EXPECT_DOUBLE_EQ(trial.commands.series.samples(2, 0), 1.5);
  EXPECT_TRUE(std::isnan(trial.sensor_noise[0]));
  EXPECT_EQ(trial.sensor_noise[1], 0.01);
  EXPECT_EQ(recording.notes.size(), 0u) << notes_of(recording);
}

/// Stretches of one file that are held out, beside those that are fitted to.
TEST_F(ReadRecording, KeepsStretchesOfAFileFromTheFit) {
  RecordingSource source = pendulum_source(
      folder_.write("run.csv", "t,q,u\n0,1,0\n1,2,0\n2,3,1\n3,4,1\n4,5,2\n5,6,2\n6,7,3\n7,8,3\n8,9,4\n"));
  source.mask = {{0.0, 0.0}};
  source.files.front().use = {{0.0, 7.0}};
  source.files.front().mask = {{1.0, 1.0}};
  source.files.front().holdout = {{2.0, 3.5}};
  source.max_gap = 100.0;
  const std::vector<Trial> trials = read_pendulum(source).trials;
  ASSERT_EQ(trials.size(), 3U);
  EXPECT_EQ(trials[0].name, "run.csv from 0 s to 1 s");
  EXPECT_EQ(trials[1].name, "run.csv from 4 s to 7 s");
  EXPECT_EQ(trials[2].name, "run.csv from 2 s to 3 s");
  EXPECT_EQ(std::vector<bool>({trials[0].held_out, trials[1].held_out, trials[2].held_out}),
            std::vector<bool>({false, false, true}));
  EXPECT_TRUE(trials[0].measured.samples.array().isNaN().all());  // the file's mask and that of all
  EXPECT_EQ(trials[2].measured.times(1), 1.0);
  EXPECT_EQ(trials[2].measured.samples(0, 0), 3.0);
  EXPECT_EQ(trials[2].commands.before.at(0), 0.0);
}

TEST_F(ReadRecording, RefusesAHeldOutStretchOfWhichNothingIsUsed) {
  RecordingSource source = pendulum_source(folder_.write("run.csv", "t,q,u\n0,1,0\n1,2,0\n2,3,0\n3,4,0\n"));
  source.files.front().holdout = {{20.0, 30.0}};
  EXPECT_THAT(complaint_of(source), HasSubstr("holdout from 20 s to 30 s"));
  source.files.front().holdout = {{2.0, 3.0}};
  EXPECT_EQ(complaint_of(source), "");
  source.files.front().use = {{0.0, 1.0}};
  EXPECT_THAT(complaint_of(source), HasSubstr("holdout from 2 s to 3 s"));
}

/// A trial that is shorter than the others has no part of it.
TEST_F(ReadRecording, HoldsStretchesOutOfTheTrialsThatHaveThem) {
  RecordingSource source =
      pendulum_source(folder_.write("run.csv", "t,q,u,n\n0,1,0,1\n1,2,0,1\n2,3,0,1\n3,4,0,1\n0,1,0,2\n1,2,0,2\n"));
  source.trial_column = "n";
  source.files.front().holdout = {{2.0, 3.0}};
  const std::vector<Trial> trials = read_pendulum(source).trials;
  ASSERT_EQ(trials.size(), 3U);
  EXPECT_FALSE(trials[1].held_out);
  EXPECT_TRUE(trials[2].held_out);
}

/// Of any zone; a date has its unit in itself.
TEST_F(ReadRecording, ReadsDatesAsTimeStamps) {
  RecordingSource source =
      pendulum_source(folder_.write("run.csv",
                                    "t,q,u\n2024-02-29T23:59:59.75Z,1,0\n2024-02-29 23:59:59.875,2,0\n"
                                    "2024-03-01T02:00:00.000001+02:00,3,0\n"));
  source.time_unit = "ms";
  const Trial trial = read_pendulum(source).trials.at(0);
  EXPECT_THAT(std::vector<double>(trial.measured.times.begin(), trial.measured.times.end()),
              ElementsAre(0.0, 0.125, DoubleNear(0.250001, 1e-12)));
}

TEST_F(ReadRecording, RefusesTimeStampsOfTwoKinds) {
  for (const char* stamp : {"1.5", "2024-02-30T00:00:00Z", "2024-02-28T25:00:00Z", "2024-02-28", "yesterday"}) {
    const std::string rows = fmt::format("t,q,u\n2024-02-27T00:00:00Z,1,0\n{},2,0\n", stamp);
    const RecordingSource source = pendulum_source(folder_.write("run.csv", rows));
    EXPECT_THROW(read_pendulum(source), BadInput) << stamp;
  }
}

TEST_F(ReadRecording, KeepsMicrosecondsSince1970Exactly) {
  RecordingSource source = pendulum_source(
      folder_.write("run.csv", "t,q,u\n1700000000000001,1,0\n1700000000001001,2,0\n1700000000002003,3,0\n"));
  source.time_unit = "us";
  const Recording recording = read_pendulum(source);
  EXPECT_DOUBLE_EQ(recording.trials[0].measured.times[1], 1000e-6);
  EXPECT_DOUBLE_EQ(recording.trials[0].measured.times[2], 2002e-6);
  EXPECT_THAT(notes_of(recording), HasSubstr("shifted to start at 0 s"));
}

TEST_F(ReadRecording, KeepsFractionsOfSecondsSince1970) {
  const Recording recording = read_pendulum(pendulum_source(
      folder_.write("run.csv", "t,q,u\n1700000000.000001,1,0\n1700000000.001001,2,0\n1700000001.000003,3,0\n")));
  EXPECT_NEAR(recording.trials[0].measured.times[1], 1000e-6, 1e-12);
  EXPECT_NEAR(recording.trials[0].measured.times[2], 1.000002, 1e-12);
}

TEST_F(ReadRecording, TellsTrialsApartByAColumnAndHoldsSomeOut) {
  RecordingSource source = pendulum_source(
      folder_.write("runs.csv", "t,run,q,u\n0,sine,1,0\n0.1,sine,2,0\n5,step,3,0\n5.1,step,4,0\n0.2,sine,5,0\n"));
  source.trial_column = "run";
  source.holdout_trials = {"sine"};
  const Recording recording = read_pendulum(source);
  ASSERT_EQ(recording.trials.size(), 2u);
  EXPECT_EQ(recording.trials[0].name, "runs.csv[step]");
  EXPECT_FALSE(recording.trials[0].held_out);
  EXPECT_EQ(recording.trials[0].measured.times[0], 0.0);
  EXPECT_EQ(recording.trials[1].name, "runs.csv[sine]");
  EXPECT_TRUE(recording.trials[1].held_out);
  EXPECT_EQ(recording.trials[1].measured.samples(2, 0), 5.0);
}

TEST_F(ReadRecording, PutsFitFilesFirst) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,0\n1,2,0\n"));
  source.files[0].held_out = true;
  source.files.push_back({folder_.write("b.csv", "t,q,u\n0,1,0\n1,2,0\n"), false, {}});
  const Recording recording = read_pendulum(source);
  EXPECT_EQ(recording.trials[0].name, "b.csv");
  EXPECT_EQ(recording.trials[1].name, "a.csv");
}

TEST_F(ReadRecording, MasksReadingsAndKeepsCommands) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n10,1,4\n11,2,5\n12,3,6\n"));
  source.mask = {{11.0, 11.5}};
  const Trial trial = read_pendulum(source).trials[0];
  EXPECT_EQ(trial.measured.samples(0, 0), 1.0);
  EXPECT_TRUE(std::isnan(trial.measured.samples(1, 0)));
  EXPECT_EQ(trial.measured.samples(2, 0), 3.0);
  EXPECT_EQ(trial.commands.series.samples(1, 0), 5.0);
}

TEST_F(ReadRecording, MakesATrialOfEachRangeToBeUsed) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,0\n1,2,0\n2,3,0\n3,4,0\n4,5,0\n5,6,0\n"));
  source.use = {{0.0, 1.0}, {3.0, 5.0}};
  const Recording recording = read_pendulum(source);
  ASSERT_EQ(recording.trials.size(), 2u);
  EXPECT_EQ(recording.trials[1].name, "a.csv from 3 s to 5 s");
  EXPECT_EQ(recording.trials[1].measured.times[0], 0.0);
  EXPECT_EQ(recording.trials[1].measured.samples(0, 0), 4.0);
}

TEST_F(ReadRecording, FillsMissingCommandsAsTheHoldSays) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,2\n1,1,\n2,1,nan\n4,1,10\n5,1,\n"));
  const auto commands = [&] {
    const Trial trial = read_pendulum(source).trials[0];
    return std::vector<double>(trial.commands.series.samples.data(), trial.commands.series.samples.data() + 5);
  };
  EXPECT_THAT(commands(), ElementsAre(2.0, 2.0, 2.0, 10.0, 10.0));
  source.hold = Hold::first_order;
  EXPECT_THAT(commands(), ElementsAre(2.0, 4.0, 6.0, 10.0, 10.0));
}

TEST_F(ReadRecording, PutsInitialValuesInCoordinateOrder) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,2\n1,1,2\n"));
  source.initial["elbow"] = {.joint = {InitialKnowledge::given, 0.5, -1.0}};
  const Recording recording =
      read_recording(source, kPendulumChannels, kPendulumActuators, {"joint.shoulder", "joint.elbow"});
  const std::vector<InitialValue>& initial = recording.trials[0].initial;
  ASSERT_EQ(initial.size(), 2u);
  EXPECT_EQ(initial[0].knowledge, InitialKnowledge::from_data);
  EXPECT_EQ(initial[1].knowledge, InitialKnowledge::given);
  EXPECT_EQ(initial[1].position, 0.5);
  source.initial["elbw"] = {};
  EXPECT_THROW(read_pendulum(source), BadInput);
}

KnownStart commanded(double before) { return {.command = before, .states_joint = false}; }

TEST_F(ReadRecording, KeepsWhatWasCommandedBefore) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,2\n1,1,2\n"));
  EXPECT_THAT(read_pendulum(source).trials[0].commands.before, ElementsAre(IsNan())) << "not known";
  source.initial["motor"] = commanded(-0.5);
  const Trial trial = read_pendulum(source).trials[0];
  EXPECT_THAT(trial.commands.before, ElementsAre(-0.5));
  EXPECT_TRUE(trial.initial.empty()) << "of joints nothing is said";
}

TEST_F(ReadRecording, KnowsStartsFileByFile) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,2\n1,1,2\n"));
  source.files.push_back({.path = folder_.write("b.csv", "t,q,u\n0,1,2\n1,1,2\n")});
  source.initial["motor"] = commanded(-0.5);
  source.initial["hinge"] = {.joint = {InitialKnowledge::given, 1.0, 0.0}};
  source.files[1].initial["motor"] = commanded(0.75);
  const std::vector<Trial> trials = read_pendulum(source).trials;
  EXPECT_THAT(trials[0].commands.before, ElementsAre(-0.5));
  EXPECT_THAT(trials[1].commands.before, ElementsAre(0.75));
  EXPECT_EQ(trials[1].initial.front().position, 1.0) << "what a file does not say holds as for all";
  source.files[1].initial["mtor"] = commanded(0.75);
  EXPECT_THAT(complaint_of(source), HasSubstr("has no actuator `mtor` (did you mean \"motor\"?)"));
}

std::string swing_rows(int samples) {
  std::string text = "t,q,u,on\n";
  for (int i = 0; i < samples; ++i)
    text += fmt::format("{},{},{},{}\n", 0.01 * i, 0.3 * std::sin(0.2 * i), 0.1 * std::cos(0.2 * i), i < 5 ? 1 : 0);
  return text;
}

TEST_F(ReadRecording, SplitsTheOnlyRecordingAndSaysSo) {
  RecordingSource source = pendulum_source(folder_.write("run.csv", swing_rows(80)));
  EXPECT_EQ(read_pendulum(source).trials.size(), 1u) << "nothing was left to the program";
  source.may_split = true;
  source.initial["hinge"] = {.joint = {InitialKnowledge::given, 0.0, 0.0}};
  const Recording recording = read_pendulum(source);
  ASSERT_EQ(recording.trials.size(), 2u);
  EXPECT_EQ(recording.trials[0].measured.times.size(), 60);
  EXPECT_FALSE(recording.trials[0].held_out);
  EXPECT_TRUE(recording.trials[1].held_out);
  EXPECT_EQ(recording.trials[0].initial.front().knowledge, InitialKnowledge::given);
  EXPECT_EQ(recording.trials[1].initial.front().knowledge, InitialKnowledge::from_data) << "it starts elsewhere";
  EXPECT_THAT(notes_of(recording),
              HasSubstr("this is the only recording, so its last quarter, from 0.6 s on, is held out"));
}

TEST_F(ReadRecording, SplitsNothingThatIsTooShort) {
  RecordingSource source = pendulum_source(folder_.write("run.csv", swing_rows(39)));
  source.may_split = true;
  EXPECT_EQ(read_pendulum(source).trials.size(), 1u);
}

TEST_F(ReadRecording, ATrialHasItsFilesSetup) {
  RecordingSource source = pendulum_source(folder_.write("heavy.csv", swing_rows(20)));
  source.files.front().setup = {"heavy", {{"body.load.mass", 1.5}}};
  EXPECT_EQ(read_pendulum(source).trials.front().setup, source.files.front().setup);
}

TEST_F(ReadRecording, ACommandIsOffWhileItsColumnSaysSo) {
  RecordingSource source = pendulum_source(folder_.write("run.csv", swing_rows(20)));
  EXPECT_FALSE(read_pendulum(source).trials.front().commands.may_be_off);
  source.commands.front().enabled_by = "on";
  const CommandSeries commands = read_pendulum(source).trials.front().commands;
  EXPECT_TRUE(commands.may_be_off);
  EXPECT_FALSE(std::isnan(commands.series.samples(4, 0)));
  EXPECT_TRUE(commands.series.samples.bottomRows(15).array().isNaN().all());
}

/// Its sums by the trapezium rule lead back to the positions.
TEST_F(ReadRecording, ACommandMayBeTheRateOfAColumn) {
  RecordingSource source = pendulum_source(folder_.write("run.csv", swing_rows(200)));
  source.commands.front() = source.sensors.front();
  source.commands.front().channel = "bench";
  source.commands.front().derivative = true;
  const Trial trial = read_recording(source, kPendulumChannels, {{"bench", "rad/s"}}, {"joint.hinge"}).trials.front();
  double position = trial.measured.samples(0, 0);
  for (Eigen::Index i = 1; i < 200; ++i) {
    const auto rate = trial.commands.series.samples.col(0);
    position += 0.005 * (rate(i - 1) + rate(i));
    EXPECT_NEAR(position, trial.measured.samples(i, 0), 0.004) << i;  // a hundredth of the swing
  }
  source.commands.front().derivative = false;
  EXPECT_THROW(read_recording(source, kPendulumChannels, {{"bench", "rad/s"}}, {"joint.hinge"}), BadInput);
}

TEST_F(ReadRecording, ATrialFromTheMiddleOfAFileKnowsWhatWasCommandedBefore) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,2\n1,1,3\n2,1,4\n3,1,5\n4,1,6\n"));
  source.initial["motor"] = commanded(-0.5);
  source.use = {{0.0, 1.0}, {3.0, 4.0}};
  const std::vector<Trial> trials = read_pendulum(source).trials;
  ASSERT_EQ(trials.size(), 2U);
  EXPECT_THAT(trials[0].commands.before, ElementsAre(-0.5));
  EXPECT_THAT(trials[1].commands.before, ElementsAre(4.0));
}

TEST_F(ReadRecording, SaysWhatACommandAtTheStartIsMissing) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,1,2\n1,1,2\n"));
  source.initial["hinge"] = commanded(0.0);
  source.initial["motr"] = commanded(0.0);
  source.initial["motor"] = {.states_joint = false};
  const std::string complaint = complaint_of(source);
  EXPECT_THAT(complaint, HasSubstr("target.initial.hinge.command: target.commands has no actuator `hinge`"));
  EXPECT_THAT(complaint, HasSubstr("no actuator `motr` (did you mean"));
  EXPECT_THAT(complaint, HasSubstr("target.initial.motor does not give the actuator's state"));
  source.initial = {{"motor", {.joint = {InitialKnowledge::given, 0.0, 0.0}, .command = 0.0}}};
  EXPECT_THAT(complaint_of(source), HasSubstr("target.initial names `motor`")) << "a motor has no position";
}

TEST_F(ReadRecording, NamesEveryProblemOfEveryFileAtOnce) {
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n0,x,2\n1,1,2\n"));
  source.files.push_back({folder_.path() / "none.csv", false, {}});
  source.files.push_back({folder_.write("c.csv", "t,q\n0,1\n"), false, {}});
  const std::string complaint = complaint_of(source);
  EXPECT_THAT(complaint, HasSubstr("a.csv:2: column `q` has `x`"));
  EXPECT_THAT(complaint, HasSubstr("none.csv: there is no such file"));
  EXPECT_THAT(complaint, HasSubstr("c.csv:1: no column `u`"));
}

TEST_F(ReadRecording, ReaderHandsTrialsAndNotesToTargets) {
  RobotSpec robot;
  robot.bodies.resize(1);
  robot.bodies[0].name = "arm";
  robot.joints.resize(1);
  robot.joints[0].name = "hinge";
  robot.joints[0].child = "arm";
  robot.actuators.resize(1);
  robot.actuators[0].name = "motor";
  robot.actuators[0].joint = "hinge";
  robot.sensors.resize(1);
  robot.sensors[0].name = "angle";
  robot.sensors[0].element = "hinge";
  RecordingSource source = pendulum_source(folder_.write("a.csv", "t,q,u\n3,1,2\n4,1,2\n"));
  source.initial["hinge"] = {.joint = {InitialKnowledge::free, 0.1, 0.0}};
  int notes = 0;
  const RecordingReader reader(source, robot, [&](const ReadingNote&) { ++notes; });
  const std::vector<Trial> trials = reader.read();
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_EQ(trials[0].initial[0].position, 0.1);
  EXPECT_GT(notes, 0);
}

}  // namespace
}  // namespace lacuna

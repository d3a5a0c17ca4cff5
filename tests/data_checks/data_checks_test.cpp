#include "data_checks/data_checks.h"

#include "data_checks/command_checks.h"
#include "data_checks/recorded_pendulum.h"

#include <gmock/gmock.h>

#include <numbers>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr double kDegree = 180.0 / std::numbers::pi;

std::vector<DataWarning> doubts_of(const RecordedPendulum& rig) {
  return data_checks({rig.definition, *rig.model, rig.trials, rig.values});
}

std::vector<std::string> faults_of(const RecordedPendulum& rig) { return faults_among(doubts_of(rig)); }

std::vector<std::string> notes_of(const RecordedPendulum& rig) {
  std::vector<std::string> notes;
  for (const DataWarning& doubt : doubts_of(rig))
    if (doubt.severity == Severity::note) notes.push_back(doubt.sentence);
  return notes;
}

/// Moves all commands: a positive time makes the motion seem to come earlier.
void stamp_late(Trial& trial, Eigen::Index samples) {
  TimeSeries::Samples& commands = trial.commands.series.samples;
  const TimeSeries::Samples before = commands;
  for (Eigen::Index i = 0; i < commands.rows(); ++i)
    commands.row(i) = before.row(std::clamp(i - samples, Eigen::Index{0}, commands.rows() - 1));
}

/// What a model may lack is what a diagnosis is for, however large.
TEST(DataDoubts, AreNotRaisedByARigThatLacksAnEffect) {
  const std::vector<PendulumTruth> rigs = {{},
                                           {.inertia = 0.018},
                                           {.damping = 0.1},
                                           {.friction = 0.08},
                                           {.friction = 0.2},
                                           {.friction = 0.3, .disturbance = 0.01},
                                           {.spring = 1.0},
                                           {.cubic = 2.0},
                                           {.delay = 0.04},
                                           {.feedback = 1.0},
                                           {.friction = 0.05, .noise = 5e-3}};
  for (std::size_t i = 0; i < rigs.size(); ++i)
    EXPECT_THAT(faults_of(RecordedPendulum(rigs[i], 10 * i + 1)), IsEmpty()) << "rig " << i;
}

/// A spring that stiffens is another spring elsewhere.
TEST(DataDoubts, AreNotRaisedByTrialsInOtherPlaces) {
  RecordedPendulum rig;
  const PendulumTruth truth{.spring = 0.2, .cubic = 3.0};
  rig.trials = {recorded(
                    truth, "low.csv", [](double t) { return 0.5 * multisine(t); }, 6.0, 1),
                recorded(
                    truth, "high.csv", [](double t) { return 1.2 + 0.7 * multisine(t); }, 6.0, 2),
                recorded(
                    truth, "left.csv", [](double t) { return -0.7 + 0.5 * steps(t); }, 6.0, 3)};
  EXPECT_THAT(faults_of(rig), IsEmpty());
}

/// A clock that gains is an effect, and no shift of time stamps.
TEST(DataDoubts, AreNotRaisedByAClockThatGains) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) trial.commands.series.times *= 1.01;
  EXPECT_THAT(faults_of(rig), IsEmpty());
}

TEST(DataDoubts, NameDegreesReadAsRadians) {
  RecordedPendulum rig;
  for (std::size_t i = 0; i < 3; ++i) rig.angle(i) *= kDegree;
  EXPECT_THAT(faults_of(rig),
              ElementsAre(AllOf(StartsWith("angle"), HasSubstr("degrees were read as radians (57.3)"))));
}

TEST(DataDoubts, NameRadiansReadAsDegrees) {
  RecordedPendulum rig;
  for (std::size_t i = 0; i < 3; ++i) {
    rig.angle(i) /= kDegree;
    rig.trials[i].sensor_noise[0] /= kDegree;
  }
  EXPECT_THAT(faults_of(rig), ElementsAre(HasSubstr("1/57.3")));
}

TEST(DataDoubts, NameACommandInThousandths) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) trial.commands.series.samples *= 1000.0;
  EXPECT_THAT(faults_of(rig),
              ElementsAre(AllOf(HasSubstr("0.00"), HasSubstr("command motor"), HasSubstr("thousandths"))));
}

TEST(DataDoubts, NameACommandOfTheWrongSign) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) trial.commands.series.samples *= -1.0;
  EXPECT_THAT(faults_of(rig), ElementsAre(HasSubstr("against the command motor (-1.0")));
}

TEST(DataDoubts, NameTheFileWithShiftedTimes) {
  for (const std::size_t shifted : {0U, 1U, 2U}) {
    RecordedPendulum rig({.damping = 0.02});
    stamp_late(rig.trials[shifted], -6);
    if (shifted == 0) {
      // A steady sine late is a sine under other damping and stiffness: nothing is said rather than something wrong.
      EXPECT_THAT(faults_of(rig), testing::Each(StartsWith("sine.csv")));
      continue;
    }
    EXPECT_THAT(faults_of(rig), ElementsAre(AllOf(StartsWith(rig.trials[shifted].name), HasSubstr("60 ms later"))));
  }
}

TEST(DataDoubts, NameBothOfTwoFilesThatDisagreeInTime) {
  RecordedPendulum rig;
  rig.trials.erase(rig.trials.begin());
  stamp_late(rig.trials[0], 5);
  EXPECT_THAT(faults_of(rig), ElementsAre(AllOf(HasSubstr("multi.csv and steps.csv"), HasSubstr("50 ms apart"))));
}

TEST(DataDoubts, NameMotionThatComesBeforeItsCommands) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) stamp_late(trial, 5);
  EXPECT_THAT(faults_of(rig), ElementsAre(HasSubstr("50 ms before its commands")));
}

/// As where the model has a drag that grows with the square of the velocity.
TEST(DataDoubts, AreNotRaisedByAnOrderThatTheModelExplainsAsWell) {
  const RecordedPendulum rig;
  const DataCheckTask task{rig.definition, *rig.model, rig.trials, rig.values};
  CommandLags lags{Eigen::VectorXd::LinSpaced(3, -0.05, 0.05), 0.01, {CommandLagProfile{.of_model = 400.0}}};
  CommandLagProfile& profile = lags.profiles.front();
  profile.squares = profile.early = profile.late = Eigen::Vector3d(100.0, 300.0, 300.0);
  EXPECT_THAT(faults_among(command_checks(task, {}, lags)),
              ElementsAre(HasSubstr("50 ms before its commands (3 times less")));
  profile.of_model = 120.0;
  EXPECT_THAT(faults_among(command_checks(task, {}, lags)), IsEmpty());
}

TEST(DataDoubts, NameTheFileOfAnotherRig) {
  RecordedPendulum rig;
  rig.trials[2] = recorded({.inertia = 0.035, .damping = 0.03}, "steps.csv", steps, 6.0, 5);
  EXPECT_THAT(faults_of(rig), ElementsAre(StartsWith("steps.csv contradicts the other files")));
}

TEST(DataDoubts, NameACommandColumnThatIsTheReading) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) trial.commands.series.samples = 0.8 * trial.measured.samples;
  EXPECT_THAT(
      faults_of(rig),
      ElementsAre(AllOf(StartsWith("sine.csv, multi.csv, steps.csv: the command motor equals the sensor readings"),
                        HasSubstr("it is a measurement"))));
}

/// A second sensor of the same angle knows nothing of the first one's noise. A controller would have the other sign.
TEST(DataDoubts, NameACommandColumnThatIsAnotherReadingOfTheSame) {
  RecordedPendulum rig;
  SeededNoise noise(7, 0);
  for (Trial& trial : rig.trials)
    for (Eigen::Index i = 0; i < trial.measured.samples.rows(); ++i)
      trial.commands.series.samples(i, 0) = 0.8 * trial.measured.samples(i, 0) + 1e-3 * noise.normal();
  EXPECT_THAT(faults_of(rig), ElementsAre(HasSubstr("it is a measurement")));
  for (Trial& trial : rig.trials) trial.commands.series.samples *= -1.0;
  EXPECT_THAT(faults_of(rig), testing::Each(Not(HasSubstr("equals the sensor readings of the same moment"))));
}

TEST(DataDoubts, NameACommandColumnThatIsAFilteredSpeed) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) {
    double speed = 0.0;
    for (Eigen::Index i = 0; i < trial.measured.samples.rows(); ++i) {
      const double before = trial.measured.samples(std::max(i - 1, Eigen::Index{0}), 0);
      speed += 0.2 * ((trial.measured.samples(i, 0) - before) / 0.01 - speed);
      trial.commands.series.samples(i, 0) = 0.05 * speed;
    }
  }
  EXPECT_THAT(faults_of(rig), Not(IsEmpty()));
  EXPECT_THAT(faults_of(rig), testing::Each(AllOf(HasSubstr("command"), HasSubstr("measurement"))));
}

TEST(DataDoubts, NoteFeedback) {
  EXPECT_THAT(notes_of(RecordedPendulum({.feedback = 1.0, .noise = 5e-3})),
              testing::Contains(HasSubstr("the command motor is the noise of angle")));
  EXPECT_THAT(notes_of(RecordedPendulum()), testing::Each(Not(HasSubstr("feedback"))));
}

/// Motion that follows a smooth command is seen through little noise, and through more of it than there is motion
/// between neighbouring samples.
TEST(DataDoubts, DoNotTakeMotionThatFollowsACommandForFeedback) {
  const auto lively = [](double t) { return 2.0 * std::sin(2.0 * M_PI * 5.0 * t) + std::sin(2.0 * M_PI * 8.0 * t); };
  for (const double noise : {3e-5, 3e-4, 1e-3, 3e-3, 1e-2}) {
    RecordedPendulum rig;
    for (Trial& trial : rig.trials) trial = recorded({.noise = noise}, trial.name, lively, 6.0, 3);
    EXPECT_THAT(notes_of(rig), testing::Each(Not(HasSubstr("feedback")))) << noise << " rad";
  }
}

TEST(DataDoubts, NameWhatNeverChanges) {
  RecordedPendulum rig;
  rig.angle(1).setConstant(0.1);
  EXPECT_THAT(faults_of(rig),
              ElementsAre(StartsWith("multi.csv: angle stays at 0.100 rad from the first sample to the last")));
  // Less is commanded than where it moved, but not so much less that friction may hold it.
  rig.trials[1].commands.series.samples *= 0.7;
  EXPECT_THAT(faults_of(rig), ElementsAre(StartsWith("multi.csv: angle stays at")));
  // A joint that stands still where nothing is commanded is no fault.
  rig.trials[1].commands.series.samples.setZero();
  EXPECT_THAT(faults_of(rig), IsEmpty());
}

TEST(DataDoubts, NameASaturatedChannel) {
  RecordedPendulum rig;
  rig.angle(1) = rig.angle(1).cwiseMin(0.15);
  EXPECT_THAT(faults_of(rig), testing::Contains(AllOf(StartsWith("multi.csv: angle stays at 0.150 rad"))));
}

/// Where the search has an effect for it, saturation is left to the search.
TEST(DataDoubts, NoteASaturatedChannelWhereSaturationIsTried) {
  RecordedPendulum rig;
  for (std::size_t i = 0; i < 3; ++i) rig.angle(i) = rig.angle(i).cwiseMin(0.15);
  const std::vector<DataWarning> doubts = data_checks({rig.definition, *rig.model, rig.trials, rig.values, true});
  EXPECT_THAT(faults_among(doubts), IsEmpty());
  ASSERT_THAT(doubts, Not(IsEmpty()));
  EXPECT_THAT(doubts.front().sentence, HasSubstr("angle stays at 0.150 rad"));
}

TEST(DataDoubts, NameNoiseLargerThanTheSignal) {
  EXPECT_THAT(faults_of(RecordedPendulum({.noise = 50.0})),
              AllOf(testing::SizeIs(3),
                    testing::Each(AllOf(HasSubstr("the noise of angle from sample to sample is"), HasSubstr("rad")))));
}

/// Little data makes no figure wrong: that is no fault.
TEST(DataDoubts, NameOneShortTrialAsALimit) {
  RecordedPendulum rig;
  rig.trials = {recorded({}, "multi.csv", multisine, 2.0, 1)};
  EXPECT_THAT(faults_of(rig), IsEmpty());
  EXPECT_THAT(limits_among(doubts_of(rig)),
              ElementsAre(AllOf(HasSubstr("have 2 s, 4 segments"), HasSubstr("Record 3.5 s or more"))));
}

/// What is let go and comes to its end in 0.64 s is not recorded longer, but again: six times make 3.84 s.
TEST(DataDoubts, AskForMoreRecordingsOfAMotionThatEndsByItself) {
  RecordedPendulum rig;
  rig.trials = {recorded({}, "fall.csv", [](double) { return 0.0; }, 0.64, 1, {.angle = 1.0})};
  EXPECT_THAT(faults_of(rig), IsEmpty());
  EXPECT_THAT(limits_among(doubts_of(rig)),
              ElementsAre(AllOf(HasSubstr("have 0.64 s, 1 segment of 0.5 s"), HasSubstr("record it 6 times or more"))));
}

TEST(DataDoubts, NoteThatNothingIsHeldOutOrThatThereIsOneFile) {
  RecordedPendulum rig;
  EXPECT_THAT(notes_of(rig), ElementsAre(HasSubstr("no file is held out")));
  rig.trials[1].held_out = true;
  EXPECT_THAT(notes_of(rig), IsEmpty());
  rig.trials[2].held_out = true;
  EXPECT_THAT(notes_of(rig), ElementsAre(HasSubstr("sine.csv is the only fit file")));
}

TEST(DataDoubts, NoteAFileThatIsACopyOfAnother) {
  RecordedPendulum rig;
  Trial copy = rig.trials.front();
  copy.name = "copy.csv";
  rig.trials.push_back(copy);
  rig.trials[1].held_out = true;
  EXPECT_THAT(notes_of(rig), ElementsAre(AllOf(StartsWith("copy.csv holds the same samples as " + rig.trials[0].name),
                                               HasSubstr("count twice"))));
  rig.trials.back().held_out = true;
  EXPECT_THAT(notes_of(rig), ElementsAre(HasSubstr("confirms nothing")));
  rig.trials.back().measured.samples(100, 0) += 1e-9;
  EXPECT_THAT(notes_of(rig), IsEmpty());
}

/// What is held out is not looked at.
TEST(DataDoubts, DoNotLookAtWhatIsHeldOut) {
  RecordedPendulum rig;
  rig.angle(1) *= kDegree;
  rig.trials[1].held_out = true;
  EXPECT_THAT(doubts_of(rig), IsEmpty());
}

}  // namespace
}  // namespace lacuna

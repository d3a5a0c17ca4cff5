#include "data_checks/command_checks.h"
#include "data_checks/recorded_pendulum.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// A slow motion that is read with white noise, and a slow command; `answer`: of the command to the reading before.
RecordedPendulum read_with_noise(double answer, double noise_of_command = 0.0) {
  RecordedPendulum rig;
  rig.trials.resize(1);
  SeededNoise random(3, 0), other(4, 0);
  TimeSeries::Samples &angle = rig.trials[0].measured.samples, &motor = rig.trials[0].commands.series.samples;
  for (Eigen::Index i = 0; i < angle.rows(); ++i) {
    const double time = 0.01 * static_cast<double>(i);
    angle(i, 0) = 0.3 * std::sin(2.0 * time) + 0.01 * random.normal();
    motor(i, 0) =
        std::cos(3.0 * time) + noise_of_command * other.normal() + answer * angle(std::max<Eigen::Index>(i - 1, 0), 0);
  }
  return rig;
}

std::vector<DataWarning> feedback_of(const RecordedPendulum& rig) {
  return feedback_checks({rig.definition, *rig.model, rig.trials, rig.values});
}

/// All of the scatter of the command is the reading's noise.
TEST(FeedbackChecks, NoteACommandThatHoldsTheNoiseOfAReading) {
  const std::vector<DataWarning> doubts = feedback_of(read_with_noise(-1.0));
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].severity, Severity::note);
  EXPECT_THAT(doubts[0].sentence, AllOf(HasSubstr("of the command motor is the noise of angle"),
                                        testing::ContainsRegex("up to (9[5-9]|100) %")));
}

/// Of the command's noise in squares a fifth at most is the reading's, and a half.
TEST(FeedbackChecks, DoNotNoteAShareThatIsSmall) {
  EXPECT_THAT(feedback_of(read_with_noise(-1.0, 0.021)), IsEmpty());
  const std::vector<DataWarning> doubts = feedback_of(read_with_noise(-1.0, 0.01));
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_THAT(doubts[0].sentence, testing::ContainsRegex("up to (4[0-9]|5[0-9]) %"));
}

TEST(FeedbackChecks, DoNotNoteACommandWithItsOwnNoise) {
  EXPECT_THAT(feedback_of(read_with_noise(0.0, 0.01)), IsEmpty());
}

TEST(FeedbackChecks, NameACommandThatIsTheReadingOfTheSameMoment) {
  RecordedPendulum rig = read_with_noise(0.0);
  rig.trials[0].commands.series.samples = 3.0 * rig.trials[0].measured.samples;
  const std::vector<DataWarning> doubts = feedback_of(rig);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].severity, Severity::fault);
  EXPECT_THAT(doubts[0].sentence, HasSubstr("the command motor equals the sensor readings of the same moment"));
}

TEST(FeedbackChecks, DoNotReadWhatIsHeldOut) {
  RecordedPendulum rig = read_with_noise(-1.0);
  rig.trials[0].held_out = true;
  EXPECT_THAT(feedback_of(rig), IsEmpty());
}

}  // namespace
}  // namespace lacuna

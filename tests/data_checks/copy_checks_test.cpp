#include "data_checks/copy_checks.h"

#include "data_checks/recorded_pendulum.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Two files with the same samples.
std::vector<Trial> twice() {
  std::vector<Trial> trials(2, recorded({}, "first.csv", sine, 1.0, 1));
  trials[1].name = "second.csv";
  return trials;
}

TEST(CopyChecks, NoteTheLaterOfTwoFilesWithTheSameSamples) {
  const std::vector<DataWarning> doubts = copy_checks(twice());
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_EQ(doubts[0].severity, Severity::note);
  EXPECT_THAT(doubts[0].sentence, HasSubstr("second.csv holds the same samples as first.csv: data that count twice"));
}

TEST(CopyChecks, SayThatACopyOfAFitFileConfirmsNothing) {
  std::vector<Trial> trials = twice();
  trials[0].held_out = true;
  const std::vector<DataWarning> doubts = copy_checks(trials);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_THAT(doubts[0].sentence, HasSubstr("confirms nothing"));
}

TEST(CopyChecks, KnowTheSameReadingsUnderOtherCommandsAsOtherData) {
  std::vector<Trial> trials = twice();
  trials[1].commands.series.samples(5, 0) += 0.1;
  EXPECT_THAT(copy_checks(trials), IsEmpty());
}

TEST(CopyChecks, CountEveryFurtherCopy) {
  std::vector<Trial> trials = twice();
  trials.push_back(trials[0]);
  trials.back().name = "third.csv";
  EXPECT_EQ(copy_checks(trials).size(), 2U);
}

}  // namespace
}  // namespace lacuna

#include "search/horizon_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;

Ladder ladder_to(double length, bool ended_by_starts) {
  Ladder ladder;
  ladder.ended_by_starts = ended_by_starts;
  ladder.rungs.resize(2);
  ladder.rungs[0].length = length;
  ladder.rungs[0].weight = {1.0};
  ladder.rungs[1].length = 2.0 * length;
  ladder.rungs[1].weight = {0.0};  // judged at the shorter length alone
  return ladder;
}

std::vector<Trial> of_ten_seconds() {
  std::vector<Trial> trials(1);
  trials[0].measured.times = Eigen::VectorXd::LinSpaced(101, 0.0, 10.0);
  return trials;
}

TEST(ReachNote, SaysWhatALadderDoesNotReachAndWhy) {
  EXPECT_THAT(reach_note(ladder_to(1.0, true), of_ten_seconds()), HasSubstr("over 1 s at most, of recordings of 10 s"));
  EXPECT_THAT(reach_note(ladder_to(1.0, true), of_ten_seconds()), HasSubstr("unstable or chaotic"));
  EXPECT_THAT(reach_note(ladder_to(1.0, false), of_ten_seconds()), HasSubstr("more time than they tell"));
}

TEST(ReachNote, SaysNothingWhereATrialIsPredictedForLong) {
  EXPECT_EQ(reach_note(ladder_to(5.0, true), of_ten_seconds()), "");
}

TEST(DoubtAnswer, TakesTheVerdictBackAndSaysWhy) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::effect_found;
  diagnosis.probability = 0.9;
  diagnosis.calibrated = true;
  diagnosis.findings = {"another"};
  diagnosis.next_test = "steps motor 1 N*m";
  doubt_answer({3, 8}, diagnosis);
  EXPECT_EQ(diagnosis.verdict, Verdict::cannot_tell);
  EXPECT_TRUE(std::isnan(diagnosis.probability));
  EXPECT_FALSE(diagnosis.calibrated);
  ASSERT_EQ(diagnosis.findings.size(), 2U);
  EXPECT_THAT(diagnosis.findings.front(), HasSubstr("at 3 of 8 horizons"));
  EXPECT_EQ(diagnosis.next_test, "");
}

}  // namespace
}  // namespace lacuna

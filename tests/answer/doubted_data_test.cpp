#include "answer/doubted_data.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::ElementsAre;

const DataWarning kFault{Severity::fault, "a fault"}, kNote{Severity::note, "a note"};

Diagnosis sure(Verdict verdict) {
  Diagnosis diagnosis;
  diagnosis.verdict = verdict;
  diagnosis.probability = 0.9;
  diagnosis.calibrated = true;
  diagnosis.findings = {"a finding"};
  return diagnosis;
}

TEST(DoubtedData, KeepsAnAnswerAndStatesNoProbability) {
  Diagnosis diagnosis = sure(Verdict::effect_found);
  add_doubts({kFault, kNote}, diagnosis);
  EXPECT_EQ(diagnosis.verdict, Verdict::effect_found);
  EXPECT_TRUE(std::isnan(diagnosis.probability));
  EXPECT_FALSE(diagnosis.calibrated);
  EXPECT_THAT(diagnosis.findings, ElementsAre("a fault", "a finding", "a note"));
}

/// A command of the wrong sign, files of two rigs.
TEST(DoubtedData, LetsNothingBeAnAnswerThatNoModelCanGive) {
  for (const Verdict verdict : {Verdict::effect_found, Verdict::not_in_library, Verdict::nothing_missing}) {
    Diagnosis diagnosis = sure(verdict);
    diagnosis.formulas.resize(1);
    add_doubts({{Severity::fault, "the sign is wrong", true}}, diagnosis);
    EXPECT_EQ(diagnosis.verdict, Verdict::cannot_tell);
    EXPECT_TRUE(diagnosis.formulas.empty());
  }
}

TEST(DoubtedData, DoesNotLetNothingBeMissing) {
  Diagnosis diagnosis = sure(Verdict::nothing_missing);
  add_doubts({kFault}, diagnosis);
  EXPECT_EQ(diagnosis.verdict, Verdict::cannot_tell);
}

TEST(DoubtedData, LeavesAVerdictBesideNotesAsItIs) {
  Diagnosis diagnosis = sure(Verdict::nothing_missing);
  add_doubts({kNote}, diagnosis);
  EXPECT_EQ(diagnosis.verdict, Verdict::nothing_missing);
  EXPECT_DOUBLE_EQ(diagnosis.probability, 0.9);
}

TEST(DoubtedData, SaysFirstThatTheSearchWasStopped) {
  Diagnosis diagnosis = sure(Verdict::effect_found);
  diagnosis.stopped = StoppedSearch{"refits", {}, "go on"};
  add_doubts({kFault, kFault}, diagnosis);
  EXPECT_THAT(diagnosis.findings, ElementsAre("a finding", "a fault", "a fault"));
}

}  // namespace
}  // namespace lacuna

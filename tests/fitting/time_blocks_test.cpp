#include "fitting/shooting/time_blocks.h"

#include "fitting/made_problem.h"

#include <gtest/gtest.h>

namespace lacuna::time_blocks_test {
namespace {

using namespace lacuna::analytic;

double nothing(std::span<const double>, double) { return 0.0; }

/// Ten seconds and five, ten readings a second.
MadeProblem two_trials() {
  return formula_problem(
      nothing, {}, {formula_trial(nothing, {}, 10.0, 10.0, 0.1, 1), formula_trial(nothing, {}, 5.0, 10.0, 0.1, 2)});
}

TEST(TimeBlocks, AreEqualPartsOfEveryTrialNumberedOverAll) {
  const MadeProblem made = two_trials();
  const TimeBlocks blocks(made.problem, 2.5);
  EXPECT_EQ(blocks.count(), 4 + 2);
  EXPECT_EQ(blocks.of(0, 0), 0);
  EXPECT_EQ(blocks.of(0, 24), 0) << "2.4 s";
  EXPECT_EQ(blocks.of(0, 26), 1);
  EXPECT_EQ(blocks.of(0, 100), 3) << "the end belongs to the last";
  EXPECT_EQ(blocks.of(1, 0), 4);
  EXPECT_EQ(blocks.of(1, 50), 5);
}

TEST(TimeBlocks, AreAtLeastOneForEveryTrial) {
  const MadeProblem made = two_trials();
  EXPECT_EQ(TimeBlocks(made.problem, 100.0).count(), 2);
  EXPECT_EQ(TimeBlocks(made.problem, 0.0).count(), 2);
}

/// The priors of an initial state follow the readings of its segment.
TEST(TimeBlocks, HaveAPriorWhereItsStateIs) {
  const MadeProblem made = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  const TimeBlocks blocks(made.problem, 1.0);
  ASSERT_EQ(made.problem.segments().size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(blocks.of(k, made.problem.robust_rows(k) + 1), blocks.of(k, 0)) << k;
}

TEST(ScoredDuration, IsThatOfAllTrials) { EXPECT_DOUBLE_EQ(scored_duration(two_trials().problem), 15.0); }

/// The first 50 ms of the spring determine its start.
TEST(ScoredDuration, BeginsWithTheFirstScoredReading) {
  EXPECT_NEAR(scored_duration(spring_problem({spring_trial(kNoise, 1)}).problem), 5.0 - 0.055, 1e-9);
}

}  // namespace
}  // namespace lacuna::time_blocks_test

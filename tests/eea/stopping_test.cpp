#include "eea/small_run.h"
#include "eea/stopping.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

/// Which trials count, how much of them, and when a run ends.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

TEST(Challenge, ATrialThatIsTooHardIsSetAsideAndComesBack) {
  const auto bench = small_bench({"experiment.passes=6", "estimation.challenge=1e-6"});
  const MemoryJournal journal = run(*bench);
  ASSERT_EQ(journal.passes.size(), 6U);
  EXPECT_THAT(journal.passes[0].set_aside, IsEmpty());
  EXPECT_THAT(journal.passes[1].set_aside, IsEmpty()) << "the first two trials are what everything begins with";
  EXPECT_THAT(journal.passes[2].set_aside, ElementsAre(2));
  EXPECT_THAT(journal.passes[3].set_aside, ElementsAre(2, 3));
  EXPECT_THAT(journal.passes[4].set_aside, ElementsAre(2, 3, 4));
  EXPECT_THAT(journal.passes[5].set_aside, ElementsAre(3, 4, 5)) << "after three passes at the latest it counts";
  for (const ModelRow& model : journal.models)
    if (model.pass == 3 && model.kind == ScoreKind::full) {
      EXPECT_EQ(model.trial_scores.size(), 2U);
    }
}

TEST(Challenge, WithoutItEveryTrialCounts) {
  const MemoryJournal journal = run(*small_bench({"experiment.passes=3"}));
  for (const PassRow& pass : journal.passes) EXPECT_THAT(pass.set_aside, IsEmpty());
  EXPECT_TRUE(std::isnan(journal.trial_rows[0].surprise)) << "nobody predicted it";
  for (std::size_t i = 1; i < journal.trial_rows.size(); ++i) EXPECT_GT(journal.trial_rows[i].surprise, 0.0);
}

TEST(Stopping, WhereNoTestIsWorthEnough) {
  const auto bench = small_bench({"experiment.passes=9", "exploration.stop_below=1000"});
  const MemoryJournal journal = run(*bench);
  ASSERT_EQ(journal.passes.size(), 1U);
  EXPECT_THAT(journal.passes[0].stopped, AllOf(HasSubstr("the best test is worth"), HasSubstr("stop_below")));
  EXPECT_EQ(journal.trial_rows.size(), 1U);
}

TEST(Stopping, WhereModelsNoLongerImprove) {
  EeaState state;
  const auto bench = small_bench({"estimation.patience=2"});
  MemoryJournal journal;
  const EeaRun run = run_of(*bench, journal);
  for (const double surprise : {0.5, 0.2, 0.3, 0.1999}) note_surprise(run, state, surprise);
  EXPECT_EQ(state.passes_without_progress, 2) << "less than a hundredth better is no progress";
  EXPECT_THAT(lost_patience(run, state), HasSubstr("2 passes"));
  note_surprise(run, state, 0.1);
  EXPECT_EQ(lost_patience(run, state), "");
}

TEST(Stopping, LongerHorizonsBeginAnew) {
  const auto bench = small_bench({"estimation.patience=1", "estimation.horizons=[0.1,0.1,0.3]"});
  MemoryJournal journal;
  const EeaRun run = run_of(*bench, journal);
  EeaState state;
  state.pass = 3;  // whose trial the models of the second pass predict, over 0.1 s as those of the first
  state.least_surprise = 0.1;
  note_surprise(run, state, 0.5);
  EXPECT_NE(lost_patience(run, state), "");
  state.pass = 4;
  note_surprise(run, state, 0.5);
  EXPECT_EQ(lost_patience(run, state), "");
}

TEST(Stopping, WithoutPatienceNoOtherTestIsLookedFor) {
  const MemoryJournal journal = run(*small_bench(
      {"experiment.passes=9", "estimation.patience=1", "estimation.parameters={population=2,keep=1,generations=1}"}));
  ASSERT_LT(journal.passes.size(), 9U) << "models of two guesses do not improve in every pass";
  EXPECT_THAT(journal.passes.back().stopped, HasSubstr("predictions of new trials have not improved"));
  EXPECT_EQ(journal.passes.back().test_evaluations, 0U);
  EXPECT_GT(journal.passes.front().test_evaluations, 0U);
}

TEST(Horizons, CutWhatModelsAreHeldAgainst) {
  const auto bench = small_bench({"experiment.passes=3", "estimation.horizons=[0.1,0.2]"});
  const EeaDefinition& definition = bench->definition();
  const MemoryJournal journal = run(*bench);
  const std::vector<double> ends = {0.1, 0.2, 0.2};  // s, by pass
  for (int pass = 1; pass <= 3; ++pass) {
    const ScoredTrial scored = definition.scored({}, journal.trials[0], pass);
    const Eigen::VectorXd& times = scored.trial.measured.times;
    EXPECT_NEAR(times(times.size() - 1) - times(0), ends[static_cast<std::size_t>(pass - 1)], 1e-9);
    EXPECT_EQ(scored.trial.measured.samples.rows(), times.size());
  }
  // 30 steps for the whole of a trial, 10 for what counts in the first pass.
  EXPECT_LE(journal.passes[0].steps, 10U * journal.passes[0].evaluations);
}

TEST(Horizons, GrowAndAreLongerThanAStep) {
  EXPECT_THAT([] { small_bench({"estimation.horizons=[0.2,0.1]"}); },
              ThrowsMessage<BadInput>(HasSubstr("horizons must grow")));
  EXPECT_THAT([] { small_bench({"estimation.horizons=[0.001]"}); },
              ThrowsMessage<BadInput>(HasSubstr("only the initial state would count")));
}

TEST(EeaDefinition, WhatAFitnessRefusesStandsAtItsKeyBesideTheRest) {
  EXPECT_THAT(
      [] {
        small_bench({"exploration.fitness=model_disagreement", "exploration.fitness_parameters={models=2.5}",
                     "exploration.mix=[{fitness='model_disagreement',parameters={models=1.5}}]",
                     "estimation.horizons=[0.2,0.1]"});
      },
      ThrowsMessage<BadInput>(AllOf(HasSubstr("exploration.fitness_parameters"),
                                    HasSubstr("exploration.mix[0].parameters"), HasSubstr("whole number"),
                                    HasSubstr("horizons must grow"))));
}

TEST(Stopping, ARandomTestIsWorthNothing) {
  EXPECT_THAT(
      [] {
        small_bench({"exploration.fitness=random", "exploration.stop_below=1"});
      },
      ThrowsMessage<BadInput>(HasSubstr("exploration.stop_below")));
}

TEST(EeaDefinition, DelaysThatAreProfiledNeedReplayedCommands) {
  EXPECT_THAT([] { small_bench({"estimation.profiled=['sensor.*.delay','body.*.mass','sensor.*.dealy']"}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("replay = true"), HasSubstr("is not a delay of a sensor"),
                                            HasSubstr("sensor.*.dealy"))));
  EXPECT_THAT(
      [] {
        small_bench({"estimation.profiled=['sensor.*.delay']", "estimation.replay=true",
                     "model.free.'sensor.*.delay'=[0.01,0.2]"});
      },
      ThrowsMessage<BadInput>(HasSubstr("begin at 0 s")));
}

}  // namespace
}  // namespace lacuna

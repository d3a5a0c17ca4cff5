#include "eea/ensemble.h"
#include "eea/judges.h"
#include "eea/small_run.h"
#include "eea/stopping.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

/// Several models that differ, and what they are good for.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

/// Models with the same score have the same genome.
KnownModel known(double score, int restart, const std::string& structure) {
  KnownModel model;
  model.genome = {score};
  model.score = score;
  model.restart = restart;
  model.model.structure = structure;
  return model;
}

TEST(Ensemble, TakesTheBestOfEachStructureAndRestartFirst) {
  const std::vector<KnownModel> models = {known(1.0, 0, "a"), known(2.0, 0, "a"), known(3.0, 1, "a"),
                                          known(4.0, 0, "b"), known(5.0, 1, "a")};
  EXPECT_THAT(differing(models, 2), ElementsAre(0, 2));
  EXPECT_THAT(differing(models, 4), ElementsAre(0, 2, 3, 1));
  EXPECT_THAT(differing(models, 9), ElementsAre(0, 2, 3, 1, 4));
  EXPECT_THAT(differing({}, 2), IsEmpty());
  EXPECT_THAT(differing({known(1.0, 0, "a"), known(1.0, 0, "a"), known(2.0, 0, "a")}, 3), ElementsAre(0, 2, 1))
      << "copies last";
}

TEST(SeveralModels, EachRestartSearchesAnewAndHandsItsBestOn) {
  const auto once = small_bench();
  const auto twice = small_bench({"estimation.restarts=2", "estimation.ensemble=4"});
  const MemoryJournal one = run(*once), two = run(*twice);
  const std::size_t in_one_search = one.passes[0].evaluations;
  EXPECT_EQ(two.passes[0].evaluations, 2 * in_one_search);
  // The first restart is the search without restarts; the second begins elsewhere.
  for (std::size_t i = 0; i < in_one_search; ++i) EXPECT_EQ(two.models[i].genome, one.models[i].genome);
  EXPECT_NE(two.models[in_one_search].genome, one.models[0].genome);
  EXPECT_LE(two.passes[0].best_score, one.passes[0].best_score);
  // The ensemble has the best of both.
  ASSERT_EQ(two.passes[0].ensemble.size(), 4U);
  std::set<bool> of_second;
  for (std::size_t rank = 0; rank < 2; ++rank) of_second.insert(two.passes[0].ensemble[rank].model >= in_one_search);
  EXPECT_EQ(of_second.size(), 2U);
  EXPECT_EQ(two.passes[0].ensemble[0].model, *two.passes[0].best_model);
  EXPECT_EQ(two.passes[0].ensemble[0].values, two.passes[0].best_values);
}

TEST(SeveralModels, SeedsStartTheFirstRestartAlone) {
  const auto bench = small_bench({"estimation.restarts=2", "estimation.seeds=1"});
  const MemoryJournal journal = run(*bench);
  const std::size_t first_of_pass_2 = journal.passes[0].evaluations;
  const Genome& best = journal.models[*journal.passes[0].best_model].genome;
  EXPECT_EQ(journal.models[first_of_pass_2].genome, best);
  EXPECT_NE(journal.models[first_of_pass_2 + journal.passes[1].evaluations / 2].genome, best);
}

TEST(SeveralModels, ATestIsJudgedByThoseThatDiffer) {
  const auto bench = small_bench(
      {"estimation.restarts=3", "exploration.fitness=model_disagreement", "exploration.fitness_parameters={models=3}"});
  EXPECT_EQ(bench->definition().value.models(), 3U);
  const MemoryJournal journal = run(*bench);
  EXPECT_GT(journal.passes[0].best_fitness, 0.0);
  EXPECT_GT(journal.passes[0].test_steps, 0U);
}

/// A state with one trial and the best models of the first pass.
EeaState after_first_pass(const EeaBench& bench) {
  MemoryJournal journal;
  EeaState state = beginning(bench);
  run(bench, journal, state);
  for (const std::vector<double>& checkpoint : journal.checkpoints) {
    EeaState then = state_at(bench, journal, checkpoint);
    if (then.phase == Phase::exploration) return then;
  }
  throw Error("the run never explored");
}

EeaRun run_of(const EeaBench& bench, EeaJournal& journal) {
  return {.definition = bench.definition(),
          .journal = journal,
          .seed = 1,
          .replicate = 1,
          .threads = 1,
          .truth = {},
          .target = nullptr,
          .progress = {}};
}

TEST(Judges, KnowTheNoiseOfEachChannel) {
  const auto bench = small_bench({"exploration.fitness=model_disagreement", "estimation.sensors=['sensor.angle*']",
                                  "target.noise.'sensor.angle_front_left'=0.02"});
  MemoryJournal journal;
  const EeaState state = after_first_pass(*bench);
  const Judges judges(run_of(*bench, journal), state);
  std::vector<TestPrediction> predictions(judges.size());
  std::uint64_t steps = 0;
  std::string reason;
  ASSERT_TRUE(judges.predict(state.trials[0].drive, 0, predictions, steps, reason)) << reason;
  ASSERT_EQ(predictions.size(), 2U);
  const std::vector<Channel>& channels = bench->definition().compiled->channels();
  ASSERT_EQ(predictions[0].noise.size(), channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const bool is_scored = channels[c].name.starts_with("angle");
    EXPECT_EQ(std::isfinite(predictions[0].noise[c]), is_scored) << channels[c].name;
    if (is_scored) {
      EXPECT_GT(predictions[0].noise[c], 0.0);
    }
  }
  const auto declared = std::find_if(channels.begin(), channels.end(),
                                     [](const Channel& channel) { return channel.name == "angle_front_left"; });
  EXPECT_EQ(predictions[0].noise[static_cast<std::size_t>(declared - channels.begin())], 0.02);
  EXPECT_TRUE(predictions[0].slopes.empty()) << "nobody asked for them";
}

TEST(Judges, SlopesAreWhatAValueOfItsWholeRangeWouldChange) {
  const auto bench = small_bench({"exploration.fitness=model_disagreement",
                                  "exploration.fitness_parameters={refit=1,noise=0.1}", "test.duration=0.1"});
  MemoryJournal journal;
  const EeaState state = after_first_pass(*bench);
  const Judges judges(run_of(*bench, journal), state);
  std::vector<TestPrediction> predictions(judges.size());
  std::uint64_t steps = 0;
  std::string reason;
  ASSERT_TRUE(judges.predict(state.trials[0].drive, 0, predictions, steps, reason)) << reason;
  const std::size_t free = bench->definition().model.free.size();
  ASSERT_EQ(predictions[0].slopes.size(), free);
  EXPECT_EQ(predictions[0].information.rows(), static_cast<Eigen::Index>(free));
  // At least what the range says, more where a trial told something.
  double told = 0.0;
  for (Eigen::Index k = 0; k < predictions[0].information.rows(); ++k) {
    EXPECT_GE(predictions[0].information(k, k), 12.0);
    told += predictions[0].information(k, k) - 12.0;
  }
  EXPECT_GT(told, 0.0);
  double largest = 0.0;
  for (const TimeSeries::Samples& slope : predictions[0].slopes)
    largest = std::max(largest, slope.cwiseAbs().maxCoeff());
  EXPECT_GT(largest, 0.0);
}

TEST(TestValue, AddsWeightedFitnesses) {
  const auto bench = small_bench({"exploration.fitness=model_disagreement", "exploration.fitness_parameters={noise=1}",
                                  "exploration.mix=[{fitness='forward_distance',weight=-2.0}]"});
  const TestValue& value = bench->definition().value;
  EXPECT_EQ(value.name(), "model_disagreement + -2 forward_distance");
  EXPECT_EQ(value.models(), 2U);
  std::vector<TestPrediction> predictions(2);
  for (TestPrediction& prediction : predictions) {
    prediction.sensors.samples = TimeSeries::Samples::Zero(1, 1);
    prediction.centre_of_mass.samples = TimeSeries::Samples::Zero(2, 3);
  }
  predictions[1].sensors.samples(0, 0) = 4.0;         // half of 16 nats
  predictions[0].centre_of_mass.samples(1, 0) = 1.5;  // m
  EXPECT_DOUBLE_EQ(value.score({}, predictions), 8.0 - 2.0 * 1.5);
}

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
    if (model.pass == 3 && model.kind == EvaluationKind::full) {
      EXPECT_EQ(model.trial_scores.size(), 2U);
    }
}

TEST(Challenge, WithoutItEveryTrialCounts) {
  const MemoryJournal journal = run(*small_bench({"experiment.passes=3"}));
  for (const PassRow& pass : journal.passes) EXPECT_THAT(pass.set_aside, IsEmpty());
  EXPECT_TRUE(std::isnan(journal.trial_rows[0].surprise)) << "nobody foretold it";
  for (std::size_t i = 1; i < journal.trial_rows.size(); ++i) EXPECT_GT(journal.trial_rows[i].surprise, 0.0);
}

TEST(Stopping, WhereNoTestIsWorthEnough) {
  const auto bench = small_bench({"experiment.passes=9", "exploration.stop_below=1000"});
  const MemoryJournal journal = run(*bench);
  ASSERT_EQ(journal.passes.size(), 1U);
  EXPECT_THAT(journal.passes[0].stopped, AllOf(HasSubstr("no test is worth more than"), HasSubstr("stop_below")));
  EXPECT_EQ(journal.trial_rows.size(), 1U);
}

TEST(Stopping, WhereModelsNoLongerImprove) {
  EeaState state;
  const auto bench = small_bench({"estimation.patience=2"});
  MemoryJournal journal;
  const EeaRun run = run_of(*bench, journal);
  for (const double surprise : {0.5, 0.2, 0.3, 0.1999}) note_surprise(state, surprise);
  EXPECT_EQ(state.passes_without_progress, 2) << "less than a hundredth better is no progress";
  EXPECT_THAT(reason_to_stop(run, state), HasSubstr("2 passes"));
  note_surprise(state, 0.1);
  EXPECT_EQ(reason_to_stop(run, state), "");
}

TEST(EeaDefinition, DelaysThatAreProfiledNeedReplayedCommands) {
  EXPECT_THAT([] { small_bench({"estimation.profiled=['sensor.*.delay','body.*.mass','sensor.*.dealy']"}); },
              ThrowsMessage<BadInput>(
                  AllOf(HasSubstr("replay = true"), HasSubstr("no delay of a sensor"), HasSubstr("sensor.*.dealy"))));
  EXPECT_THAT(
      [] {
        small_bench({"estimation.profiled=['sensor.*.delay']", "estimation.replay=true",
                     "model.free.'sensor.*.delay'=[0.01,0.2]"});
      },
      ThrowsMessage<BadInput>(HasSubstr("begin at 0 s")));
}

TEST(SeveralModels, ProfiledDelaysAreNoGenesAndAreFound) {
  const auto bench = small_bench({"estimation.replay=true", "estimation.profiled=['sensor.*.delay']"});
  EXPECT_EQ(bench->definition().estimation.layout().size(), 9U);
  const EeaDefinition& definition = bench->definition();
  const MemoryJournal journal = run(*bench);
  const std::vector<double>& found = journal.passes.back().best_values;
  ASSERT_EQ(found.size(), 17U);
  for (std::size_t v : definition.profiled) {
    EXPECT_GE(found[v], 0.0);
    EXPECT_LE(found[v], 0.2);
    EXPECT_NEAR(found[v] / 0.01, std::round(found[v] / 0.01), 1e-9) << "whole steps";
  }
}

/// A pendulum with dry friction, whose model has two optional effects.
const std::string kRivals = R"([experiment]
name = "rivals"
passes = 2
[target]
kind = "simulated"
file = "robots/servo-pendulum.toml"
set = { "actuator.motor.force_limit" = 0.6 }
effects = [ { id = "stick", effect = "coulomb_friction", where = "joint.hinge", start = { torque = 0.02 } } ]
[model]
file = "robots/servo-pendulum.toml"
set = { "actuator.motor.force_limit" = 0.6 }
encoding = "parameters_and_effects"
encoding_parameters = { at_most = 1 }
effects = [
  { id = "stick", effect = "coulomb_friction", where = "joint.hinge", range = { torque = [0.0, 0.1] }, optional = true },
  { id = "grease", effect = "viscous_friction", where = "joint.hinge", range = { damping = [0.0, 0.2] }, optional = true },
]
[model.free]
"body.arm.mass" = [0.3, 0.7]
[engine]
step = "10 ms"
[test]
encoding = "command_series"
duration = "1 s"
[estimation]
parameters = { population = 12, keep = 6, generations = 5 }
seeds = 2
restarts = 3
rivals = true
[exploration]
fitness = "model_disagreement"
fitness_parameters = { models = 3, refit = 1 }
parameters = { population = 4, keep = 2, generations = 2 }
)";

TEST(Rivals, EachRestartLooksForAnotherStructure) {
  const auto bench = small_bench({}, kRivals);
  const MemoryJournal journal = run(*bench);
  for (const PassRow& pass : journal.passes) {
    std::set<std::string> structures;
    for (std::size_t rank = 0; rank < 3; ++rank) structures.insert(pass.ensemble.at(rank).structure);
    EXPECT_THAT(structures, ElementsAre("grease", "no optional effect", "stick"));
    const std::size_t in_one_search = pass.evaluations / 3;
    EXPECT_EQ(pass.invalid, 0U) << "children of structures that are taken are made again";
    EXPECT_EQ(in_one_search, 12U + 4U * 6U);
  }
}

TEST(Rivals, GoOnFromEveryCheckpointWithTheSameRows) {
  const auto bench = small_bench({}, kRivals);
  const MemoryJournal whole = run(*bench);
  for (const std::vector<double>& checkpoint : whole.checkpoints) {
    EeaState state = state_at(*bench, whole, checkpoint);
    const std::size_t before = state.models;
    MemoryJournal rest;
    run(*bench, rest, state);
    ASSERT_EQ(rest.models.size(), whole.models.size() - before);
    for (std::size_t i = 0; i < rest.models.size(); ++i)
      EXPECT_EQ(rest.models[i].genome, whole.models[before + i].genome) << before + i;
    if (!rest.passes.empty()) {
      EXPECT_EQ(rest.passes.back().best_fitness, whole.passes.back().best_fitness);
    }
  }
}

TEST(Rivals, WithoutAnotherStructureASearchFindsNothingAndTheRunGoesOn) {
  const auto bench = small_bench({"estimation.restarts=2", "estimation.rivals=true"});
  const MemoryJournal journal = run(*bench);
  ASSERT_EQ(journal.passes.size(), 2U);
  EXPECT_EQ(journal.passes[0].invalid, journal.passes[0].evaluations / 2);
  EXPECT_THAT(journal.models[journal.passes[0].evaluations - 1].reason, HasSubstr("earlier restart"));
}

}  // namespace
}  // namespace lacuna

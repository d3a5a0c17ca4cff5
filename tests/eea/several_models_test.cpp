#include "eea/delays.h"
#include "eea/ensemble.h"
#include "eea/ensemble_prediction.h"
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

/// Models with the same score have the same mass.
KnownModel known(double score, int restart, const std::string& structure) {
  KnownModel model;
  model.genome = {score};
  model.score = score;
  model.restart = restart;
  model.model = {{score}, {}, {}, structure};
  return model;
}

/// A model with a free mass and an optional effect that has a free value.
ModelDefinition with_effect() {
  ModelDefinition definition;
  definition.free = {{"body.arm.mass", "kg", 0.0, 1.0}, {"effect.grease.damping", "N*m*s/rad", 0.0, 1.0}};
  EffectEntry grease;
  grease.id = "grease";
  grease.optional = true;
  definition.effects = {grease};
  return definition;
}

TEST(Ensemble, TakesTheBestOfEachStructureAndRestartFirst) {
  const std::vector<KnownModel> models = {known(1.0, 0, "a"), known(2.0, 0, "a"), known(3.0, 1, "a"),
                                          known(4.0, 0, "b"), known(5.0, 1, "a")};
  ModelDefinition definition;
  definition.free = {{"body.arm.mass", "kg", 0.0, 9.0}};
  const Phenotypes phenotypes(definition);
  EXPECT_THAT(differing(models, 2, phenotypes), ElementsAre(0, 2));
  EXPECT_THAT(differing(models, 4, phenotypes), ElementsAre(0, 2, 3, 1));
  EXPECT_THAT(differing(models, 9, phenotypes), ElementsAre(0, 2, 3, 1, 4));
  EXPECT_THAT(differing({}, 2, phenotypes), IsEmpty());
  EXPECT_THAT(differing({known(1.0, 0, "a"), known(1.0, 0, "a"), known(2.0, 0, "a")}, 3, phenotypes),
              ElementsAre(0, 2, 1))
      << "copies last";
}

TEST(Ensemble, ModelsWithoutAnEffectAreCopiesWhateverItsGenesAre) {
  KnownModel a = known(1.0, 0, "none"), b = known(1.0, 0, "none"), other = known(2.0, 0, "none");
  for (KnownModel* model : {&a, &b, &other}) {
    model->model.values.push_back(kNotKnown);
    model->model.without = {0};
  }
  b.genome = {1.0, 0.3};
  EXPECT_THAT(differing({a, b, other}, 3, Phenotypes(with_effect())), ElementsAre(0, 2, 1));
  PassEnsemble ensemble;
  for (const KnownModel& model : {a, b, other}) add_unless_copy(ensemble, 0, model.model, Phenotypes(with_effect()));
  ModelProposal greased = a.model;
  greased.values[1] = 0.5;
  greased.without.clear();
  add_unless_copy(ensemble, 7, greased, Phenotypes(with_effect()));
  EXPECT_THAT(ensemble.numbers, ElementsAre(0, 0, 7));
  EXPECT_EQ(ensemble.copies, 1U);
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
  // Each test is simulated on three models, 30 steps each; the noise takes one simulation more a trial.
  EXPECT_GE(journal.passes[0].test_steps, 3U * 30U * journal.passes[0].test_evaluations);
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
  // Against two simulations of another width: of a mass, and of a lag, of which only whole steps count.
  const ModelProposal& judge = state.best.front().model;
  const std::vector<FreeValue>& values = bench->definition().model.free;
  const TestPredictor predictor(*bench->definition().compiled, bench->definition().sample_times, 1);
  int lags = 0;
  for (std::size_t k = 0; k < free; ++k) {
    const bool is_lag = values[k].address.ends_with("delay");
    const double range = values[k].upper - values[k].lower;
    const double side = judge.values[k] < values[k].lower + 0.5 * range ? 1.0 : -1.0;
    const double move = side * (is_lag ? 0.01 / range : 1e-3);  // the engine's step is 10 ms
    ModelProposal moved = judge;
    moved.values[k] += move * range;
    TestPrediction there;
    ASSERT_TRUE(predictor.predict(moved, state.trials[0].drive, 0, there, steps, reason)) << reason;
    const TimeSeries::Samples expected = (there.sensors.samples - predictions[0].sensors.samples) / move;
    EXPECT_LT((predictions[0].slopes[k] - expected).cwiseAbs().maxCoeff(),
              1e-9 * (1.0 + expected.cwiseAbs().maxCoeff()))
        << values[k].address;
    if (is_lag && expected.cwiseAbs().maxCoeff() > 0.0) ++lags;
  }
  EXPECT_GT(lags, 0) << "a lag tells something";
}

TEST(Judges, OfTestsThatNeedSlopesNothingIsKnownOnTheTarget) {
  const auto bench = small_bench({"exploration.fitness=information_gain"});
  EXPECT_EQ(bench->definition().value.models(), 1U);
  const MemoryJournal journal = run(*bench);
  for (const TargetTrialRow& row : journal.trial_rows) EXPECT_TRUE(std::isnan(row.measured_fitness));
}

TEST(Judges, BeforeTheFirstTrialAnApproximateModelHasNothingToBeComparedWith) {
  const auto bench =
      small_bench({"model.approximate=true", "exploration.fitness=model_disagreement", "exploration.stop_below=1e9"});
  const MemoryJournal journal = run(*bench);
  EXPECT_EQ(journal.passes[0].number, 0);
  EXPECT_EQ(journal.passes[0].test_evaluations, 0U) << "a random test";
  EXPECT_EQ(journal.passes[0].stopped, "");
  EXPECT_GT(journal.passes[1].test_evaluations, 0U);
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
  state.pass = 3;  // whose trial the models of the second pass foretell, over 0.1 s as those of the first
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
  EXPECT_THAT(journal.passes.back().stopped, HasSubstr("foretold"));
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
              ThrowsMessage<BadInput>(HasSubstr("horizons grow")));
  EXPECT_THAT([] { small_bench({"estimation.horizons=[0.001]"}); },
              ThrowsMessage<BadInput>(HasSubstr("only the start would count")));
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
                                    HasSubstr("horizons grow"))));
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

TEST(SeveralModels, TheDelaysOfTheRightMassesAreTheTargets) {
  const auto bench =
      small_bench({"estimation.replay=true", "estimation.profiled=['sensor.*.delay']", "test.duration=1"});
  const EeaDefinition& definition = bench->definition();
  const MemoryJournal journal = run(*bench);
  const std::vector<double> truth = bench->truth(1);
  ModelProposal model{truth};
  for (const std::size_t v : definition.profiled) model.values[v] = 0.0;
  std::vector<ScoredTrial> trials;
  for (std::size_t t = 0; t < journal.trials.size(); ++t)
    trials.push_back(definition.observed(definition.decode_test(journal.tests[*journal.trial_rows[t].test].genome),
                                         journal.trials[t]));
  EXPECT_GT(Delays(definition, std::move(trials)).find(model), 0U);
  int angles = 0;
  for (const std::size_t v : definition.profiled) {
    const std::string& address = definition.model.free[v].address;
    if (!address.starts_with("sensor.angle")) continue;  // feet may stand on the ground throughout
    EXPECT_EQ(std::round(model.values[v] / 0.01), std::round(truth[v] / 0.01)) << address;
    angles += truth[v] > 0.005 ? 1 : 0;
  }
  EXPECT_GE(angles, 3) << "with a lag";
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

TEST(Rivals, MoreRestartsThanStructuresEndThePhase) {
  const MemoryJournal journal = run(*small_bench({"estimation.restarts=7"}, kRivals));
  for (const PassRow& pass : journal.passes) {
    EXPECT_EQ(pass.evaluations, 3U * (12U + 4U * 6U)) << "neither effect, one or the other";
    EXPECT_EQ(pass.invalid, 0U);
  }
}

TEST(Rivals, NeedSeveralStructuresAndRestarts) {
  EXPECT_THAT([] { small_bench({"estimation.rivals=true"}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("restarts = 2"), HasSubstr("have one structure"))));
}

}  // namespace
}  // namespace lacuna

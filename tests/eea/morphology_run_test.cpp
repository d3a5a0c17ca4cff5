#include "eea/same_rows.h"
#include "eea/small_run.h"
#include "support/small_shape.h"
#include "support/target_genome.h"

#include <gmock/gmock.h>

/// The algorithm with models that bring a robot of their own.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kRoundedAway = 1e-9;  // of ranges after 20 steps, where two robots differ by rounding

ScoredTrial trial_of(const OpenEeaRun& opened, const MemoryJournal& journal, std::size_t number) {
  const EeaDefinition& definition = opened.definition();
  const Genome& test = journal.tests[*journal.trial_rows[number].test].genome;
  return definition.scored(definition.decode_test(test), journal.trials[number], 1);
}

/// A little in the ground: of parts that just touch it, rounding decides which of them hold.
TEST(MorphologyRun, AGenomeOfTheTargetExplainsItsTrials) {
  const auto opened = small_bench({}, kSmallShape);
  const EeaDefinition& definition = opened->definition();
  EXPECT_EQ(definition.exploration.layout().size(), 46U) << "6 sensors, 3 hidden neurons, 4 motors";
  const MemoryJournal journal = run(*opened);
  const ScoredTrial trial = trial_of(*opened, journal, 0);
  EXPECT_EQ(trial.trial.measured.channels.size(), 20U) << "the ranges alone";
  EXPECT_EQ(trial.trial.measured.times.size(), 21);
  const ModelScorer scorer(*definition.compiled, {trial}, definition.metric, {1}, &definition.model);
  ModelScore exact, random;
  scorer.score(definition.decode_model(five_cylinders_genome()), std::nullopt, 0, exact);
  EXPECT_EQ(exact.kind, ScoreKind::full) << exact.reason;
  EXPECT_LT(exact.total, kRoundedAway);
  EXPECT_EQ(exact.steps, 20U);
  scorer.score(definition.decode_model(journal.models.front().genome), std::nullopt, 0, random);
  EXPECT_GT(random.total, 0.01);
}

TEST(MorphologyRun, PassesSayHowFarTheShapeIsFromTheTargets) {
  const auto opened = small_bench({}, kSmallShape);
  const MemoryJournal journal = run(*opened);
  ASSERT_EQ(journal.passes.size(), 2U);
  for (const PassRow& pass : journal.passes) {
    EXPECT_EQ(pass.evaluations, 12U + 3U * 9U);
    EXPECT_TRUE(pass.best_values.empty());
    ASSERT_EQ(pass.objective.size(), 7U);
    EXPECT_EQ(pass.objective[5].name, "body.*.position");
    EXPECT_GT(pass.objective[5].value, 0.0);
  }
  EXPECT_EQ(journal.models[39].genome, journal.models[*journal.passes[0].best_model].genome) << "the seed";
}

TEST(MorphologyRun, AnyNumberOfThreadsGivesTheSameRows) {
  const auto opened = small_bench({}, kSmallShape);
  const MemoryJournal one = run(*opened, 1), three = run(*opened, 3);
  expect_same_models(one.models, three.models);
}

TEST(MorphologyRun, GoesOnFromEveryCheckpointWithTheSameRows) {
  const auto opened = small_bench({}, kSmallShape);
  const MemoryJournal whole = run(*opened);
  for (const std::vector<double>& checkpoint : whole.checkpoints) {
    EeaState state = state_at(*opened, whole, checkpoint);
    const std::uint64_t before = state.models;
    MemoryJournal rest;
    run(*opened, rest, state);
    expect_same_models(rest.models, {whole.models.begin() + static_cast<std::ptrdiff_t>(before), whole.models.end()});
    if (rest.passes.empty()) continue;
    ASSERT_EQ(rest.passes.back().objective.size(), 7U);
    EXPECT_EQ(rest.passes.back().objective[5].value, whole.passes.back().objective[5].value);
  }
}

TEST(MorphologyRun, ModelsThatCannotDifferAreSimulatedOnce) {
  const auto opened = small_bench({"estimation.parameters.generations=30"}, kSmallShape);
  const auto naive = small_bench({"estimation.parameters.generations=30", "estimation.reuse=false"}, kSmallShape);
  const MemoryJournal a = run(*opened), b = run(*naive);
  ASSERT_EQ(a.models.size(), b.models.size());
  for (std::size_t i = 0; i < a.models.size(); ++i) EXPECT_TRUE(same(a.models[i].score, b.models[i].score)) << i;
  EXPECT_GT(a.passes[0].reused, 10U) << "a mutation often leaves the robot what it was";
}

/// What a bench says of an experiment that cannot be run.
std::string complaint_about(const std::vector<std::string>& overrides, const std::string& text = kSmallShape) {
  try {
    small_bench(overrides, text);
  } catch (const BadInput& problem) {
    return problem.what();
  }
  return "none";
}

/// Before anything is simulated.
TEST(MorphologyRun, OperatorsThatCannotVaryAreAMistakeOfTheFile) {
  const std::string key = "estimation.mutation=[{operator='reset_or_nudge'},{operator='reshape',parameters=";
  EXPECT_EQ(complaint_about({key + "{coarsest=1,finest=3}}]"}), "none");
  EXPECT_THAT(complaint_about({key + "{coarsest=3,finest=1}}]"}),
              AllOf(HasSubstr("estimation.mutation[1]"), HasSubstr("coarsest")));
  EXPECT_THAT(complaint_about({key + "{}}]", "model.free={'body.torso.mass'=[0.5,2]}"}),
              AllOf(HasSubstr("estimation.mutation[1]"), HasSubstr("six genes")));
}

TEST(MorphologyRun, WhatTheEncodingRefusesStandsAtItsName) {
  EXPECT_THAT(complaint_about({"model.encoding_parameters={l_min=3}"}),
              AllOf(HasSubstr("model.encoding:"), HasSubstr("l_min")));
  EXPECT_THAT(complaint_about({"model.encoding='parameters'"}), HasSubstr("model.free:"));
}

/// Otherwise a controller would read past the target's readings.
TEST(MorphologyRun, AControllerSeesWhatTheTargetHas) {
  EXPECT_EQ(complaint_about({"target.parameters.beacons=1", "estimation.sensors=['sensor.angle*']"}), "none")
      << "angles and touch are where they are";
  EXPECT_THAT(complaint_about({"target.parameters.beacons=1"}),
              AllOf(HasSubstr("estimation.sensors:"), HasSubstr("\"range_torso_2\"")));
  EXPECT_THAT(complaint_about({"target.parameters.beacons=1", "test.sensors=['sensor.range*']"}),
              AllOf(HasSubstr("test.sensors:"), HasSubstr("\"range_torso_2\""), HasSubstr("11 readings")));
  EXPECT_THAT(complaint_about({"target.parameters.beacons=1", "test.sensors=[]"}),
              AllOf(HasSubstr("target.robot:"), HasSubstr("\"range_torso_2\"")));
  EXPECT_EQ(complaint_about({"target.parameters.beacons=4", "test.sensors=[]"}), "none");
  EXPECT_THAT(complaint_about({"target.robot='quadruped'", "target.parameters={}"}),
              AllOf(HasSubstr("test.sensors:"), HasSubstr("target.robot: its actuators")));
}

TEST(MorphologyRun, SensorsThatNobodyHasAreAMistakeOfTheFile) {
  for (const char* key : {"estimation.sensors=['sensor.rnage*']", "test.sensors=['joint.front']"})
    EXPECT_THROW(small_bench({key}, kSmallShape), BadInput) << key;
}

}  // namespace
}  // namespace lacuna

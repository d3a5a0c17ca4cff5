#include "eea/same_rows.h"
#include "eea/small_run.h"
#include "evaluation/scoring/model_scorer.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(EeaLoop, GivesTheSameRowsWithAnyNumberOfThreads) {
  const auto opened = small_bench();
  const MemoryJournal one = run(*opened, 1), three = run(*opened, 3);
  expect_same_models(one.models, three.models);
  expect_same_tests(one.tests, three.tests);
}

TEST(EeaLoop, DependsOnItsSeed) {
  const auto opened = small_bench();
  const MemoryJournal first = run(*opened, 1, 1), other = run(*opened, 1, 2);
  EXPECT_FALSE(same(first.models.front().genome, other.models.front().genome));
  EXPECT_FALSE(same(first.tests.front().genome, other.tests.front().genome));
}

TEST(EeaLoop, DoesWhatTheSeedSays) {
  const auto opened = small_bench();
  const MemoryJournal journal = run(*opened);
  // Two passes: a trial each, and one more that shows how the last test transfers.
  ASSERT_EQ(journal.trial_rows.size(), 3U);
  EXPECT_FALSE(journal.trial_rows[1].for_transfer);
  EXPECT_TRUE(journal.trial_rows[2].for_transfer);
  // Random models at each pass, then half of the population anew in each generation.
  ASSERT_EQ(journal.models.size(), 2U * (12U + 4U * 6U));
  EXPECT_EQ(journal.models.front().parents[0], std::nullopt);
  EXPECT_EQ(journal.models[36].parents[0], std::nullopt);
  EXPECT_TRUE(journal.models[12].parents[0].has_value());
  // A random test, then those of two exploration phases.
  ASSERT_EQ(journal.tests.size(), 1U + 2U * (6U + 2U * 3U));
  ASSERT_EQ(journal.passes.size(), 2U);
  for (const PassRow& pass : journal.passes) {
    EXPECT_EQ(pass.evaluations, 36U);
    EXPECT_EQ(pass.test_evaluations, 12U);
  }
  // Models of pass 2 are scored on both trials.
  EXPECT_EQ(journal.models.front().trial_scores.size(), 1U);
  EXPECT_EQ(journal.models[36].trial_scores.size(), 2U);
  EXPECT_EQ(journal.predictions, 2 + 2);
}

TEST(EeaLoop, TheBestModelIsTheBestOfItsPassAndItsTestTheBestTest) {
  const auto opened = small_bench();
  const MemoryJournal journal = run(*opened);
  for (const PassRow& pass : journal.passes) {
    double best = kInfinity, fittest = -kInfinity;
    for (const ModelRow& model : journal.models)
      if (model.pass == pass.number && model.kind == ScoreKind::full) best = std::min(best, model.score);
    for (const TestRow& test : journal.tests)
      if (test.pass == pass.number && test.valid && std::isfinite(test.fitness))
        fittest = std::max(fittest, test.fitness);
    EXPECT_EQ(pass.best_score, best);
    EXPECT_EQ(pass.best_fitness, fittest);
  }
}

TEST(EeaLoop, AModelWithTheTruthExplainsEveryTrial) {
  const auto opened = small_bench();
  const MemoryJournal journal = run(*opened);
  std::vector<ScoredTrial> scored;
  for (std::size_t i = 0; i < journal.trials.size(); ++i) {
    const Genome& genome = journal.tests[*journal.trial_rows[i].test].genome;
    scored.push_back({opened->definition().decode_test(genome), journal.trials[i], 0});
  }
  const ModelScorer scorer(*opened->definition().compiled, scored, opened->definition().metric, {1});
  ModelScore score;
  scorer.score({opened->truth(1)}, std::nullopt, 0, score);
  EXPECT_EQ(score.kind, ScoreKind::full);
  EXPECT_EQ(score.total, 0.0);
}

TEST(EeaLoop, AbandoningAndReuseChangeNoSurvivor) {
  const auto quick = small_bench();
  const auto naive = small_bench({"estimation.abandon=false", "estimation.reuse=false"});
  const MemoryJournal a = run(*quick), b = run(*naive);
  ASSERT_EQ(a.models.size(), b.models.size());
  std::uint64_t abandoned = 0;
  for (std::size_t i = 0; i < a.models.size(); ++i) {
    EXPECT_TRUE(same(a.models[i].genome, b.models[i].genome)) << "model " << i;
    if (a.models[i].kind == ScoreKind::full) {
      EXPECT_TRUE(same(a.models[i].score, b.models[i].score));
    }
    if (a.models[i].kind != ScoreKind::abandoned) continue;
    ++abandoned;
    EXPECT_LE(a.models[i].score, b.models[i].score);
  }
  EXPECT_GT(abandoned, 0U);
  for (std::size_t pass = 0; pass < a.passes.size(); ++pass) {
    EXPECT_EQ(a.passes[pass].best_model, b.passes[pass].best_model);
    EXPECT_LT(a.passes[pass].steps, b.passes[pass].steps);
    EXPECT_TRUE(same(a.passes[pass].best_values, b.passes[pass].best_values));
  }
  expect_same_tests(a.tests, b.tests);
}

/// From its checkpoints, every or every so many, a run comes to the same rows.
void expect_resumable(const OpenEeaRun& opened, std::size_t every = 1) {
  const MemoryJournal whole = run(opened);
  for (std::size_t at = 0; at < whole.checkpoints.size(); at += every) {
    EeaState state = state_at(opened, whole, whole.checkpoints[at]);
    const std::uint64_t models_before = state.models;
    MemoryJournal rest;
    run(opened, rest, state);
    const std::vector<ModelRow> expected(whole.models.begin() + static_cast<std::ptrdiff_t>(models_before),
                                         whole.models.end());
    expect_same_models(rest.models, expected);
    if (rest.passes.empty()) continue;
    EXPECT_EQ(rest.passes.back().steps, whole.passes.back().steps);
    EXPECT_EQ(rest.passes.back().reused, whole.passes.back().reused);
    EXPECT_EQ(rest.passes.back().set_aside, whole.passes.back().set_aside);
    EXPECT_EQ(rest.passes.back().stopped, whole.passes.back().stopped);
    EXPECT_TRUE(same(rest.passes.back().best_values, whole.passes.back().best_values));
  }
}

TEST(EeaLoop, GoesOnFromEveryCheckpointWithTheSameRows) { expect_resumable(*small_bench()); }

const std::vector<std::string> kSeveralModels = {"estimation.restarts=2", "exploration.fitness=model_disagreement",
                                                 "exploration.fitness_parameters={models=3}", "experiment.passes=3"};

std::vector<std::string> with(std::vector<std::string> overrides, const std::vector<std::string>& more) {
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

TEST(EeaLoop, GoesOnFromEveryCheckpointWithRestartsAndTrialsSetAside) {
  expect_resumable(*small_bench(with(kSeveralModels, {"estimation.challenge=1.0001", "estimation.patience=1"})), 5);
}

const std::vector<std::string> kReplayed = {"estimation.replay=true", "estimation.profiled=['sensor.*.delay']",
                                            "estimation.horizons=[0.1,0.2]"};

TEST(EeaLoop, GoesOnFromEveryCheckpointWithDelaysThatNoGeneSays) { expect_resumable(*small_bench(kReplayed)); }

TEST(EeaLoop, AnApproximateModelBeginsWithExploration) {
  const auto opened = small_bench({"model.approximate=true"});
  const MemoryJournal journal = run(*opened);
  ASSERT_EQ(journal.passes.size(), 3U);
  EXPECT_EQ(journal.passes.front().number, 0);
  EXPECT_EQ(journal.passes.front().evaluations, 0U);
  EXPECT_GT(journal.passes.front().test_evaluations, 0U);
  ASSERT_TRUE(journal.trial_rows.front().test.has_value());
  EXPECT_EQ(*journal.trial_rows.front().test, *journal.passes.front().best_test);
  EXPECT_TRUE(std::isfinite(journal.trial_rows.front().predicted_fitness));
  EXPECT_GT(journal.predictions, 0);
  EXPECT_EQ(journal.predictions_of_nobody, 0) << "the approximate model has no row";
}

TEST(EeaLoop, ARandomTestFitnessNeedsNoModel) {
  const auto opened = small_bench({"exploration.fitness=random"});
  const MemoryJournal journal = run(*opened);
  EXPECT_EQ(journal.tests.size(), 3U);
  EXPECT_EQ(journal.passes.front().test_evaluations, 0U);
}

TEST(EeaLoop, SeedsOfThePassBeforeStartTheNextOne) {
  const auto opened = small_bench({"estimation.seeds=2"});
  const MemoryJournal journal = run(*opened);
  const ModelRow& best = journal.models[*journal.passes[0].best_model];
  EXPECT_TRUE(same(journal.models[36].genome, best.genome));
}

TEST(EeaLoop, ModelsThatCannotBeSimulatedAreCountedWithTheirReason) {
  // Masses down to a gram under stiff servos and hard contacts: some of these robots explode.
  const auto opened = small_bench({"model.free.'body.*.mass'=[1e-9,1e12]"});
  const MemoryJournal journal = run(*opened);
  std::uint64_t invalid = 0;
  for (const ModelRow& model : journal.models) {
    if (model.kind != ScoreKind::invalid) continue;
    ++invalid;
    EXPECT_TRUE(std::isnan(model.score));
    EXPECT_FALSE(model.reason.empty());
  }
  std::uint64_t counted = 0;
  for (const PassRow& pass : journal.passes) counted += pass.invalid;
  EXPECT_EQ(counted, invalid);
}

constexpr const char* kMeasuredPendulum = R"(
[experiment]
name = "measured"
[target]
kind = "recorded"
files = ["data/servo_pendulum/sine.csv"]
hold = "zero"
time = { column = "t_s", use = [[0.0, 2.0]] }
sensors = { angle = { column = "angle_deg", unit = "deg" } }
commands = { motor = { column = "torque_Nm", unit = "N*m" } }
[model]
file = "robots/servo-pendulum.toml"
effects = [{ effect = "coulomb_friction", where = "joint.hinge", start = { torque = 0.024 }, fixed = ["torque"] }]
[model.free]
"body.arm.mass" = ["0.3 kg", "1.0 kg"]
"joint.hinge.armature" = [0.0, 0.02]
"joint.hinge.damping" = [0.0, 0.2]
[engine]
step = "2 ms"
[estimation]
search = "cma_es"
parameters = { generations = 60 }
)";

TEST(EeaLoop, EstimatesOnRecordedTrials) {
  const auto opened = small_bench({}, kMeasuredPendulum, true);
  EXPECT_FALSE(opened->takes_tests());
  const MemoryJournal journal = run(*opened);
  EXPECT_TRUE(journal.tests.empty());
  ASSERT_EQ(journal.passes.size(), 1U);
  ASSERT_EQ(journal.passes[0].best_values.size(), 3U);
  EXPECT_LT(journal.passes[0].best_score, 1e-3);  // rad, mean absolute difference; the encoder's step is 3.1e-3
  const auto damping = std::find_if(opened->definition().model.free.begin(), opened->definition().model.free.end(),
                                    [](const FreeValue& value) { return value.address == "joint.hinge.damping"; });
  const double found =
      journal.passes[0].best_values[static_cast<std::size_t>(damping - opened->definition().model.free.begin())];
  EXPECT_NEAR(found, 0.021, 0.001);  // N*m*s/rad, of the bench
}

TEST(EeaDefinition, RefusesATestThatNoMemoryHolds) {
  EXPECT_THAT([] { small_bench({"test.duration=1e9"}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("test.duration"), HasSubstr("shorten it"))));
}

TEST(EeaDefinition, NamesEveryProblemAtItsPlace) {
  EXPECT_THAT(
      [] {
        small_bench({"estimation.search=truncatoin", "exploration.fitness=forward", "estimation.parameters.keep=-1",
                     "test.parameters={hiden=3}"});
      },
      ThrowsMessage<BadInput>(AllOf(HasSubstr("truncatoin"), HasSubstr("forward_distance"), HasSubstr("hiden"),
                                    HasSubstr("test.parameters"))));
}

}  // namespace
}  // namespace lacuna

#include "eea/definition/delays.h"
#include "eea/ensemble/ensemble.h"
#include "eea/ensemble/ensemble_prediction.h"
#include "eea/small_run.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

/// Several models that differ.
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
  definition.free = {{{"body.arm.mass", "kg", 0.0, 1.0}}, {{"effect.grease.damping", "N*m*s/rad", 0.0, 1.0}}};
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
  definition.free = {{{"body.arm.mass", "kg", 0.0, 9.0}}};
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
const std::string kKeptCandidates = R"([experiment]
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
  const auto bench = small_bench({}, kKeptCandidates);
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
  const auto bench = small_bench({}, kKeptCandidates);
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
  const MemoryJournal journal = run(*small_bench({"estimation.restarts=7"}, kKeptCandidates));
  for (const PassRow& pass : journal.passes) {
    EXPECT_EQ(pass.evaluations, 3U * (12U + 4U * 6U)) << "neither effect, one or the other";
    EXPECT_EQ(pass.invalid, 0U);
  }
}

TEST(Rivals, NeedSeveralStructuresAndRestarts) {
  EXPECT_THAT([] { small_bench({"estimation.rivals=true"}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("restarts = 2"), HasSubstr("have the same structure"))));
}

}  // namespace
}  // namespace lacuna

#include "search/find_missing.h"

#include "config/experiment_reader.h"
#include "diagnosis/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gtest/gtest.h>

#include <optional>

namespace lacuna {
namespace {

/// A pendulum with something that its model lacks, and what is found among a few effects.
Missing found(const PendulumTruth& truth, const std::optional<PendulumTruth>& held_out = std::nullopt) {
  Experiment experiment = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  experiment.engine.step = 0.01;
  experiment.engine.substeps = 8;
  experiment.noise = {};
  experiment.model.effects = {};
  std::vector<Trial> trials = {recorded(truth, "multi.csv", multisine, 6.0, 3),
                               recorded(truth, "steps.csv", steps, 6.0, 4)};
  if (held_out) {
    trials.push_back(recorded(*held_out, "held.csv", multisine, 6.0, 5));
    trials.back().held_out = true;
  }
  const ModelDefinition definition = define_model(experiment, built_catalog());
  return find_missing(Ground({.experiment = experiment,
                              .catalog = built_catalog(),
                              .trials = trials,
                              .values = definition.start_values(),
                              .among = {"joint_spring", "coulomb_friction", "viscous_friction", "joint_offset_torque"},
                              .threads = 2}));
}

std::string answer_of(const Missing& missing) { return name_of_set(missing.ranking[missing.answer].model.added); }

TEST(FindMissing, NamesDryFriction) {
  const Missing missing = found({.inertia = 0.03, .friction = 0.05});
  EXPECT_EQ(answer_of(missing), "coulomb_friction @ joint.hinge");
  EXPECT_LT(missing.ranking[missing.answer].cost, missing.base.cost - 0.5);
}

TEST(FindMissing, NamesTwoEffects) {
  const Missing missing = found({.inertia = 0.03, .friction = 0.04, .spring = 0.4});
  EXPECT_EQ(answer_of(missing), "coulomb_friction @ joint.hinge + joint_spring @ joint.hinge");
}

TEST(FindMissing, LeavesOutAnEffectThatHeldOutRecordingsSpeakAgainst) {
  const PendulumTruth fitted = {.inertia = 0.03, .friction = 0.04, .spring = 0.4};
  const Missing agreed = found(fitted, fitted);
  EXPECT_EQ(answer_of(agreed), "coulomb_friction @ joint.hinge + joint_spring @ joint.hinge");
  EXPECT_TRUE(agreed.not_confirmed.empty());
  const Missing missing = found(fitted, PendulumTruth{.inertia = 0.03, .friction = 0.04});
  EXPECT_EQ(answer_of(missing), "coulomb_friction @ joint.hinge");
  ASSERT_EQ(missing.not_confirmed.size(), 1U);
  EXPECT_EQ(missing.not_confirmed[0].effect, "joint_spring @ joint.hinge");
  EXPECT_LT(missing.not_confirmed[0].without, missing.not_confirmed[0].with_it);
}

TEST(FindMissing, AddsNothingWhereNothingIsMissing) { EXPECT_EQ(answer_of(found({.inertia = 0.03})), ""); }

}  // namespace
}  // namespace lacuna

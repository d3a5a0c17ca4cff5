#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "plugins/built_catalog.h"
#include "search/effect_search.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

double fast(double t) { return 0.8 * (std::sin(2.0 * M_PI * 3.0 * t) + std::sin(2.0 * M_PI * 7.0 * t + 1.0)); }

struct OddRig {
  std::string name;
  std::vector<Trial> trials;
};

const PendulumTruth kDry = {.friction = 0.04};

/// Recordings as few would make them, of a pendulum with dry friction that its model lacks.
std::vector<OddRig> odd_rigs() {
  const auto nothing = [](double) { return 0.0; };
  return {{"FreeSwings",
           {recorded(kDry, "one.csv", nothing, 4.0, 3, {.angle = 1.2}),
            recorded(kDry, "two.csv", nothing, 4.0, 4, {.angle = 2.0})}},
          {"FifteenHertz", {recorded(kDry, "one.csv", multisine, 15.0, 3, {.interval = 1.0 / 15.0})}},
          {"FortySamples", {recorded(kDry, "one.csv", multisine, 2.0, 3, {.interval = 0.05})}},
          {"HalfASecondAtTwoKilohertz",
           {recorded({.friction = 0.04, .noise = 1e-4}, "one.csv", fast, 0.5, 3, {.interval = 5e-4})}},
          {"OneFile", {recorded(kDry, "one.csv", multisine, 5.0, 3)}}};
}

class OddRigs : public testing::TestWithParam<OddRig> {};

TEST_P(OddRigs, TellTheirDryFriction) {
  Experiment experiment = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  experiment.engine.step = std::min(0.01, GetParam().trials.front().measured.times(1));
  experiment.engine.substeps = 8;
  experiment.noise = {};
  experiment.model.effects = {};
  const ModelDefinition definition = define_model(experiment, built_catalog());
  const SearchResult found =
      search_effects({.experiment = experiment,
                      .catalog = built_catalog(),
                      .trials = GetParam().trials,
                      .values = definition.start_values(),
                      .among = {"joint_spring", "coulomb_friction", "viscous_friction", "joint_offset_torque"},
                      .work = {2}});
  EXPECT_EQ(found.sets[found.decision.answer].judged.members, std::set<std::string>{"coulomb_friction @ joint.hinge"});
}

INSTANTIATE_TEST_SUITE_P(Each, OddRigs, testing::ValuesIn(odd_rigs()), [](const auto& rig) { return rig.param.name; });

}  // namespace
}  // namespace lacuna

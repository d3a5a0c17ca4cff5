#include "diagnosis/rounds/simpler_effects.h"

#include "config/experiment_reader.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

Contender bare() {
  Experiment experiment = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  experiment.model.effects.clear();
  experiment.engine.substeps = 1;
  Contender model = plain(experiment, built_catalog(), {});
  model.values = model.definition.start_values();
  return model;
}

EffectEntry placed(const std::string& effect, const std::string& where) { return {effect, effect, {where}, {}, {}}; }

/// With the start values of all, but for these of the addresses.
Contender with(const std::vector<EffectEntry>& added, const std::map<std::string, double>& values) {
  Contender model = with_effects(bare(), added, {}, built_catalog());
  for (const FreeValue& free : model.definition.free) {
    const auto known = values.find(free.address);
    model.values.push_back(known == values.end() ? free.start : known->second);
  }
  return model;
}

std::vector<std::string> effects_of(const std::vector<Contender>& models) {
  std::vector<std::string> names;
  for (const Contender& model : models)
    for (const EffectEntry& entry : model.added) names.push_back(entry.effect);
  return names;
}

double value_of(const Contender& model, const std::string& address) {
  for (std::size_t i = 0; i < model.definition.free.size(); ++i)
    if (model.definition.free[i].address == address) return model.values.at(i);
  ADD_FAILURE() << "no value is called " << address;
  return 0.0;
}

TEST(SimplerEffects, TakeThePlaceAndTheMeanOfWhatTheyReplace) {
  const Contender answer =
      with({placed("directional_friction", "joint.hinge"), placed("command_offset", "actuator.motor")},
           {{"effect.directional_friction.positive", 0.065},
            {"effect.directional_friction.negative", 0.005},
            {"effect.command_offset.offset", -0.02}});
  const std::vector<Contender> models =
      with_simpler_effects(answer, bare(), built_catalog(), {"directional_friction", "coulomb_friction"});
  ASSERT_THAT(effects_of(models), ElementsAre("coulomb_friction", "command_offset"));
  EXPECT_THAT(value_of(models[0], "effect.coulomb_friction.torque"), DoubleNear(0.035, 1e-12));
  EXPECT_EQ(value_of(models[0], "effect.command_offset.offset"), -0.02);
  EXPECT_EQ(value_of(models[0], "body.arm.mass"), value_of(answer, "body.arm.mass"));
}

/// What the user did not allow, what stands on other elements, and what is there already.
TEST(SimplerEffects, AreNotThoseThatCannotBe) {
  const Contender friction = with({placed("stribeck_friction", "joint.hinge")}, {});
  EXPECT_THAT(with_simpler_effects(friction, bare(), built_catalog(), {"viscous_friction"}), testing::IsEmpty());
  const Contender motor = with({placed("thermal_fade", "actuator.motor")}, {});
  EXPECT_THAT(effects_of(with_simpler_effects(motor, bare(), built_catalog(), {})), ElementsAre("torque_gain"));
  const Contender both =
      with({placed("stribeck_friction", "joint.hinge"), placed("coulomb_friction", "joint.hinge")}, {});
  EXPECT_THAT(with_simpler_effects(both, bare(), built_catalog(), {"coulomb_friction"}), testing::IsEmpty());
}

}  // namespace
}  // namespace lacuna

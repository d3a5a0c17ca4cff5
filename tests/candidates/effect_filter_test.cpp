#include "candidates/effect_filter.h"

#include "config/experiment_reader.h"
#include "plugins/built_catalog.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

namespace lacuna {
namespace {

/// The servo pendulum, which has no floor to touch, with viscous friction already in its model.
Experiment servo_pendulum() {
  return read_experiment_text(R"([experiment]
name = "among"
[target]
kind = "recorded"
files = ["data/servo_pendulum/sine.csv"]
time = { column = "t_s" }
sensors = { angle = { column = "angle_deg", unit = "deg" } }
commands = { motor = { column = "torque_Nm", unit = "N*m" } }
[model]
file = "robots/servo-pendulum.toml"
effects = [{ effect = "viscous_friction", where = "joint.hinge" }]
)",
                              std::string(LACUNA_SOURCE_DIRECTORY) + "/experiments/among.toml");
}

std::string objections(const std::vector<std::string>& among) {
  const Experiment experiment = servo_pendulum();
  try {
    check_effect_filter(among, experiment, built_catalog(), define_model(experiment, built_catalog()));
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(Among, TakesEffectsThatCanBeAdded) { EXPECT_EQ(objections({"coulomb_friction", "command_delay"}), ""); }

TEST(Among, CountsAnEffectOnce) {
  const Experiment experiment = servo_pendulum();
  EXPECT_THAT(check_effect_filter({"coulomb_friction", "command_delay", "coulomb_friction"}, experiment,
                                  built_catalog(), define_model(experiment, built_catalog())),
              testing::ElementsAre("coulomb_friction", "command_delay"));
}

TEST(Among, NamesEveryEffectThatCannotBeAddedAndWhy) {
  const std::string text = objections({"coulomb_fiction", "viscous_friction", "coulomb_friction"});
  EXPECT_THAT(text, testing::HasSubstr("--among coulomb_fiction: "));
  EXPECT_THAT(text, testing::HasSubstr("coulomb_friction"));  // what is meant
  EXPECT_THAT(text, testing::HasSubstr("--among viscous_friction: the effect cannot be added to this model: the model "
                                       "already has this effect"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("--among coulomb_friction")));
}

}  // namespace
}  // namespace lacuna

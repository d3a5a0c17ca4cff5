#include "config/experiment_reader.h"
#include "diagnosis/diagnosis.h"
#include "diagnosis/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

Diagnosis diagnosed(const PendulumTruth& truth, const std::vector<std::string>& among) {
  Experiment experiment = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  experiment.engine.step = 0.01;
  experiment.engine.substeps = 8;
  experiment.noise = {};
  const ModelDefinition definition = define_model(experiment, built_catalog());
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const std::vector<Trial> trials = {recorded(truth, "multi.csv", multisine, 6.0, 3),
                                     recorded(truth, "steps.csv", steps, 6.0, 4)};
  return diagnose({.experiment = experiment,
                   .catalog = built_catalog(),
                   .definition = definition,
                   .model = *model,
                   .trials = trials,
                   .values = definition.start_values(),
                   .among = among,
                   .threads = 2});
}

/// The limit's default is far above all commands, and its range goes further up still: it must be looked for below.
TEST(Limits, OfAMotorAreFoundFromFarAbove) {
  const Diagnosis diagnosis =
      diagnosed({.inertia = 0.03, .damping = 0.02, .limit = 0.35}, {"torque_saturation", "viscous_friction"});
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found);
  const FoundEffect& found = diagnosis.ranking.at(0).effects.at(0);
  EXPECT_EQ(found.effect, "torque_saturation");
  EXPECT_NEAR(found.parameters.at(0).value, 0.35, 0.01);
}

/// No segment but the first begins at rest: what the sensor shows there happened before.
TEST(SensorDelay, IsFoundInSegmentsThatBeginInTheMiddle) {
  const Diagnosis diagnosis = diagnosed({.inertia = 0.03, .damping = 0.02, .lateness = 0.008}, {"sensor_delay"});
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found);
  EXPECT_NEAR(diagnosis.ranking.at(0).effects.at(0).parameters.at(0).value, 0.008, 0.0005);
}

/// Dry friction and a constant torque are the same: two effects for one.
TEST(FrictionByDirection, IsOneEffectAndNotTwo) {
  const Diagnosis diagnosis =
      diagnosed({.inertia = 0.03, .damping = 0.02, .friction = 0.01, .backward = 0.02},
                {"coulomb_friction", "directional_friction", "joint_offset_torque", "command_offset"});
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found);
  ASSERT_EQ(diagnosis.ranking.at(0).effects.size(), 1u);
  const FoundEffect& found = diagnosis.ranking.at(0).effects.at(0);
  EXPECT_EQ(found.effect, "directional_friction");
  EXPECT_NEAR(found.parameters.at(0).value, 0.01, 0.002);
  EXPECT_NEAR(found.parameters.at(1).value, 0.03, 0.002);
}

}  // namespace
}  // namespace lacuna

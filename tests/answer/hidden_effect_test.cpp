#include "answer/find_missing_effects.h"
#include "config/experiment_reader.h"
#include "data_checks/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

/// `present`: what the model has already.
Diagnosis diagnosed(const std::vector<Trial>& trials, const std::vector<std::string>& among,
                    const EffectList& present = {}) {
  Experiment experiment = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  experiment.engine.step = 0.01;
  experiment.engine.substeps = 8;
  experiment.noise = {};
  experiment.model.effects = present;
  const ModelDefinition definition = define_model(experiment, built_catalog());
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  return find_missing_effects({.experiment = experiment,
                               .catalog = built_catalog(),
                               .definition = definition,
                               .model = *model,
                               .trials = trials,
                               .among = among,
                               .work = {2}});
}

Diagnosis diagnosed(const PendulumTruth& truth, const std::vector<std::string>& among, const EffectList& present = {}) {
  return diagnosed(
      std::vector{recorded(truth, "multi.csv", multisine, 6.0, 3), recorded(truth, "steps.csv", steps, 6.0, 4)}, among,
      present);
}

/// What is named first in an answer that must find something.
FoundEffect found(const PendulumTruth& truth, const std::vector<std::string>& among) {
  const Diagnosis diagnosis = diagnosed(truth, among);
  EXPECT_EQ(diagnosis.verdict, Verdict::effect_found);
  return diagnosis.ranking.at(0).effects.at(0);
}

/// The limit's default is far above all commands, and its range goes further up still: it must be looked for below.
TEST(Limits, OfAMotorAreFoundFromFarAbove) {
  const FoundEffect limit =
      found({.inertia = 0.03, .damping = 0.02, .limit = 0.35}, {"torque_saturation", "viscous_friction"});
  ASSERT_EQ(limit.effect, "torque_saturation");
  EXPECT_NEAR(limit.parameters.at(0).value, 0.35, 0.01);
}

/// Neither a limit at rest below all commands nor a speed that is never exceeded comes near to that.
TEST(Limits, OfAMotorThatFallWithTheSpeedAreFoundFromFarAbove) {
  const FoundEffect line = found({.inertia = 0.03, .damping = 0.02, .limit = 0.6, .no_load = 6.0},
                                 {"torque_speed_line", "torque_saturation", "viscous_friction"});
  ASSERT_EQ(line.effect, "torque_speed_line");
  EXPECT_NEAR(line.parameters.at(0).value, 0.6, 0.03);
  EXPECT_NEAR(line.parameters.at(1).value, 6.0, 0.6);
}

/// A point that is metres away, where the middle of its range's first hundredth lies, pulls in one direction only.
TEST(CablePull, IsLookedForNearTheRobot) {
  const FoundEffect cable = found({.inertia = 0.03, .damping = 0.02, .tension = 0.4, .cable_x = 0.3, .cable_z = -0.15},
                                  {"cable_pull", "joint_offset_torque", "command_offset"});
  ASSERT_EQ(cable.effect, "cable_pull");
  EXPECT_NEAR(cable.parameters.at(0).value, 0.4, 0.1);
  EXPECT_NEAR(cable.parameters.at(1).value, 0.3, 0.1);
}

/// No prediction but the first begins at rest: what the sensor shows there happened before.
TEST(SensorDelay, IsFoundInPredictionsThatBeginInTheMiddle) {
  for (const double lateness : {0.008, 0.024}) {  // s, of command intervals of 0.01 s
    const Diagnosis diagnosis =
        diagnosed({.inertia = 0.03, .damping = 0.02, .lateness = lateness}, {"sensor_delay"}, {});
    ASSERT_EQ(diagnosis.verdict, Verdict::effect_found) << lateness;
    EXPECT_NEAR(diagnosis.ranking.at(0).effects.at(0).parameters.at(0).value, lateness, 0.0005);
  }
}

/// A late model must not predict over a shorter time than others: random forces disturb longer predictions more.
TEST(SensorDelay, IsNotFoundWhereRandomForcesAct) {
  const Diagnosis diagnosis =
      diagnosed({.inertia = 0.03, .damping = 0.02, .disturbance = 0.05}, {"sensor_delay", "sensor_lag"}, {});
  EXPECT_NE(diagnosis.verdict, Verdict::effect_found);
}

/// A drive that is late, of recordings that begin with a step from rest.
const PendulumTruth kLateDrive = {.inertia = 0.03, .damping = 0.02, .delay = 0.024, .before = 0.0};

Diagnosis of_first_steps(const std::function<void(Trial&)>& state) {
  std::vector<Trial> trials = {recorded(kLateDrive, "steps.csv", steps, 4.0, 4),
                               recorded(
                                   kLateDrive, "back.csv", [](double t) { return -steps(t); }, 4.0, 5)};
  for (Trial& trial : trials) state(trial);
  return diagnosed(trials, {"command_delay", "sensor_delay", "actuator_lag"});
}

void expect_late_drive(const Diagnosis& diagnosis) {
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found);
  const std::vector<FoundEffect>& effects = diagnosis.ranking.at(0).effects;
  EXPECT_EQ(effects.size(), 1U);
  ASSERT_EQ(effects.at(0).effect, "command_delay");
  EXPECT_NEAR(effects.at(0).parameters.at(0).value, kLateDrive.delay, 0.0005);
}

TEST(FirstStep, FromAStartAtRestTellsTheDriveFromTheSensor) {
  expect_late_drive(of_first_steps([](Trial& trial) {
    trial.commands.before = {std::nan("")};
    trial.initial = {{InitialKnowledge::given, 0.0, 0.0}};
  }));
}

/// Where the start is read off its own readings, a late sensor differs from a late drive by little: either may be
/// first, and the timing of the commands may take a share, but the drive must not be missing.
void expect_late_drive_or_sensor(const Diagnosis& diagnosis) {
  constexpr double kHalfAnInterval = 0.005;  // s
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found);
  const RankedModel& answer = diagnosis.ranking.at(0);
  std::vector<std::string> names = answer.look_alikes;
  names.push_back(answer.effects.at(0).effect + " @ actuator.motor");
  EXPECT_THAT(names, testing::Contains("command_delay @ actuator.motor"));
  EXPECT_NEAR(answer.effects.at(0).parameters.at(0).value, kLateDrive.delay, kHalfAnInterval);
}

TEST(FirstStep, WithWhatWasCommandedBeforeNamesTheDrive) {
  expect_late_drive_or_sensor(of_first_steps([](Trial& trial) { trial.commands.before = {kLateDrive.before}; }));
}

TEST(FirstStep, OfWhichNothingIsKnownIsNotScored) {
  expect_late_drive_or_sensor(of_first_steps([](Trial& trial) { trial.commands.before = {std::nan("")}; }));
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

TEST(FrictionByDirection, IsEnoughWhereTwoEffectsWereFoundFirst) {
  const Diagnosis diagnosis = diagnosed({.inertia = 0.03, .damping = 0.02, .friction = 0.03, .backward = 0.012},
                                        {"coulomb_friction", "directional_friction", "joint_offset_torque"});
  ASSERT_EQ(diagnosis.ranking.at(0).effects.size(), 1u);
  EXPECT_EQ(diagnosis.ranking.at(0).effects.at(0).effect, "directional_friction");
}

EffectEntry friction_in_model(double torque) {
  return {"friction", "coulomb_friction", {"joint.hinge"}, {{"torque", torque}}, {}};
}

/// A friction that is half as strong again on the way back is not what the model has.
TEST(PresentEffect, ThatIsNotOfTheRightFormIsMended) {
  const Diagnosis strong =
      diagnosed({.inertia = 0.03, .damping = 0.01, .friction = 0.03, .backward = 0.015, .noise = 2e-3},
                {"joint_offset_torque"}, {friction_in_model(0.03)});
  ASSERT_EQ(strong.verdict, Verdict::effect_found);
  EXPECT_EQ(strong.ranking.at(0).effects.at(0).effect, "joint_offset_torque");
}

}  // namespace
}  // namespace lacuna

#include "config/experiment_reader.h"
#include "diagnosis/likelihoods/diagnose.h"
#include "diagnosis/recorded_pendulum.h"
#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

namespace lacuna {
namespace {

/// `present`: what the model has already; `segment`: s, 0 for the usual length.
Diagnosis diagnosed(const std::vector<Trial>& trials, const std::vector<std::string>& among,
                    const EffectList& present = {}, double segment = 0.0) {
  Experiment experiment = read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml");
  experiment.engine.step = 0.01;
  experiment.engine.substeps = 8;
  experiment.noise = {};
  experiment.model.effects = present;
  const ModelDefinition definition = define_model(experiment, built_catalog());
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  return diagnose({.experiment = experiment,
                   .catalog = built_catalog(),
                   .definition = definition,
                   .model = *model,
                   .trials = trials,
                   .values = definition.start_values(),
                   .among = among,
                   .segment = segment,
                   .threads = 2});
}

Diagnosis diagnosed(const PendulumTruth& truth, const std::vector<std::string>& among, const EffectList& present = {},
                    double segment = 0.0) {
  return diagnosed(
      std::vector{recorded(truth, "multi.csv", multisine, 6.0, 3), recorded(truth, "steps.csv", steps, 6.0, 4)}, among,
      present, segment);
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

/// No segment but the first begins at rest: what the sensor shows there happened before. A reading that comes less than
/// a command interval late may as well be a command that is held so much later than was recorded.
TEST(SensorDelay, IsFoundInSegmentsThatBeginInTheMiddle) {
  constexpr double kLateness = 0.024;  // s, 2.4 command intervals
  const Diagnosis diagnosis =
      diagnosed({.inertia = 0.03, .damping = 0.02, .lateness = kLateness}, {"sensor_delay"}, {}, 3.0);
  ASSERT_EQ(diagnosis.verdict, Verdict::effect_found);
  EXPECT_NEAR(diagnosis.ranking.at(0).effects.at(0).parameters.at(0).value, kLateness, 0.0005);
}

TEST(SensorDelay, OfLessThanACommandIntervalIsNotNamed) {
  const Diagnosis diagnosis =
      diagnosed({.inertia = 0.03, .damping = 0.02, .lateness = 0.008}, {"sensor_delay"}, {}, 3.0);
  EXPECT_NE(diagnosis.verdict, Verdict::effect_found);
  EXPECT_THAT(diagnosis.findings, testing::Contains(testing::HasSubstr("commands act 8.0")));
}

/// A drive that is late, of recordings that begin with a step from rest.
constexpr PendulumTruth kLateDrive = {.inertia = 0.03, .damping = 0.02, .delay = 0.024, .before = 0.0};

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

TEST(Timing, IsSaidInIntervalsWhereCommandsCameAtTwoRates) {
  const PendulumTruth late = {.inertia = 0.03, .damping = 0.02, .delay = 0.004};
  PendulumTruth later = late;
  later.delay *= 2.0;
  Trial rare = recorded(later, "steps.csv", steps, 6.0, 4);
  CommandSeries& commands = rare.commands;  // each level of which lasts 80 rows
  const auto kept = Eigen::seq(0, commands.series.times.size() - 1, 2);
  commands.series.times = commands.series.times(kept).eval();
  commands.series.samples = commands.series.samples(kept, Eigen::all).eval();
  const Diagnosis diagnosis =
      diagnosed(std::vector{recorded(late, "multi.csv", multisine, 6.0, 3), rare}, {"command_delay"});
  EXPECT_NE(diagnosis.verdict, Verdict::effect_found);
  EXPECT_THAT(diagnosis.findings,
              testing::Contains(testing::ContainsRegex("act 0.(3[6-9]|4[0-4]?) command intervals .*s to .*s. later")));
}

TEST(RandomForce, ThatIsMostOfTheNoiseIsToBeDeclared) {
  constexpr double kDeviation = 0.01, kTime = 0.2;  // N·m, s; see PendulumTruth
  const PendulumTruth calm = {.inertia = 0.03, .damping = 0.02};
  PendulumTruth disturbed = calm;
  disturbed.disturbance = kDeviation;
  const std::regex declared(
      "process = . .joint.hinge. = .([0-9.e-]+) N.m. . and process_correlation_time = .([0-9.]+) s");
  double power = 0.0;
  for (const std::string& finding : diagnosed(disturbed, {"coulomb_friction"}).findings)
    if (std::smatch found; std::regex_search(finding, found, declared))
      power = std::pow(std::stod(found[1]), 2) * std::stod(found[2]);
  EXPECT_GT(power, 0.4 * kDeviation * kDeviation * kTime);
  EXPECT_LT(power, 2.0 * kDeviation * kDeviation * kTime);
  for (const std::string& finding : diagnosed(calm, {"coulomb_friction"}).findings)
    EXPECT_THAT(finding, testing::Not(testing::HasSubstr("process")));
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
  EXPECT_THAT(
      diagnosis.findings,
      testing::Contains(testing::HasSubstr(
          "directional_friction @ joint.hinge alone gains 100.0 % of what coulomb_friction @ joint.hinge and")));
}

EffectEntry friction_in_model(double torque) {
  return {"friction", "coulomb_friction", {"joint.hinge"}, {{"torque", torque}}, {}};
}

/// A friction that is a little stronger on the way back is still a friction; one that is half as strong again is not
/// what the model has.
TEST(PresentEffect, ThatIsNotQuiteOfTheRightFormIsNoReasonToAddAnother) {
  const Diagnosis slight =
      diagnosed({.inertia = 0.03, .damping = 0.01, .friction = 0.03, .backward = 0.001, .noise = 2e-3},
                {"joint_offset_torque"}, {friction_in_model(0.03)});
  EXPECT_EQ(slight.verdict, Verdict::nothing_missing) << slight.base_times_floor;
  EXPECT_LT(slight.p_by_chance.value(), 0.01) << "and yet it is beyond chance";
  EXPECT_THAT(slight.findings, testing::Contains(testing::HasSubstr("what coulomb_friction @ joint.hinge explains")));

  const Diagnosis strong =
      diagnosed({.inertia = 0.03, .damping = 0.01, .friction = 0.03, .backward = 0.015, .noise = 2e-3},
                {"joint_offset_torque"}, {friction_in_model(0.03)});
  ASSERT_EQ(strong.verdict, Verdict::effect_found);
  EXPECT_EQ(strong.ranking.at(0).effects.at(0).effect, "joint_offset_torque");
}

}  // namespace
}  // namespace lacuna

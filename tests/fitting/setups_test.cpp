#include "fitting/fit.h"
#include "fitting/numerics/seeded_noise.h"
#include "support/robots.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace lacuna::setups_test {
namespace {

constexpr double kGain = 0.8, kDamping = 0.05;
constexpr double kNoise = 1e-3;  // rad
constexpr double kInterval = 0.01;

/// A pendulum on a motor whose gain nobody knows, tested with two loads that were weighed and one that was not.
ModelDefinition pendulum_with_loads() {
  ModelDefinition definition;
  RobotSpec& robot = definition.structure.robot;
  robot = pendulum(1.0, 0.3, 1e-3);
  robot.sensors = {make_sensor("position", SensorKind::joint_position, "joint")};
  definition.engine = {.engine = "articulated", .step = kInterval, .substeps = 1};
  definition.free = {
      {{"actuator.motor.gain", "1", 0.1, 3.0, 1.0}},
      {{"joint.joint.damping", "N*m*s/rad", 0.0, 1.0, 0.0}},
      {{.address = "body.body.mass@found", .unit = "kg", .lower = 0.1, .upper = 5.0, .start = 1.0}, "", {}, "found"}};
  definition.structure.parameters = {
      {"actuator.motor.gain", 0.1, 3.0}, {"joint.joint.damping", 0.0, 1.0}, {"body.body.mass", 0.1, 5.0, "found"}};
  definition.structure.setups = {
      {"light", {{"body.body.mass", 0.6}}}, {"heavy", {{"body.body.mass", 1.5}}}, {"found", {}}};
  return definition;
}

Trial recorded(const CompiledModel& model, const std::string& setup, double mass, std::uint64_t seed) {
  const Eigen::Index samples = 801;
  Test test;
  CommandSeries commands;
  commands.series.channels = {{"motor", "N*m"}};
  commands.series.times = Eigen::VectorXd::LinSpaced(samples, 0.0, 8.0);
  commands.series.samples.resize(samples, 1);
  for (Eigen::Index i = 0; i < samples; ++i)
    commands.series.samples(i, 0) =
        std::sin(2.1 * commands.series.times(i)) + 0.7 * std::sin(5.3 * commands.series.times(i));
  test.drive = commands;
  test.setup = setup;
  SimulationOptions options;
  options.end_time = 8.0;
  options.output_times = {commands.series.times.data(), static_cast<std::size_t>(samples)};
  const std::unique_ptr<Workspace> workspace = model.make_workspace();
  SimulationResult result;
  const std::vector<double> truth = {kGain, kDamping, mass};
  model.simulate(truth, test, options, *workspace, result);
  Trial trial;
  trial.name = setup;
  trial.setup = {setup, {}};
  trial.commands = commands;
  trial.measured = result.readings;
  trial.initial = {{InitialKnowledge::given, 0.0, 0.0}};
  trial.sensor_noise = {kNoise};
  SeededNoise random(seed, 0);
  for (Eigen::Index i = 0; i < samples; ++i) trial.measured.samples(i, 0) += kNoise * random.normal();
  return trial;
}

TEST(FittedSetups, KnownLoadsTellTheGainAndTheUnknownOneIsFound) {
  const ModelDefinition definition = pendulum_with_loads();
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const std::vector<Trial> trials = {recorded(*model, "light", 1.2, 1), recorded(*model, "heavy", 1.2, 2),
                                     recorded(*model, "found", 1.2, 3)};
  FitSection options;
  options.starts = 1;
  const FitResult result = fit({definition, *model, trials, options, 1, {2}});
  const std::vector<double> truth = {kGain, kDamping, 1.2};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(result.values[i].value, truth[i], 0.02 * truth[i]) << result.values[i].address;
    EXPECT_LT(result.values[i].lower_95, truth[i]) << result.values[i].address;
    EXPECT_GT(result.values[i].upper_95, truth[i]) << result.values[i].address;
  }
  EXPECT_TRUE(result.cannot_tell.empty());
}

/// Without the trial that it belongs to, the value has nothing to tell it.
TEST(FittedSetups, AValueOfNoTrialCannotBeTold) {
  const ModelDefinition definition = pendulum_with_loads();
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const std::vector<Trial> trials = {recorded(*model, "light", 1.2, 1), recorded(*model, "heavy", 1.2, 2)};
  FitSection options;
  options.starts = 1;
  const FitResult result = fit({definition, *model, trials, options, 1, {2}});
  EXPECT_FALSE(result.values[2].identified);
  EXPECT_TRUE(result.values[0].identified);
}

}  // namespace
}  // namespace lacuna::setups_test

#include "conformance/effect_rig.h"

#include "support/reference_integration.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <sstream>

namespace lacuna {
namespace {

constexpr const char* kTarget = R"(
[experiment]
name = "readme"
[target]
kind = "recorded"
files = ["data/servo_pendulum/sine.csv"]
time = { column = "t_s" }
sensors = { angle = { column = "angle_deg", unit = "deg" } }
commands = { motor = { column = "torque_Nm", unit = "N*m" } }
)";

/// The folders of other effects that are to be checked instead of Lacuna's own.
std::vector<std::filesystem::path> folders_under_test() {
  std::vector<std::filesystem::path> folders;
  const char* variable = std::getenv("LACUNA_EFFECTS_UNDER_TEST");
  std::istringstream list(variable ? variable : "");
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.push_back(std::filesystem::path(folder).lexically_normal());
  return folders;
}

std::vector<std::string> effects_under_test() {
  std::vector<std::string> names;
  for (const std::filesystem::path& folder : folders_under_test()) names.push_back(folder.filename().string());
  return names.empty() ? every_effect() : names;
}

std::filesystem::path folder_of(const std::string& effect) {
  for (const std::filesystem::path& folder : folders_under_test())
    if (folder.filename() == effect) return folder;
  return std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "plugins/effects" / effect;
}

std::string snippet_of(const std::string& effect) {
  const std::string readme = read_bytes(folder_of(effect) / "README.md");
  const std::string fence = "```toml\n";
  const std::size_t begin = readme.find(fence) + fence.size();
  return readme.substr(begin, readme.find("```", begin) - begin);
}

/// Nine levels in an order that repeats only after the test's end, each motor at another place in it.
void drive(SimulationRun& run) {
  constexpr std::array<double, 9> kLevels = {0.9, -0.4, 0.05, 1.4, -1.2, 0.3, -0.02, -0.8, 0.6};  // N·m
  constexpr std::size_t kCount = 32;
  CommandSeries commands{.series = {}, .hold = Hold::zero_order};
  const std::vector<ActuatorSpec>& motors = run.structure.robot.actuators;
  for (const ActuatorSpec& motor : motors) commands.series.channels.push_back({motor.name, "1"});
  commands.series.times.resize(kCount);
  commands.series.samples.resize(kCount, static_cast<Eigen::Index>(motors.size()));
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    commands.series.times(row) = 0.05 * static_cast<double>(i);
    for (std::size_t a = 0; a < motors.size(); ++a)
      commands.series.samples(row, static_cast<Eigen::Index>(a)) = kLevels[(i * i + 3 * i + 4 * a) % kLevels.size()];
  }
  run.test.drive = commands;
}

}  // namespace

std::vector<std::string> every_effect() {
  std::vector<std::string> names;
  for (const PluginListing& listing : built_catalog().list())
    if (listing.kind == "effect") names.push_back(listing.name);
  return names;
}

void on_every_effect(const std::function<void(const std::string& name, const PhysicalEffect& effect)>& check) {
  const std::vector<std::string> names = effects_under_test();
  EXPECT_FALSE(names.empty());
  for (const std::string& name : names) {
    SCOPED_TRACE("effect " + name);
    check(name, built_catalog().get<PhysicalEffect>(name));
  }
}

ModelDefinition readme_model(const std::string& effect) {
  const std::filesystem::path file = std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "experiments" / "readme.toml";
  return define_model(read_experiment_text(kTarget + snippet_of(effect), file), built_catalog());
}

SimulationRun moving(const ModelDefinition& definition) {
  SimulationRun run(definition.structure.robot, definition.engine.step);
  run.structure = definition.structure;
  run.engine = definition.engine;
  run.parameters = definition.start_values();
  for (SensorSpec& sensor : run.structure.robot.sensors) sensor.noise = sensor.quantum = 0.0;
  run.imperfections = SensorImperfections{.seed = 1};  // an effect's quantum counts
  if (!run.structure.robot.contact.ground) {
    // Effects of the transmission need a rotor of its own.
    for (ActuatorSpec& motor : run.structure.robot.actuators) motor.transmission.rotor_inertia = 0.002;
    drive(run);
    std::vector<double> positions(run.structure.robot.joints.size(), 0.0), velocities = positions;
    positions[0] = 0.8;  // it swings up to beyond 90 degrees
    velocities[0] = 8.0;
    run.from(positions, velocities);
  } else {
    run.structure.robot.gravity.x() = 4.0;        // feet slide
    run.structure.robot.contact.friction = 10.0;  // the bound of contact_friction, which replaces it
  }
  return run;
}

SimulationRun moving_without(const ModelDefinition& definition) {
  SimulationRun run = moving(definition);
  run.structure.effects.clear();
  run.structure.parameters.clear();
  run.parameters.clear();
  return run;
}

SimulationRun moving_with(const ModelDefinition& definition, const std::vector<double>& values) {
  SimulationRun run = moving(definition);
  run.structure.effects.front().values = values;
  run.structure.parameters.clear();
  run.parameters.clear();
  return run;
}

TimeSeries::Samples readings(const SimulationRun& run) { return run.run(evenly_spaced(0.8, 40)).readings.samples; }

}  // namespace lacuna

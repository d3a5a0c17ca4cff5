#include "conformance/effect_rig.h"

#include "support/reference_integration.h"

#include <gtest/gtest.h>

#include <array>

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

std::string snippet_of(const std::string& effect) {
  const std::string readme =
      read_bytes(std::filesystem::path(LACUNA_SOURCE_DIRECTORY) / "plugins/effects" / effect / "README.md");
  const std::string fence = "```toml\n";
  const std::size_t begin = readme.find(fence) + fence.size();
  return readme.substr(begin, readme.find("```", begin) - begin);
}

/// Nine levels in an order that repeats only after the test's end.
void drive(SimulationRun& run) {
  constexpr std::array<double, 9> kLevels = {0.9, -0.4, 0.05, 1.4, -1.2, 0.3, -0.02, -0.8, 0.6};  // N·m
  std::vector<double> times, values;
  for (std::size_t i = 0; i < 32; ++i) {
    times.push_back(0.05 * static_cast<double>(i));
    values.push_back(kLevels[(i * i + 3 * i) % kLevels.size()]);
  }
  run.command("motor", times, values, Hold::zero_order);
}

}  // namespace

void on_every_effect(const std::function<void(const std::string& name, const PhysicalEffect& effect)>& check) {
  int checked = 0;
  for (const PluginListing& listing : built_catalog().list()) {
    if (listing.kind != "effect") continue;
    SCOPED_TRACE("effect " + listing.name);
    check(listing.name, built_catalog().get<PhysicalEffect>(listing.name));
    ++checked;
  }
  EXPECT_GT(checked, 2);
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
  if (run.structure.robot.actuators.size() == 1) {
    // Effects of the transmission need a rotor of its own.
    run.structure.robot.actuators[0].transmission.rotor_inertia = 0.002;
    drive(run);
    run.from({0.8}, {8.0});  // it swings up to beyond 90 degrees
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

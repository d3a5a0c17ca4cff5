#include "evaluation/prediction/target_simulator.h"

#include "foundation/address.h"
#include "foundation/plugins/plugin_call.h"

#include <lacuna/error.h>
#include <lacuna/random_stream.h>

#include <array>
#include <cmath>

namespace lacuna {
namespace {

std::vector<double> noise_of(const RobotSpec& robot) {
  std::vector<double> noise;
  for (const SensorSpec& sensor : robot.sensors)
    noise.insert(noise.end(), sensor_channels(robot, sensor).size(), sensor.noise);
  return noise;
}

}  // namespace

std::vector<double> sample_times(const EngineSettings& engine, double duration) {
  const double period = engine.control_period > 0.0 ? engine.control_period : engine.step;
  const auto samples = static_cast<std::size_t>(std::floor(duration / period + 1e-9)) + 1;
  std::vector<double> times;
  times.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) times.push_back(static_cast<double>(i) * period);
  return times;
}

struct TargetSimulator::Desk {
  std::unique_ptr<Workspace> workspace;
  SimulationResult result;
};

TargetSimulator::TargetSimulator(const ModelDefinition& definition, std::vector<double> hidden,
                                 std::uint64_t noise_seed, const Stop& stop)
    : model_(compile(definition.structure, definition.engine)),
      simulator_(std::make_unique<Desk>()),
      engine_(definition.engine),
      robot_(definition.structure.robot),
      hidden_(std::move(hidden)),
      noise_seed_(noise_seed),
      stop_(stop) {
  simulator_->workspace = model_->make_workspace();
}

TargetSimulator::~TargetSimulator() = default;

Trial TargetSimulator::simulate(const Test& test) const {
  const HostCall call;
  const std::vector<double> times = sample_times(engine_, test.duration);
  SimulationOptions options;
  options.stop = stop_;
  options.start = test.start;
  options.end_time = times.back();
  options.output_times = times;
  options.imperfections = SensorImperfections{RandomStream(std::array<std::uint64_t, 2>{noise_seed_, number_})()};
  options.record_commands = true;
  options.record_centre_of_mass = true;
  SimulationResult& result = simulator_->result;
  model_->simulate(hidden_, test, options, *simulator_->workspace, result);
  if (result.ending != Ending::completed) throw Error("the target cannot carry out the test: " + result.reason);

  Trial trial;
  trial.commands = {result.commands, Hold::zero_order};
  trial.measured = result.readings;
  trial.initial.assign(model_->coordinates().size(), {InitialKnowledge::given, 0.0, 0.0});
  for (std::size_t c = 0; c < trial.initial.size(); ++c) {
    if (c < test.start.positions.size()) trial.initial[c].position = test.start.positions[c];
    if (c < test.start.velocities.size()) trial.initial[c].velocity = test.start.velocities[c];
  }
  trial.sensor_noise = noise_of(robot_);
  trial.command_noise.assign(trial.commands.series.channels.size(), 0.0);
  trial.centre_of_mass = result.centre_of_mass;
  return trial;
}

}  // namespace lacuna

#include "diagnosis/recorded_quadruped.h"

#include "config/experiment_reader.h"
#include "evaluation/model_definition.h"
#include "fitting/seeded_noise.h"
#include "foundation/address.h"
#include "plugins/built_catalog.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kInterval = 0.01;  // s, of the recording and the model's step
constexpr const char* kLegs[] = {"front_left", "front_right", "rear_left", "rear_right"};

/// What a model is and how it is integrated, after its target.
std::string model_text(double step, double stiffness, double damping, const std::string& effects) {
  return fmt::format(R"([model]
robot = "quadruped"
free = {{ "body.torso.mass" = [0.5, 5.0] }}
effects = [{}]
[engine]
step = {}
contact = {{ stiffness = {}, damping = {} }}
)",
                     effects, step, stiffness, damping);
}

/// Slow sines of each joint, in shares of its range.
CommandSeries commands_of(const std::vector<Channel>& channels, std::size_t number, double duration) {
  const auto rows = static_cast<Eigen::Index>(std::lround(duration / kInterval)) + 1;
  CommandSeries commands;
  commands.series = {channels, Eigen::VectorXd::LinSpaced(rows, 0.0, duration),
                     TimeSeries::Samples(rows, static_cast<Eigen::Index>(channels.size()))};
  SeededNoise random(77, number);
  for (Eigen::Index c = 0; c < commands.series.samples.cols(); ++c) {
    const double size = random.uniform(0.3, 0.9), frequency = random.uniform(0.5, 2.0),
                 phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Eigen::ArrayXd angle = 2.0 * std::numbers::pi * frequency * commands.series.times.array() + phase;
    commands.series.samples.col(c) = size * angle.sin();
  }
  return commands;
}

}  // namespace

std::string quadruped_experiment(std::size_t trials) {
  std::string files, sensors, commands, initial;
  for (std::size_t i = 0; i < trials; ++i) files += fmt::format("{}\"{}.csv\"", i > 0 ? ", " : "", i);
  for (const char* leg : kLegs) {
    sensors += fmt::format("touch_{0} = {{ column = \"touch_{0}\", unit = \"1\" }}\n", leg);
    sensors += fmt::format("angle_{0} = {{ column = \"angle_{0}\", unit = \"1\", noise = 0.002 }}\n", leg);
    for (const char* joint : {"hip", "knee"}) {
      commands += fmt::format("{0}_{1} = {{ column = \"{0}_{1}\", unit = \"1\" }}\n", leg, joint);
      initial += fmt::format("{0}_{1} = {{ knowledge = \"given\" }}\n", leg, joint);
    }
  }
  return fmt::format(R"([experiment]
name = "quadruped"
[target]
kind = "recorded"
files = [{}]
time = {{ column = "t_s" }}
[target.sensors]
{}[target.commands]
{}[target.initial]
{})",
                     files, sensors, commands, initial) +
         model_text(kInterval, 2e4, 300.0, "");
}

std::vector<Trial> quadruped_trials(const QuadrupedTruth& truth, std::size_t count, double duration) {
  const std::string target = "[experiment]\nname = \"truth\"\n[target]\nkind = \"simulated\"\nrobot = \"quadruped\"\n";
  const Experiment experiment = read_experiment_text(
      target + model_text(kInterval / 10.0, truth.stiffness, truth.damping, truth.effects), "truth.toml");
  const ModelDefinition definition = define_model(experiment, built_catalog());
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const std::unique_ptr<Workspace> workspace = model->make_workspace();
  std::vector<Trial> trials;
  for (std::size_t number = 0; number < count; ++number) {
    Trial trial;
    trial.name = std::to_string(number) + ".csv";
    trial.commands = commands_of(command_channels(definition.structure.robot), number, duration);
    trial.initial.assign(model->coordinates().size(), {InitialKnowledge::given, 0.0, 0.0});
    const Eigen::VectorXd& times = trial.commands.series.times;
    SimulationOptions options;
    options.end_time = duration;
    options.output_times = {times.data(), static_cast<std::size_t>(times.size())};
    SimulationResult result;
    model->simulate(definition.start_values(), {trial.commands, duration, {}}, options, *workspace, result);
    if (result.ending != Ending::completed) throw Error(result.reason);
    trial.measured = result.readings;
    SeededNoise random(truth.seed, number);
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
      const bool touch = trial.measured.channels[c].name.starts_with("touch");
      trial.sensor_noise.push_back(touch ? std::nan("") : truth.noise);
      auto column = trial.measured.samples.col(static_cast<Eigen::Index>(c));
      for (double& value : column) value = touch ? (value < 0.0 ? -1.0 : 1.0) : value + truth.noise * random.normal();
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

}  // namespace lacuna

#include "fitting/analytic_models.h"

#include "fitting/numerics/seeded_noise.h"

#include <cmath>

namespace lacuna::analytic {
namespace {

void prepare(const std::vector<Channel>& channels, const SimulationOptions& options, SimulationResult& result) {
  const auto rows = static_cast<Eigen::Index>(options.output_times.size());
  result.ending = Ending::completed;
  result.reason.clear();
  result.readings.channels = channels;
  result.readings.times = Eigen::Map<const Eigen::VectorXd>(options.output_times.data(), rows);
  result.readings.samples.resize(rows, static_cast<Eigen::Index>(channels.size()));
}

/// The index of the sample that holds at `time`.
Eigen::Index held(const TimeSeries& series, double time) {
  Eigen::Index index = 0;
  while (index + 1 < series.times.size() && series.times(index + 1) <= time + 1e-12) ++index;
  return index;
}

}  // namespace

void FormulaModel::simulate(std::span<const double> values, const Test&, const SimulationOptions& options, Workspace&,
                            SimulationResult& result) const {
  prepare(channels_, options, result);
  for (Eigen::Index row = 0; row < result.readings.times.size(); ++row)
    result.readings.samples(row, 0) = formula_(values, result.readings.times(row));
  if (result.readings.samples.allFinite()) return;
  result.ending = Ending::invalid;
  result.reason = "the formula has no value here";
}

void OneJointModel::simulate(std::span<const double> values, const Test& test, const SimulationOptions& options,
                             Workspace&, SimulationResult& result) const {
  prepare(channels_, options, result);
  const TimeSeries& commands = std::get<CommandSeries>(test.drive).series;
  Eigen::Index next = commands.times.size() > 0 ? held(commands, options.start_time) : 0;
  double q = options.start.positions.at(0), v = options.start.velocities.at(0), t = options.start_time;
  for (std::size_t row = 0; row < options.output_times.size(); ++row) {
    while (t < options.output_times[row] - 1e-12) {
      while (next + 1 < commands.times.size() && commands.times(next + 1) <= t + 1e-12) ++next;
      double h = std::min(1e-3, options.output_times[row] - t);
      if (next + 1 < commands.times.size()) h = std::min(h, commands.times(next + 1) - t);
      const double u = commands.times.size() > 0 ? commands.samples(next, 0) : 0.0;
      const auto a = [&](double position, double velocity) { return acceleration_(values, position, velocity, u); };
      const double a1 = a(q, v);
      const double v2 = v + 0.5 * h * a1, a2 = a(q + 0.5 * h * v, v2);
      const double v3 = v + 0.5 * h * a2, a3 = a(q + 0.5 * h * v2, v3);
      const double v4 = v + h * a3, a4 = a(q + h * v3, v4);
      q += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
      v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
      t += h;
    }
    result.readings.samples(static_cast<Eigen::Index>(row), 0) = q;
  }
  if (std::isfinite(q) && std::isfinite(v)) return;
  result.ending = Ending::invalid;
  result.reason = "the joint's position is not finite";
}

RobotSpec one_joint_robot() {
  RobotSpec robot;
  robot.name = "one_joint";
  robot.bodies.resize(1);
  robot.bodies[0].name = "arm";
  robot.joints.resize(1);
  robot.joints[0].name = "hinge";
  robot.joints[0].child = "arm";
  robot.actuators.resize(1);
  robot.actuators[0].name = "motor";
  robot.actuators[0].joint = "hinge";
  robot.sensors.resize(1);
  robot.sensors[0].name = "angle";
  robot.sensors[0].element = "hinge";
  return robot;
}

ModelDefinition define(std::vector<FreeValue> free, RobotSpec robot) {
  ModelDefinition definition;
  definition.free = std::move(free);
  definition.structure.robot = std::move(robot);
  for (const FreeValue& value : definition.free)
    definition.structure.parameters.push_back({value.address, value.lower, value.upper});
  return definition;
}

FreeValue free_value(std::string address, double start, double lower, double upper, Scale scale) {
  FreeValue value;
  value.address = std::move(address);
  value.unit = "1";
  value.start = start;
  value.lower = lower;
  value.upper = upper;
  value.scale = scale;
  return value;
}

Eigen::VectorXd regular_times(Eigen::Index samples, double rate) {
  return Eigen::VectorXd::LinSpaced(samples, 0.0, static_cast<double>(samples - 1) / rate);
}

Trial record(const CompiledModel& model, const std::vector<double>& values, const Eigen::VectorXd& times,
             const CommandSeries& commands, const StartState& start, double noise, std::uint64_t seed) {
  SimulationOptions options;
  options.start = start;
  options.start_time = times(0);
  options.end_time = times(times.size() - 1);
  options.output_times = {times.data(), static_cast<std::size_t>(times.size())};
  SimulationResult result;
  model.simulate(values, {commands, options.end_time, {}}, options, *model.make_workspace(), result);
  Trial trial;
  trial.name = "trial " + std::to_string(seed);
  trial.commands = commands;
  trial.measured = result.readings;
  SeededNoise random(seed, 1);
  for (auto reading : trial.measured.samples.rowwise())
    for (double& one : reading) one += noise * random.normal();
  trial.sensor_noise.assign(trial.measured.channels.size(),
                            noise > 0.0 ? noise : std::numeric_limits<double>::quiet_NaN());
  return trial;
}

CommandSeries two_sines(double duration, double amplitude) {
  CommandSeries commands;
  commands.series.channels = {{"motor", "N*m"}};
  commands.series.times = regular_times(static_cast<Eigen::Index>(100.0 * duration) + 1, 100.0);
  const Eigen::ArrayXd t = commands.series.times.array();
  commands.series.samples = amplitude * ((2.9 * t).sin() + 0.7 * (7.3 * t).sin()).matrix();
  return commands;
}

}  // namespace lacuna::analytic

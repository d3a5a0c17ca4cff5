#include "fitting/floor/disturbance.h"

#include "fitting/numerics/seeded_noise.h"
#include "foundation/address.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace lacuna {
namespace {

/// All moments at which one of the two series changes.
Eigen::VectorXd merged_times(const Eigen::VectorXd& commands, double step, double begin, double end) {
  std::vector<double> times(commands.data(), commands.data() + commands.size());
  for (Eigen::Index k = 0; begin + static_cast<double>(k) * step < end; ++k)
    times.push_back(begin + static_cast<double>(k) * step);
  std::sort(times.begin(), times.end());
  const double same = 1e-6 * step;
  times.erase(std::unique(times.begin(), times.end(), [&](double a, double b) { return b - a < same; }), times.end());
  return Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
}

/// A command at any time, according to its hold.
double command_at(const CommandSeries& commands, Eigen::Index channel, double time) {
  const Eigen::VectorXd& times = commands.series.times;
  const auto values = commands.series.samples.col(channel);
  const Eigen::Index after = std::upper_bound(times.data(), times.data() + times.size(), time) - times.data();
  if (after == 0) return commands.before_first(channel);
  if (after == times.size() || commands.hold == Hold::zero_order) return values(after - 1);
  const double share = (time - times(after - 1)) / (times(after) - times(after - 1));
  return values(after - 1) + share * (values(after) - values(after - 1));
}

/// Earlier commands, where any are known, extended by one channel of which none are known.
std::vector<double> with_another(std::vector<double> before) {
  if (!before.empty()) before.push_back(std::nan(""));
  return before;
}

/// One value a step.
std::vector<double> random_force(double deviation, std::size_t steps, double memory, SeededNoise& random) {
  std::vector<double> force(steps);
  double value = deviation * random.normal();
  for (double& one : force) {
    one = value;
    value = memory * value + std::sqrt(1.0 - memory * memory) * deviation * random.normal();
  }
  return force;
}

}  // namespace

std::vector<DisturbedJoint> disturbed_joints(const RobotSpec& robot, const NoiseSection& noise) {
  std::vector<double> deviations(robot.joints.size(), 0.0);
  for (const auto& [pattern, deviation] : noise.process) {
    const ElementMatch match = match_elements(robot, {pattern});
    if (match.kind != ElementKind::joint)
      throw Error("noise.process names \"" + pattern + "\", which is no joint; write for example \"joint.*\"");
    for (const int index : match.elements) deviations[static_cast<std::size_t>(index)] = deviation;
  }
  std::vector<DisturbedJoint> joints;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (!(deviations[i] > 0.0)) continue;
    const JointSpec& joint = robot.joints[i];
    if (joint.kind != JointKind::hinge && joint.kind != JointKind::slider)
      throw Error("noise.process names joint." + joint.name + ", but random forces act on hinges and sliders only");
    joints.push_back({joint.name, "random_force_" + joint.name, deviations[i]});
  }
  return joints;
}

std::unique_ptr<CompiledModel> compile_disturbed(const ModelDefinition& definition,
                                                 const std::vector<DisturbedJoint>& joints) {
  ModelStructure structure = definition.structure;
  for (const DisturbedJoint& disturbed : joints) {
    ActuatorSpec actuator;
    actuator.name = disturbed.actuator;
    actuator.joint = disturbed.joint;
    structure.robot.actuators.push_back(actuator);
  }
  return compile(structure, definition.engine);
}

CommandSeries with_command_noise(const CommandSeries& commands, std::span<const double> deviations, std::uint64_t seed,
                                 std::uint64_t draw) {
  CommandSeries noisy = commands;
  SeededNoise random(seed, draw);
  for (std::size_t channel = 0; channel < deviations.size(); ++channel) {
    if (!std::isfinite(deviations[channel])) continue;
    auto values = noisy.series.samples.col(static_cast<Eigen::Index>(channel));
    for (double& value : values) value += deviations[channel] * random.normal();
  }
  return noisy;
}

CommandSeries with_random_forces(const CommandSeries& commands, const std::vector<DisturbedJoint>& joints, double step,
                                 double correlation_time, double begin, double end, std::uint64_t seed,
                                 std::uint64_t draw) {
  CommandSeries disturbed;
  disturbed.hold = commands.hold;
  disturbed.before = commands.before;
  disturbed.may_be_off = commands.may_be_off;
  disturbed.series.times = merged_times(commands.series.times, step, begin, end);
  disturbed.series.channels = commands.series.channels;
  const auto recorded = static_cast<Eigen::Index>(commands.series.channels.size());
  const Eigen::VectorXd& times = disturbed.series.times;
  disturbed.series.samples.resize(times.size(), recorded + static_cast<Eigen::Index>(joints.size()));
  for (Eigen::Index channel = 0; channel < recorded; ++channel)
    for (Eigen::Index row = 0; row < times.size(); ++row)
      disturbed.series.samples(row, channel) = command_at(commands, channel, times(row));

  SeededNoise random(seed, draw);
  const double memory = correlation_time > 0.0 ? std::exp(-step / correlation_time) : 0.0;
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil((end - begin) / step)));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    disturbed.series.channels.push_back({joints[i].actuator, "N"});
    disturbed.before = with_another(std::move(disturbed.before));
    const std::vector<double> force = random_force(joints[i].deviation, steps, memory, random);
    for (Eigen::Index row = 0; row < times.size(); ++row) {
      const double which = std::floor((times(row) - begin) / step + 1e-6);
      disturbed.series.samples(row, recorded + static_cast<Eigen::Index>(i)) =
          force[static_cast<std::size_t>(std::clamp(which, 0.0, static_cast<double>(steps - 1)))];
    }
  }
  return disturbed;
}

CommandSeries with_force_pulses(const CommandSeries& commands, const DisturbedJoint& joint,
                                const std::vector<std::pair<double, double>>& intervals, double force) {
  const Eigen::VectorXd& known = commands.series.times;
  std::map<double, double> pulses;  // the force at the times at which it changes, or just before
  std::vector<double> times(known.data(), known.data() + known.size());
  for (const auto& [begin, end] : intervals) {
    const double just = 1e-6 * (end - begin);
    pulses.insert_or_assign(begin - just, 0.0);
    pulses.insert_or_assign(begin, force);
    pulses.insert_or_assign(end - just, force);
    pulses.insert_or_assign(end, 0.0);
  }
  for (const auto& [time, unused] : pulses) times.push_back(time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  CommandSeries pulsed;
  pulsed.hold = commands.hold;
  pulsed.before = with_another(commands.before);
  pulsed.may_be_off = commands.may_be_off;
  pulsed.series.channels = commands.series.channels;
  pulsed.series.channels.push_back({joint.actuator, "N"});
  const auto rows = static_cast<Eigen::Index>(times.size()), recorded = commands.series.samples.cols();
  pulsed.series.times = Eigen::Map<const Eigen::VectorXd>(times.data(), rows);
  pulsed.series.samples.resize(rows, recorded + 1);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const double time = times[static_cast<std::size_t>(row)];
    for (Eigen::Index channel = 0; channel < recorded; ++channel)
      pulsed.series.samples(row, channel) = command_at(commands, channel, time);
    const auto after = pulses.upper_bound(time);
    pulsed.series.samples(row, recorded) = after == pulses.begin() ? 0.0 : std::prev(after)->second;
  }
  return pulsed;
}

}  // namespace lacuna

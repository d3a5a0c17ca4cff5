#include "diagnosis/residual_force/joint_motion.h"

#include <algorithm>

namespace lacuna {
namespace {

double command_at(const Trial& trial, const std::string& actuator, double time) {
  const TimeSeries& series = trial.commands.series;
  for (std::size_t c = 0; c < series.channels.size(); ++c) {
    if (series.channels[c].name != actuator) continue;
    const double* begin = series.times.data();
    const Eigen::Index after = std::upper_bound(begin, begin + series.times.size(), time) - begin;
    return series.samples(std::max<Eigen::Index>(0, after - 1), static_cast<Eigen::Index>(c));
  }
  return 0.0;
}

const ActuatorSpec* actuator_of(const RobotSpec& robot, const std::string& joint) {
  for (const ActuatorSpec& one : robot.actuators)
    if (one.joint == joint) return &one;
  return nullptr;
}

std::string command_unit(const Trial& trial, const std::string& actuator) {
  for (const Channel& channel : trial.commands.series.channels)
    if (channel.name == actuator) return channel.unit;
  return "1";
}

Eigen::Index sample_near(const Eigen::VectorXd& times, const Stretch& stretch, double time) {
  const double* all = times.data();
  return std::clamp<Eigen::Index>(std::lower_bound(all + stretch.first, all + stretch.last, time) - all, stretch.first,
                                  stretch.last - 1);
}

/// Fills the motion of one joint, coordinate number `coordinate`.
void follow(JointMotion& motion, int coordinate, const std::string& actuator, const BaseSolution& base,
            const StartStates& states, const ForceResponses& forces) {
  for (std::size_t k = 0; k < base.segments.size(); ++k) {
    const Stretch& stretch = base.segments[k].stretch;
    const Trial& trial = base.trials[stretch.trial];
    const Eigen::VectorXd& pulses = forces.times[k];
    Eigen::VectorXd position(pulses.size()), velocity(pulses.size()), command(pulses.size());
    for (Eigen::Index p = 0; p < pulses.size(); ++p) {
      const Eigen::Index sample = sample_near(trial.measured.times, stretch, pulses(p));
      const StartEstimate at = states.from_samples(stretch, sample);
      position(p) = component(at.start, coordinate);
      velocity(p) = component(at.start, states.coordinates() + coordinate);
      command(p) = command_at(trial, actuator, pulses(p));
    }
    motion.position.push_back(std::move(position));
    motion.velocity.push_back(std::move(velocity));
    if (!actuator.empty()) motion.command.push_back(std::move(command));
  }
}

}  // namespace

std::vector<JointMotion> joint_motions(const BaseSolution& base, const RobotSpec& robot,
                                       const std::vector<Coordinate>& coordinates, const StartStates& states,
                                       const ForceResponses& forces) {
  std::vector<JointMotion> motions;
  for (std::size_t joint = 0; joint < forces.joints.size(); ++joint) {
    const std::string& name = forces.joints[joint];
    const auto coordinate = std::find_if(coordinates.begin(), coordinates.end(),
                                         [&](const Coordinate& one) { return one.name == "joint." + name; });
    if (coordinate == coordinates.end()) continue;
    JointMotion motion{name, joint, forces.units[joint] == "N" ? "m" : "rad", forces.units[joint], "", {}, {}, {}};
    const ActuatorSpec* actuator = actuator_of(robot, name);
    if (actuator) motion.command_unit = command_unit(base.trials.front(), actuator->name);
    follow(motion, static_cast<int>(coordinate - coordinates.begin()), actuator ? actuator->name : "", base, states,
           forces);
    motions.push_back(std::move(motion));
  }
  return motions;
}

}  // namespace lacuna

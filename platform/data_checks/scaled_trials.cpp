#include "data_checks/scaled_trials.h"

#include "foundation/address.h"

#include <algorithm>

namespace lacuna {

std::vector<JointReadings> joint_readings(const RobotSpec& robot) {
  std::vector<JointReadings> joints;
  for (const JointSpec& joint : robot.joints) {
    if (joint.kind != JointKind::hinge && joint.kind != JointKind::slider) continue;
    JointReadings readings{{}, joint.kind == JointKind::hinge};
    for (const SensorSpec& sensor : robot.sensors)
      if (sensor.element == joint.name &&
          (sensor.kind == SensorKind::joint_position || sensor.kind == SensorKind::joint_velocity))
        for (const Channel& channel : sensor_channels(robot, sensor)) readings.channels.push_back(channel.name);
    if (!readings.channels.empty()) joints.push_back(std::move(readings));
  }
  return joints;
}

std::vector<Trial> beginnings(const std::vector<Trial>& trials, Eigen::Index most) {
  std::vector<Trial> cut;
  for (const Trial& trial : trials)
    if (!trial.held_out) cut.push_back(trial);
  const Eigen::Index each = most / static_cast<Eigen::Index>(std::max<std::size_t>(cut.size(), 1));
  for (Trial& trial : cut) {
    const Eigen::Index rows = std::min(each, trial.measured.times.size());
    trial.measured.times.conservativeResize(rows);
    trial.measured.samples.conservativeResize(rows, Eigen::NoChange);
  }
  return cut;
}

std::vector<Trial> divided(std::vector<Trial> trials, const std::vector<std::string>& channels, double factor) {
  for (Trial& trial : trials)
    for (std::size_t c = 0; c < trial.measured.channels.size(); ++c) {
      if (std::find(channels.begin(), channels.end(), trial.measured.channels[c].name) == channels.end()) continue;
      trial.measured.samples.col(static_cast<Eigen::Index>(c)) /= factor;
      if (c < trial.sensor_noise.size()) trial.sensor_noise[c] /= factor;
    }
  return trials;
}

}  // namespace lacuna

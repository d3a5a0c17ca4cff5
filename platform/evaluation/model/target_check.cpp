#include "evaluation/model/target_check.h"

#include "foundation/address.h"

#include <algorithm>

namespace lacuna {
namespace {

/// Columns for channels that the robot does not have are reported by the measurement.
void check_columns(const std::string& section, const std::vector<ColumnMapping>& columns,
                   const std::vector<Channel>& channels, Complaints& complaints) {
  for (const ColumnMapping& column : columns) {
    const auto channel =
        std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == column.channel; });
    if (channel == channels.end()) continue;
    for (const char* key : {".offset", ".noise"}) complaints.check_unit(section + column.channel + key, channel->unit);
  }
}

void check_starts(const RobotSpec& robot, const std::string& key, Complaints& complaints) {
  for (const JointSpec& joint : robot.joints) {
    const std::string unit = joint.kind == JointKind::slider ? "m" : "rad";
    complaints.check_unit(key + joint.name + ".position", unit);
    complaints.check_unit(key + joint.name + ".velocity", unit + "/s");
  }
  for (const Channel& command : command_channels(robot))
    complaints.check_unit(key + command.name + ".command", command.unit);
}

void check_initial(const RobotSpec& robot, const RecordingSource& source, Complaints& complaints) {
  check_starts(robot, "target.initial.", complaints);
  for (const MeasuredFile& file : source.files)
    if (!file.initial.empty()) check_starts(robot, file.key + ".initial.", complaints);
  for (const Channel& command : command_channels(robot))
    complaints.check_unit("target.controllers." + command.name + ".limit", command.unit);
}

void check_process_noise(const RobotSpec& robot, const NoiseSection& noise, Complaints& complaints) {
  for (const auto& [pattern, deviation] : noise.process) {
    const std::string key = "noise.process." + pattern;
    try {
      const ElementMatch match = match_elements(robot, {pattern});
      if (match.kind != ElementKind::joint) {
        complaints.add(key, "a random force acts on joints, such as \"joint.hinge\"");
        continue;
      }
      for (const int joint : match.elements)
        complaints.check_unit(key,
                              robot.joints[static_cast<std::size_t>(joint)].kind == JointKind::slider ? "N" : "N*m");
    } catch (const Error& error) {
      complaints.add(key, error);
    }
  }
}

}  // namespace

void check_target(const RobotSpec& robot, const Experiment& experiment, Complaints& complaints) {
  const RecordingSource& source = experiment.target.recording;
  check_columns("target.sensors.", source.sensors, sensor_channels(robot), complaints);
  check_columns("target.commands.", source.commands, command_channels(robot), complaints);
  check_initial(robot, source, complaints);
  check_process_noise(robot, experiment.noise, complaints);
}

}  // namespace lacuna

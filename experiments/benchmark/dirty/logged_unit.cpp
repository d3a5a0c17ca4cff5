#include "dirty/logged_unit.h"

#include <algorithm>

namespace hidden_effects::dirty {
namespace {

LoggedUnit unit_of_position(const DirtyCase& made, int joint) {
  const bool slides = made.rig.stated.joints[static_cast<std::size_t>(joint)].slides;
  if (slides) return {made.recording.length_unit, made.recording.length_unit == "mm" ? 1000.0 : 1.0};
  return {made.recording.angle_unit, made.recording.angle_unit == "deg" ? 360.0 / kTurn : 1.0};
}

LoggedUnit unit_of_force(const DirtyCase& made, int joint) {
  return {made.rig.stated.joints[static_cast<std::size_t>(joint)].slides ? "N" : "N*m", 1.0};
}

}  // namespace

LoggedUnit unit_of_time(const Recording& recording) {
  return {recording.time_unit, recording.time_unit == "ms" ? 1000.0 : 1.0};
}

LoggedUnit unit_of_sensor(const DirtyCase& made, std::size_t sensor) {
  const PlantSensor& what = made.rig.stated.sensors[sensor];
  if (made.rig.driving == Driving::imposed && sensor == 1) return unit_of_force(made, what.joint);
  LoggedUnit unit = unit_of_position(made, what.joint);
  if (what.velocity) unit.name += "/s";
  return unit;
}

LoggedUnit unit_of_reference(const DirtyCase& made, std::size_t drive) {
  LoggedUnit unit = unit_of_position(made, made.rig.stated.drives[drive].joint);
  if (made.rig.driving == Driving::velocity_loop) unit.name += "/s";
  return unit;
}

LoggedUnit unit_of_command(const DirtyCase& made, std::size_t drive) {
  const PlantDrive& what = made.rig.stated.drives[drive];
  if (what.servo || made.rig.driving == Driving::imposed) return unit_of_position(made, what.joint);
  if (what.resistance > 0.0) return {"V", 1.0};
  if (made.recording.amperes > 0.0) return {"A", 1.0 / made.recording.amperes};
  return unit_of_force(made, what.joint);
}

std::string column_name(const std::string& channel, const LoggedUnit& unit) {
  std::string words = unit.name;
  std::erase(words, '*');
  std::replace(words.begin(), words.end(), '/', '_');
  return channel + "_" + words;
}

}  // namespace hidden_effects::dirty

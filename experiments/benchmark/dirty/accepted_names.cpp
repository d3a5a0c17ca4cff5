#include "dirty/dirty_kind.h"

#include <algorithm>

/// Which answers name what is really there.
namespace hidden_effects::dirty {
namespace {

std::string where_word(Place place) {
  switch (place) {
    case Place::joint: return "joint.";
    case Place::body: return "body.";
    case Place::drive: return "actuator.";
    case Place::sensor: return "sensor.";
    case Place::world: break;
  }
  return "world";
}

/// Where an effect of the library stands.
Place place_of_effect(const std::string& effect) {
  static const std::vector<std::string> drives = {
      "command_delay",     "command_offset", "actuator_lag", "torque_saturation", "torque_gain", "dead_zone",
      "torque_speed_line", "thermal_fade",   "supply_sag",   "joint_compliance",  "backlash",    "slew_rate_limit"};
  static const std::vector<std::string> bodies = {"payload", "quadratic_drag", "linear_drag", "buoyancy"};
  const auto is_in = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), effect) != names.end();
  };
  if (effect == "mount_tilt") return Place::world;
  if (is_in(drives)) return Place::drive;
  if (is_in(bodies)) return Place::body;
  return effect.starts_with("sensor_") || effect.starts_with("encoder_") ? Place::sensor : Place::joint;
}

std::vector<std::string> stand_ins(const RobotValue& value, double factor) {
  const bool more = factor > 1.0;
  std::vector<std::string> heavier = {"torque_gain"};
  if (more) heavier.insert(heavier.end(), {"payload", "armature"});
  switch (value.quantity) {
    case Quantity::mass: heavier.push_back(more ? "joint_spring" : "buoyancy"); return heavier;
    case Quantity::lever: heavier.push_back("joint_spring"); return heavier;
    case Quantity::inertia:
    case Quantity::armature: return heavier;
    case Quantity::damping:
      return more ? std::vector<std::string>{"viscous_friction", "linear_drag", "directional_viscous_friction",
                                             "torque_speed_line"}
                  : std::vector<std::string>{};
    case Quantity::stiffness: return {"joint_spring", "cubic_stiffness"};
    case Quantity::rest: return {"joint_offset_torque", "command_offset", "mount_tilt", "directional_friction"};
    case Quantity::gain:
    case Quantity::torque_constant: return {"torque_gain", "armature", "payload", "supply_sag"};
    case Quantity::kp: return {"torque_gain", "joint_spring"};
    case Quantity::kd: return {"viscous_friction", "torque_gain", "linear_drag"};
    case Quantity::scale: return {"sensor_scale", "torque_gain"};
  }
  return {};
}

}  // namespace

std::vector<std::string> accepted_at(const std::vector<std::string>& effects, const PlantSpec& spec, int joint) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& effect, Place place, const std::string& element) {
    names.push_back(effect + " @ " + where_word(place) + element);
  };
  for (const std::string& effect : effects) {
    const Place place = place_of_effect(effect);
    if (place == Place::world) names.push_back(effect + " @ world");
    if (place == Place::joint) add(effect, place, spec.joints[static_cast<std::size_t>(joint)].name);
    if (place == Place::body) add(effect, place, spec.bodies[static_cast<std::size_t>(joint)].name);
    if (place == Place::drive)
      for (const PlantDrive& drive : spec.drives)
        if (drive.joint == joint) add(effect, place, drive.name);
    if (place == Place::sensor)
      for (const PlantSensor& sensor : spec.sensors)
        if (sensor.joint == joint) add(effect, place, sensor.name);
  }
  return names;
}

std::vector<std::string> accepted_for(const RobotValue& value, double factor, const PlantSpec& spec) {
  std::vector<std::string> names = {"wrong_value @ " + value.address(spec)};
  const std::vector<std::string> effects = accepted_at(stand_ins(value, factor), spec, value.joint(spec));
  names.insert(names.end(), effects.begin(), effects.end());
  return names;
}

std::string place_text(const DirtyKind& kind, int element, const PlantSpec& spec) {
  const auto e = static_cast<std::size_t>(element);
  switch (kind.law.place) {
    case Place::joint: return "joint." + spec.joints[e].name;
    case Place::body: return "body." + spec.bodies[e].name;
    case Place::drive: return "actuator." + spec.drives[e].name;
    case Place::sensor: return "sensor." + spec.sensors[e].name;
    case Place::world: break;
  }
  return "world";
}

}  // namespace hidden_effects::dirty

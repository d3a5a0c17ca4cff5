#include "foundation/address.h"

#include "foundation/text/problem.h"
#include "foundation/text/counted.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kSmallest = 1e-12;  // of quantities that must be positive

constexpr bool kMayBeInfinite = true;  // "no limit", or rigid

constexpr std::string_view kOfEffects = "effect.";

/// Lists values under their addresses.
class Collector {
 public:
  explicit Collector(std::vector<AddressedValue>& values) : values_(values) {}
  void element(const char* kind, const std::string& name) {
    prefix_ = std::string(kind) + "." + name + (name.empty() ? "" : ".");
  }
  void add(const char* name, const std::string& unit, double& value, double lower = -kInfinity,
           double upper = kInfinity, bool may_be_infinite = false) {
    values_.push_back({prefix_ + name, unit, &value, lower, upper, may_be_infinite});
  }

 private:
  std::vector<AddressedValue>& values_;
  std::string prefix_;
};

/// Visits the values without building their names.
struct BoundsCheck {
  void element(const char*, const std::string&) {}
  void add(const char*, const std::string&, double value, double lower = -kInfinity, double upper = kInfinity,
           bool may_be_infinite = false) {
    inside = inside && value >= lower && value <= upper && (may_be_infinite || std::isfinite(value));
  }

  bool inside = true;
};

struct JointUnits {
  std::string position, force;
  std::string per_velocity() const { return position == "m" ? "N*s/m" : "N*m*s/rad"; }
  std::string per_position() const { return position == "m" ? "N/m" : "N*m/rad"; }
  std::string inertia() const { return position == "m" ? "kg" : "kg*m^2"; }
};

JointUnits units_of(JointKind kind) {
  return kind == JointKind::slider ? JointUnits{"m", "N"} : JointUnits{"rad", "N*m"};
}

std::string command_unit(ActuatorKind kind, const JointUnits& units) {
  if (kind == ActuatorKind::force) return units.force;
  if (kind == ActuatorKind::voltage) return "V";
  return kind == ActuatorKind::velocity_servo || kind == ActuatorKind::motion ? units.position + "/s" : units.position;
}

/// Gains of a servo that outputs a voltage are plain counts; a count of kp is worth `gain_unit`.
template <class Collector, class Actuator>
void collect_motor(Collector& collector, Actuator& actuator, const JointUnits& units) {
  const bool is_servo = actuator.kind == ActuatorKind::voltage_servo;
  if (!is_servo && actuator.kind != ActuatorKind::voltage) return;
  collector.add("motor.torque_constant", units.force + "/A", actuator.motor.torque_constant, 0.0);
  collector.add("motor.resistance", "Ohm", actuator.motor.resistance, kSmallest);
  collector.add("motor.back_emf", "1", actuator.motor.back_emf, 0.0);
  collector.add("motor.supply", "V", actuator.motor.supply, 0.0, kInfinity, kMayBeInfinite);
  collector.add("motor.duty_limit", "1", actuator.motor.duty_limit, 0.0);
  if (!is_servo) return;
  collector.add("motor.gain_unit", "1/" + units.position, actuator.motor.gain_unit, 0.0);
  collector.add("motor.sample_time", "s", actuator.motor.sample_time, 0.0);
}

template <class Collector, class Body>
void collect_body(Collector& collector, Body& body) {
  collector.add("mass", "kg", body.mass, kSmallest);
  collector.add("com.x", "m", body.com.x());
  collector.add("com.y", "m", body.com.y());
  collector.add("com.z", "m", body.com.z());
  collector.add("inertia.xx", "kg*m^2", body.inertia.xx, kSmallest);
  collector.add("inertia.yy", "kg*m^2", body.inertia.yy, kSmallest);
  collector.add("inertia.zz", "kg*m^2", body.inertia.zz, kSmallest);
  collector.add("inertia.xy", "kg*m^2", body.inertia.xy);
  collector.add("inertia.xz", "kg*m^2", body.inertia.xz);
  collector.add("inertia.yz", "kg*m^2", body.inertia.yz);
}

template <class Collector, class Joint>
void collect_joint(Collector& collector, Joint& joint) {
  const JointUnits units = units_of(joint.kind);
  collector.add("damping", units.per_velocity(), joint.damping, 0.0);
  collector.add("dry_friction", units.force, joint.dry_friction, 0.0);
  collector.add("stiffness", units.per_position(), joint.stiffness, 0.0);
  collector.add("rest", units.position, joint.rest);
  collector.add("armature", units.inertia(), joint.armature, 0.0);
  collector.add("force", units.force, joint.force);
  collector.add("lower", units.position, joint.lower, -kInfinity, kInfinity, kMayBeInfinite);
  collector.add("upper", units.position, joint.upper, -kInfinity, kInfinity, kMayBeInfinite);
}

template <class Collector, class Actuator>
void collect_actuator(Collector& collector, Actuator& actuator, const JointUnits& units) {
  const std::string command = command_unit(actuator.kind, units);
  collector.add("gain", "1", actuator.gain);
  collector.add("offset", command, actuator.offset);
  collector.add("delay", "s", actuator.delay, 0.0);
  const bool counts = actuator.kind == ActuatorKind::voltage_servo;
  collector.add("kp", counts ? "1" : units.per_position(), actuator.kp, 0.0);
  collector.add("ki", units.position == "m" ? "N/(m*s)" : "N*m/(rad*s)", actuator.ki, 0.0);
  collector.add("kd", counts ? "s" : units.per_velocity(), actuator.kd, 0.0);
  collector.add("force_limit", units.force, actuator.force_limit, 0.0, kInfinity, kMayBeInfinite);
  collector.add("command_lower", command, actuator.command_lower, -kInfinity, kInfinity, kMayBeInfinite);
  collector.add("command_upper", command, actuator.command_upper, -kInfinity, kInfinity, kMayBeInfinite);
  collector.add("transmission.ratio", "1", actuator.transmission.ratio);
  collector.add("transmission.rotor_inertia", units.inertia(), actuator.transmission.rotor_inertia, 0.0);
  collector.add("transmission.stiffness", units.per_position(), actuator.transmission.stiffness, kSmallest, kInfinity,
                kMayBeInfinite);
  collector.add("transmission.damping", units.per_velocity(), actuator.transmission.damping, 0.0);
  collector.add("transmission.gap", units.position, actuator.transmission.gap, 0.0);
  collect_motor(collector, actuator, units);
}

template <class Collector, class Sensor>
void collect_sensor(Collector& collector, Sensor& sensor, const std::string& unit) {
  collector.add("delay", "s", sensor.delay, 0.0);
  collector.add("scale", "1", sensor.scale);
  collector.add("offset", unit, sensor.offset);
  collector.add("noise", unit, sensor.noise, 0.0);
  collector.add("quantum", unit, sensor.quantum, 0.0);
  if (sensor.kind == SensorKind::accelerometer) {
    collector.add("at.x", "m", sensor.at.x());
    collector.add("at.y", "m", sensor.at.y());
    collector.add("at.z", "m", sensor.at.z());
  }
  if (sensor.kind != SensorKind::beacon_range) return;
  collector.add("beacon.x", "m", sensor.beacon.x());
  collector.add("beacon.y", "m", sensor.beacon.y());
  collector.add("beacon.z", "m", sensor.beacon.z());
}

/// Treated as a hinge where there is no joint of that name.
JointKind joint_kind(const RobotSpec& robot, const std::string& name) {
  const auto found =
      std::find_if(robot.joints.begin(), robot.joints.end(), [&](const JointSpec& j) { return j.name == name; });
  return found == robot.joints.end() ? JointKind::hinge : found->kind;
}

std::string channel_unit(const SensorSpec& sensor, JointKind joint) {
  const JointUnits units = units_of(joint);
  if (sensor.relative) return "1";
  switch (sensor.kind) {
    case SensorKind::joint_position: return units.position;
    case SensorKind::joint_velocity: return units.position + "/s";
    case SensorKind::joint_force:
    case SensorKind::drive_force: return units.force;
    case SensorKind::touch: return "1";
    case SensorKind::body_position: return "m";
    case SensorKind::body_velocity: return "m/s";
    case SensorKind::body_orientation: return "1";
    case SensorKind::body_angular_velocity: return "rad/s";
    case SensorKind::beacon_range: return "m";
    case SensorKind::contact_force: return "N";
    case SensorKind::link_angle: return "rad";
    case SensorKind::link_velocity: return "rad/s";
    case SensorKind::accelerometer: return "m/s^2";
  }
  return "1";
}

template <class Collector, class Robot>
void collect(Collector& collector, Robot& robot) {
  for (auto& body : robot.bodies) {
    collector.element("body", body.name);
    collect_body(collector, body);
  }
  for (auto& joint : robot.joints) {
    collector.element("joint", joint.name);
    collect_joint(collector, joint);
  }
  for (auto& actuator : robot.actuators) {
    collector.element("actuator", actuator.name);
    collect_actuator(collector, actuator, units_of(joint_kind(robot, actuator.joint)));
  }
  for (auto& sensor : robot.sensors) {
    collector.element("sensor", sensor.name);
    collect_sensor(collector, sensor, channel_unit(sensor, joint_kind(robot, sensor.element)));
  }
  for (auto& coupling : robot.couplings) {
    const JointUnits own = units_of(joint_kind(robot, coupling.joint)),
                     other = units_of(joint_kind(robot, coupling.follows));
    collector.element("coupling", coupling.name);
    collector.add("ratio", own.position == other.position ? "1" : own.position + "/" + other.position, coupling.ratio);
    collector.add("offset", own.position, coupling.offset);
  }
  collector.element("contact", {});
  collector.add("stiffness", "N/m", robot.contact.stiffness, kSmallest, kInfinity, kMayBeInfinite);
  collector.add("damping", "N*s/m", robot.contact.damping, 0.0);
  collector.add("friction", "1", robot.contact.friction, 0.0, kInfinity, kMayBeInfinite);
  collector.add("slope", "rad", robot.contact.slope, -1.5, 1.5);
  collector.element("world", {});
  collector.add("gravity.x", "m/s^2", robot.gravity.x());
  collector.add("gravity.y", "m/s^2", robot.gravity.y());
  collector.add("gravity.z", "m/s^2", robot.gravity.z());
}

struct NamedElement {
  ElementKind kind;
  int index;
  std::string address;
};

template <class Spec>
void name_elements(const std::vector<Spec>& specs, ElementKind kind, std::vector<NamedElement>& elements) {
  for (std::size_t i = 0; i < specs.size(); ++i)
    elements.push_back({kind, static_cast<int>(i), std::string(to_string(kind)) + "." + specs[i].name});
}

std::vector<NamedElement> named_elements(const RobotSpec& robot) {
  std::vector<NamedElement> elements;
  name_elements(robot.joints, ElementKind::joint, elements);
  name_elements(robot.bodies, ElementKind::body, elements);
  name_elements(robot.actuators, ElementKind::actuator, elements);
  name_elements(robot.sensors, ElementKind::sensor, elements);
  elements.push_back({ElementKind::world, 0, "world"});
  return elements;
}

std::string nothing_matches(const std::string& pattern, const std::vector<NamedElement>& elements) {
  std::vector<std::string> addresses;
  for (const NamedElement& element : elements) addresses.push_back(element.address);
  return "\"" + pattern + "\" matches nothing of the robot" + did_you_mean(pattern, addresses) + "; it has " +
         nearest_names(pattern, addresses) +
         (addresses.size() > kMostNearest ? "; lacuna check FILE lists its joints, actuators and sensors" : "");
}

}  // namespace

int coordinate_count(JointKind kind) {
  switch (kind) {
    case JointKind::hinge:
    case JointKind::slider: return 1;
    case JointKind::universal: return 2;
    case JointKind::ball: return 3;
    case JointKind::free: return 6;
    case JointKind::fixed: return 0;
  }
  return 0;
}

std::vector<Channel> sensor_channels(const RobotSpec& robot, const SensorSpec& sensor) {
  const JointKind joint = joint_kind(robot, sensor.element);
  const std::string unit = channel_unit(sensor, joint);
  std::vector<std::string> suffixes;
  switch (sensor.kind) {
    case SensorKind::body_position:
    case SensorKind::body_velocity:
    case SensorKind::body_angular_velocity:
    case SensorKind::accelerometer:
    case SensorKind::contact_force: suffixes = {".x", ".y", ".z"}; break;
    case SensorKind::body_orientation: suffixes = {".w", ".x", ".y", ".z"}; break;
    case SensorKind::joint_position:
    case SensorKind::joint_velocity:
    case SensorKind::joint_force:
      if (joint == JointKind::universal)
        suffixes = {".1", ".2"};
      else if (joint == JointKind::ball)
        suffixes = {".1", ".2", ".3"};
      else
        suffixes = {""};
      break;
    case SensorKind::drive_force:
    case SensorKind::link_angle:
    case SensorKind::link_velocity:
    case SensorKind::touch:
    case SensorKind::beacon_range: suffixes = {""}; break;
  }
  std::vector<Channel> channels;
  for (const std::string& suffix : suffixes) channels.push_back({sensor.name + suffix, unit});
  return channels;
}

std::vector<Channel> sensor_channels(const RobotSpec& robot) {
  std::vector<Channel> channels;
  for (const SensorSpec& sensor : robot.sensors)
    for (Channel& channel : sensor_channels(robot, sensor)) channels.push_back(std::move(channel));
  return channels;
}

Channel command_channel(const RobotSpec& robot, const ActuatorSpec& actuator) {
  const JointUnits units = units_of(joint_kind(robot, actuator.joint));
  return {actuator.name, actuator.relative ? "1" : command_unit(actuator.kind, units)};
}

std::vector<Channel> command_channels(const RobotSpec& robot) {
  std::vector<Channel> channels;
  for (const ActuatorSpec& actuator : robot.actuators) channels.push_back(command_channel(robot, actuator));
  return channels;
}

std::vector<AddressedValue> addressed_values(RobotSpec& robot) {
  std::vector<AddressedValue> values;
  Collector collector(values);
  collect(collector, robot);
  return values;
}

bool values_in_bounds(const RobotSpec& robot) {
  BoundsCheck check;
  collect(check, robot);
  return check.inside;
}

bool matches(std::string_view pattern, std::string_view address) {
  if (pattern.empty()) return address.empty();
  if (pattern.front() == '*') {
    for (std::size_t length = 0;; ++length) {
      if (matches(pattern.substr(1), address.substr(length))) return true;
      if (length == address.size() || address[length] == '.') return false;
    }
  }
  return !address.empty() && pattern.front() == address.front() && matches(pattern.substr(1), address.substr(1));
}

std::string effect_address(std::string_view id, std::string_view parameter) {
  return fmt::format("{}{}.{}", kOfEffects, id, parameter);
}

std::string address_in_setup(std::string_view address, std::string_view setup) {
  return std::string(address) + "@" + std::string(setup);
}

std::string_view without_setup(std::string_view address) { return address.substr(0, address.find('@')); }

bool is_of_effect(std::string_view address) { return address.starts_with(kOfEffects); }

bool is_of_effect(std::string_view address, std::string_view id) {
  return is_of_effect(address) && address.substr(kOfEffects.size()).starts_with(id) &&
         address.substr(kOfEffects.size() + id.size()).starts_with('.');
}

ElementMatch match_elements(const RobotSpec& robot, const std::vector<std::string>& patterns) {
  const std::vector<NamedElement> elements = named_elements(robot);
  ElementMatch match;
  bool first = true;
  for (const std::string& pattern : patterns) {
    bool found = false;
    for (const NamedElement& element : elements) {
      if (!matches(pattern, element.address)) continue;
      if (!first && element.kind != match.kind)
        throw Error("\"" + pattern + "\" names " + with_article(std::string(to_string(element.kind))) + " beside " +
                    with_article(std::string(to_string(match.kind))) + "; an effect needs elements of one kind");
      match.kind = element.kind;
      first = false;
      found = true;
      if (element.kind != ElementKind::world) match.elements.push_back(element.index);
    }
    if (!found) throw Error(nothing_matches(pattern, elements));
  }
  std::sort(match.elements.begin(), match.elements.end());
  match.elements.erase(std::unique(match.elements.begin(), match.elements.end()), match.elements.end());
  return match;
}

std::string_view to_string(ElementKind kind) {
  switch (kind) {
    case ElementKind::joint: return "joint";
    case ElementKind::body: return "body";
    case ElementKind::actuator: return "actuator";
    case ElementKind::sensor: return "sensor";
    case ElementKind::world: return "world";
  }
  return "world";
}

}  // namespace lacuna

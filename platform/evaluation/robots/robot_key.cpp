#include "evaluation/robots/robot_key.h"

#include <optional>
#include <vector>

namespace lacuna {
namespace {

void append(std::string& key, const double* values, std::size_t count) {
  key.append(reinterpret_cast<const char*>(values), count * sizeof(double));
}

void append(std::string& key, double value) { append(key, &value, 1); }
void append(std::string& key, const Eigen::Vector3d& value) { append(key, value.data(), 3); }
void append(std::string& key, const Eigen::Quaterniond& value) { append(key, value.coeffs().data(), 4); }

void append(std::string& key, const std::string& name) {
  append(key, static_cast<double>(name.size()));
  key += name;
}

void append(std::string& key, const BodySpec& body) {
  append(key, body.mass);
  append(key, body.com);
  for (const double moment :
       {body.inertia.xx, body.inertia.yy, body.inertia.zz, body.inertia.xy, body.inertia.xz, body.inertia.yz})
    append(key, moment);
  append(key, body.position);
  append(key, body.orientation);
  append(key, body.inertia_scales_with_mass ? 1.0 : 0.0);
  append(key, static_cast<double>(body.shapes.size()));
  for (const ShapeSpec& shape : body.shapes) {
    append(key, static_cast<double>(shape.kind));
    append(key, shape.size);
    append(key, shape.position);
    append(key, shape.orientation);
  }
}

void append(std::string& key, const JointSpec& joint) {
  append(key, static_cast<double>(joint.kind));
  append(key, joint.parent);
  append(key, joint.child);
  append(key, joint.anchor);
  append(key, joint.axis);
  append(key, joint.axis2);
  for (const double law : {joint.lower, joint.upper, joint.damping, joint.dry_friction, joint.stiffness, joint.rest,
                           joint.armature, joint.force})
    append(key, law);
}

void append(std::string& key, const ActuatorSpec& actuator) {
  const TransmissionSpec& transmission = actuator.transmission;
  const MotorSpec& motor = actuator.motor;
  append(key, static_cast<double>(actuator.kind));
  append(key, actuator.joint);
  for (const double law : {actuator.gain,
                           actuator.offset,
                           actuator.delay,
                           actuator.kp,
                           actuator.ki,
                           actuator.kd,
                           actuator.force_limit,
                           actuator.command_lower,
                           actuator.command_upper,
                           actuator.supply_sag,
                           transmission.ratio,
                           transmission.rotor_inertia,
                           transmission.stiffness,
                           transmission.damping,
                           transmission.gap,
                           motor.torque_constant,
                           motor.resistance,
                           motor.back_emf,
                           motor.supply,
                           motor.duty_limit,
                           motor.gain_unit,
                           motor.sample_time})
    append(key, law);
}

void append(std::string& key, const SensorSpec& sensor) {
  for (const double stage : {sensor.delay, sensor.scale, sensor.offset, sensor.noise, sensor.quantum})
    append(key, stage);
  append(key, static_cast<double>(sensor.kind));
  append(key, sensor.element);
  append(key, sensor.beacon);
  append(key, sensor.at);
}

void append(std::string& key, const ContactSpec& contact) {
  for (const double law :
       {contact.ground ? 1.0 : 0.0, contact.stiffness, contact.damping, contact.friction, contact.slope,
        contact.impact_damping, contact.restitution, contact.rolling_lever, contact.creep})
    append(key, law);
}

constexpr bool same_kind(const BodySpec&, const BodySpec&) { return true; }
template <class Element>
bool same_kind(const Element& built, const Element& expected) {
  return built.kind == expected.kind;
}

template <class Element>
std::string misfit_of(const std::vector<Element>& built, const std::vector<Element>& expected, const char* kind) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string& name = expected[i].name;
    if (i == built.size()) return std::string("has no ") + kind + " \"" + name + "\"";
    if (built[i].name != name)
      return std::string("has the ") + kind + " \"" + built[i].name + "\" where \"" + name + "\" should be";
    if (!same_kind(built[i], expected[i])) return std::string("has the ") + kind + " \"" + name + "\" of another kind";
  }
  if (built.size() > expected.size())
    return std::string("has a ") + kind + " \"" + built[expected.size()].name + "\" too many";
  return {};
}

bool reads_joint(SensorKind kind) {
  return kind == SensorKind::joint_position || kind == SensorKind::joint_velocity || kind == SensorKind::joint_force ||
         kind == SensorKind::drive_force || kind == SensorKind::link_angle || kind == SensorKind::link_velocity;
}

std::optional<JointKind> kind_of_joint(const RobotSpec& robot, const std::string& name) {
  for (const JointSpec& joint : robot.joints)
    if (joint.name == name) return joint.kind;
  return std::nullopt;
}

/// Channels and units of sensors and actuators on joints depend on the kind of joint. Both robots have the same number
/// of them.
std::string misplaced(const RobotSpec& built, const RobotSpec& expected) {
  const auto differ = [&](const std::string& one, const std::string& other) {
    return kind_of_joint(built, one) != kind_of_joint(expected, other);
  };
  for (std::size_t i = 0; i < built.sensors.size(); ++i)
    if (reads_joint(built.sensors[i].kind) && differ(built.sensors[i].element, expected.sensors[i].element))
      return "has the sensor \"" + built.sensors[i].name + "\" on a joint of another kind";
  for (std::size_t i = 0; i < built.actuators.size(); ++i)
    if (differ(built.actuators[i].joint, expected.actuators[i].joint))
      return "has the actuator \"" + built.actuators[i].name + "\" on a joint of another kind";
  return {};
}

}  // namespace

void append_key(const RobotSpec& robot, std::string& key) {
  for (const BodySpec& body : robot.bodies) append(key, body);
  for (const JointSpec& joint : robot.joints) append(key, joint);
  for (const ActuatorSpec& actuator : robot.actuators) append(key, actuator);
  for (const SensorSpec& sensor : robot.sensors) append(key, sensor);
  for (const CouplingSpec& coupling : robot.couplings) {
    append(key, coupling.joint);
    append(key, coupling.follows);
    append(key, coupling.ratio);
    append(key, coupling.offset);
  }
  append(key, robot.contact);
  append(key, robot.gravity);
}

std::string misfit(const RobotSpec& built, const RobotSpec& of_experiment) {
  for (const std::string& complaint :
       {misfit_of(built.bodies, of_experiment.bodies, "body"), misfit_of(built.joints, of_experiment.joints, "joint"),
        misfit_of(built.actuators, of_experiment.actuators, "actuator"),
        misfit_of(built.sensors, of_experiment.sensors, "sensor")})
    if (!complaint.empty()) return complaint;
  return misplaced(built, of_experiment);
}

}  // namespace lacuna

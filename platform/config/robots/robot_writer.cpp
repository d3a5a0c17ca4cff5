#include "config/robots/robot_writer.h"

#include "config/toml/toml_node.h"

#include <fmt/format.h>

#include <cmath>

namespace lacuna {
namespace {

std::string vector_toml(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", toml_number(v.x()), toml_number(v.y()), toml_number(v.z()));
}

/// Without the rounding error of the conversion, so that reading and writing again gives the same text.
double whole_angle(double angle) {
  constexpr double kPerRadian = 1e15;
  return std::round(angle * kPerRadian) / kPerRadian + 0.0;
}

/// Roll, pitch, yaw of which `orientation_from_rpy` makes the turn.
Eigen::Vector3d rpy_of(const Eigen::Quaterniond& turn) {
  const Eigen::Matrix3d r = turn.normalized().toRotationMatrix();
  const double across = std::hypot(r(0, 0), r(1, 0)), pitch = whole_angle(std::atan2(-r(2, 0), across));
  constexpr double kUpright = 1e-9;  // yaw and roll turn about one axis
  if (across < kUpright) return {whole_angle(std::atan2(-r(1, 2), r(1, 1))), pitch, 0.0};
  return {whole_angle(std::atan2(r(2, 1), r(2, 2))), pitch, whole_angle(std::atan2(r(1, 0), r(0, 0)))};
}

/// The lines of a section; what has its default value is not written.
class SectionText {
 public:
  SectionText(const std::string& kind, const std::string& name) : text_("\n[" + kind + "." + toml_key(name) + "]\n") {}

  void text(const char* key, const std::string& value) { line(key, toml_text(value)); }
  void number(const char* key, double value, double otherwise) {
    if (value != otherwise) line(key, toml_number(value));
  }
  void vector(const char* key, const Eigen::Vector3d& value) { line(key, vector_toml(value)); }
  void flag(const char* key, bool value, bool otherwise) {
    if (value != otherwise) line(key, value ? "true" : "false");
  }
  void line(const char* key, const std::string& value) { text_ += fmt::format("{} = {}\n", key, value); }
  const std::string& all() const { return text_; }

 private:
  std::string text_;
};

const char* word_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::box: return "box";
    case ShapeKind::sphere: return "sphere";
    case ShapeKind::capsule: return "capsule";
    case ShapeKind::cylinder: return "cylinder";
  }
  return "";
}

const char* word_of(JointKind kind) {
  switch (kind) {
    case JointKind::hinge: return "hinge";
    case JointKind::slider: return "slider";
    case JointKind::fixed: return "fixed";
    case JointKind::ball: return "ball";
    case JointKind::universal: return "universal";
    case JointKind::free: return "free";
  }
  return "";
}

const char* word_of(ActuatorKind kind) {
  switch (kind) {
    case ActuatorKind::force: return "force";
    case ActuatorKind::velocity_servo: return "velocity_servo";
    case ActuatorKind::position_servo: return "position_servo";
    case ActuatorKind::pid: return "pid";
    case ActuatorKind::voltage: return "voltage";
    case ActuatorKind::voltage_servo: return "voltage_servo";
    case ActuatorKind::motion: return "motion";
  }
  return "";
}

const char* word_of(SensorKind kind) {
  switch (kind) {
    case SensorKind::joint_position: return "joint_position";
    case SensorKind::joint_velocity: return "joint_velocity";
    case SensorKind::joint_force: return "joint_force";
    case SensorKind::touch: return "touch";
    case SensorKind::body_position: return "body_position";
    case SensorKind::body_velocity: return "body_velocity";
    case SensorKind::body_orientation: return "body_orientation";
    case SensorKind::body_angular_velocity: return "body_angular_velocity";
    case SensorKind::beacon_range: return "beacon_range";
    case SensorKind::contact_force: return "contact_force";
    case SensorKind::drive_force: return "drive_force";
    case SensorKind::link_angle: return "link_angle";
    case SensorKind::link_velocity: return "link_velocity";
    case SensorKind::accelerometer: return "accelerometer";
  }
  return "";
}

std::string shape_text(const ShapeSpec& shape) {
  std::string text = fmt::format("{{ kind = \"{}\", ", word_of(shape.kind));
  if (shape.kind == ShapeKind::box)
    text += "size = " + vector_toml(shape.size);
  else
    text += "radius = " + toml_number(shape.size.x());
  if (shape.kind == ShapeKind::capsule || shape.kind == ShapeKind::cylinder)
    text += ", length = " + toml_number(shape.size.y());
  return fmt::format("{}, at = {}, rpy = {} }}", text, vector_toml(shape.position),
                     vector_toml(rpy_of(shape.orientation)));
}

std::string body_text(const BodySpec& body) {
  SectionText section("body", body.name);
  section.line("mass", toml_number(body.mass));
  section.vector("com", body.com);
  section.line("inertia", inertia_toml(body.inertia));
  section.flag("inertia_scales_with_mass", body.inertia_scales_with_mass, true);
  section.vector("at", body.position);
  if (body.orientation.vec().norm() > 0.0) section.vector("rpy", rpy_of(body.orientation));
  std::string shapes;
  for (const ShapeSpec& shape : body.shapes) shapes += (shapes.empty() ? "" : ",\n          ") + shape_text(shape);
  if (!shapes.empty()) section.line("shapes", "[" + shapes + "]");
  return section.all();
}

std::string joint_text(const JointSpec& joint) {
  SectionText section("joint", joint.name);
  section.text("kind", word_of(joint.kind));
  section.text("parent", joint.parent);
  section.text("child", joint.child);
  section.vector("anchor", joint.anchor);
  if (joint.kind != JointKind::free) section.vector("axis", joint.axis);
  if (joint.kind == JointKind::universal) section.vector("axis2", joint.axis2);
  section.number("lower", joint.lower, -kInfinity);
  section.number("upper", joint.upper, kInfinity);
  section.number("damping", joint.damping, 0.0);
  section.number("dry_friction", joint.dry_friction, 0.0);
  section.number("stiffness", joint.stiffness, 0.0);
  section.number("rest", joint.rest, 0.0);
  section.number("armature", joint.armature, 0.0);
  section.number("force", joint.force, 0.0);
  return section.all();
}

void add_motor(const MotorSpec& motor, SectionText& section) {
  const MotorSpec usual;
  section.number("motor.torque_constant", motor.torque_constant, usual.torque_constant);
  section.number("motor.resistance", motor.resistance, usual.resistance);
  section.number("motor.back_emf", motor.back_emf, usual.back_emf);
  section.number("motor.supply", motor.supply, usual.supply);
  section.number("motor.duty_limit", motor.duty_limit, usual.duty_limit);
  section.number("motor.gain_unit", motor.gain_unit, usual.gain_unit);
  section.number("motor.sample_time", motor.sample_time, usual.sample_time);
}

std::string actuator_text(const ActuatorSpec& actuator) {
  const ActuatorSpec usual;
  SectionText section("actuator", actuator.name);
  section.text("joint", actuator.joint);
  section.text("kind", word_of(actuator.kind));
  section.number("gain", actuator.gain, usual.gain);
  section.flag("relative", actuator.relative, usual.relative);
  section.number("offset", actuator.offset, usual.offset);
  section.number("delay", actuator.delay, usual.delay);
  section.number("kp", actuator.kp, usual.kp);
  section.number("ki", actuator.ki, usual.ki);
  section.number("kd", actuator.kd, usual.kd);
  section.number("force_limit", actuator.force_limit, usual.force_limit);
  section.number("command_lower", actuator.command_lower, usual.command_lower);
  section.number("command_upper", actuator.command_upper, usual.command_upper);
  const TransmissionSpec& drive = actuator.transmission;
  section.number("transmission.ratio", drive.ratio, usual.transmission.ratio);
  section.number("transmission.rotor_inertia", drive.rotor_inertia, usual.transmission.rotor_inertia);
  section.number("transmission.stiffness", drive.stiffness, usual.transmission.stiffness);
  section.number("transmission.damping", drive.damping, usual.transmission.damping);
  section.number("transmission.gap", drive.gap, usual.transmission.gap);
  add_motor(actuator.motor, section);
  return section.all();
}

bool is_of_joint(SensorKind kind) {
  return kind == SensorKind::joint_position || kind == SensorKind::joint_velocity || kind == SensorKind::joint_force ||
         kind == SensorKind::drive_force || kind == SensorKind::link_angle || kind == SensorKind::link_velocity;
}

std::string sensor_text(const SensorSpec& sensor) {
  SectionText section("sensor", sensor.name);
  section.text("kind", word_of(sensor.kind));
  section.text(is_of_joint(sensor.kind) ? "joint" : "body", sensor.element);
  if (sensor.kind == SensorKind::beacon_range) section.vector("beacon", sensor.beacon);
  if (sensor.kind == SensorKind::accelerometer) section.vector("at", sensor.at);
  section.number("delay", sensor.delay, 0.0);
  section.number("scale", sensor.scale, 1.0);
  section.flag("relative", sensor.relative, false);
  section.number("offset", sensor.offset, 0.0);
  section.number("noise", sensor.noise, 0.0);
  section.number("quantum", sensor.quantum, 0.0);
  return section.all();
}

std::string coupling_text(const CouplingSpec& coupling) {
  SectionText section("coupling", coupling.name);
  section.text("joint", coupling.joint);
  section.text("follows", coupling.follows);
  section.number("ratio", coupling.ratio, 1.0);
  section.number("offset", coupling.offset, 0.0);
  return section.all();
}

std::string contact_text(const ContactSpec& contact) {
  std::string text = "\n[contact]\n";
  const auto number = [&](const char* key, double value, double otherwise) {
    if (value != otherwise) text += fmt::format("{} = {}\n", key, toml_number(value));
  };
  text += fmt::format("ground = {}\n", contact.ground);
  number("stiffness", contact.stiffness, kInfinity);
  number("damping", contact.damping, 0.0);
  number("friction", contact.friction, kInfinity);
  number("slope", contact.slope, 0.0);
  return text;
}

}  // namespace

std::string inertia_toml(const InertiaSpec& inertia) {
  return fmt::format("{{ xx = {}, yy = {}, zz = {}, xy = {}, xz = {}, yz = {} }}", toml_number(inertia.xx),
                     toml_number(inertia.yy), toml_number(inertia.zz), toml_number(inertia.xy), toml_number(inertia.xz),
                     toml_number(inertia.yz));
}

std::string robot_toml(const RobotSpec& robot, const std::string& comment) {
  std::string text = toml_comment(comment);
  text += fmt::format("{}[robot]\nname = {}\n", text.empty() ? "" : "\n", toml_text(robot.name));
  text += fmt::format("\n[world]\ngravity = {}\n", vector_toml(robot.gravity));
  for (const BodySpec& body : robot.bodies) text += body_text(body);
  for (const JointSpec& joint : robot.joints) text += joint_text(joint);
  for (const ActuatorSpec& actuator : robot.actuators) text += actuator_text(actuator);
  for (const CouplingSpec& coupling : robot.couplings) text += coupling_text(coupling);
  for (const SensorSpec& sensor : robot.sensors) text += sensor_text(sensor);
  return text + contact_text(robot.contact);
}

}  // namespace lacuna

#include "config/robots/robot_checks.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kRightAngle = 1e-6;  // largest cosine between a universal joint's axes

class RobotChecker {
 public:
  RobotChecker(const RobotInFile& file, const Locations& locations, Reading& reading)
      : file_(file), locations_(locations), reading_(reading) {
    for (const BodyInFile& body : file.bodies) bodies_.push_back(body.spec.name);
    for (const JointInFile& joint : file.joints) joints_.push_back(joint.spec.name);
  }

  void check() {
    if (file_.bodies.empty() && !reading_.is_troubled("")) problem("body", "a robot needs at least one body");
    for (const std::string& name : bodies_) check_name("body", name);
    for (const JointInFile& joint : file_.joints)
      if (is_sound("joint", joint.spec.name)) check_joint(joint);
    check_forest();
    for (const ActuatorSpec& actuator : file_.actuators)
      if (is_sound("actuator", actuator.name)) check_actuator(actuator);
    for (const CouplingSpec& coupling : file_.couplings)
      if (is_sound("coupling", coupling.name)) check_coupling(coupling);
    for (const SensorInFile& sensor : file_.sensors)
      if (is_sound("sensor", sensor.spec.name)) check_sensor(sensor);
  }

 private:
  void problem(const std::string& key, const std::string& message) {
    reading_.problem_at(key, nearest_location(locations_, key, ""), message);
  }

  bool is_sound(const std::string& kind, const std::string& name) const {
    return !reading_.is_troubled(kind + "." + name);
  }

  void check_name(const std::string& kind, const std::string& name) {
    if (!is_element_name(name)) problem(kind, toml_text(name) + " is not a valid name; use letters, digits, _ and -");
    if (kind == "body" && name == kWorld)
      problem("body.world", "\"world\" is the robot's surroundings; choose another name");
  }

  void expect_name(const std::string& key, const std::string& what, const std::string& name,
                   const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    std::string known;
    for (const std::string& candidate : names) known += (known.empty() ? "; known: " : ", ") + candidate;
    problem(key, "there is no " + what + " " + toml_text(name) + did_you_mean(name, names) + known);
  }

  void check_joint(const JointInFile& joint) {
    const JointSpec& spec = joint.spec;
    const std::string path = "joint." + spec.name;
    check_name("joint", spec.name);
    if (spec.parent != kWorld) expect_name(path + ".parent", "body", spec.parent, bodies_);
    expect_name(path + ".child", "body", spec.child, bodies_);
    if (!(spec.lower < spec.upper)) problem(path + ".lower", "the lower stop must be below the upper one");
    if (spec.kind == JointKind::free && spec.parent != kWorld)
      problem(path + ".parent", "a free joint has no parent, because its body floats in the world; leave parent out");
    const bool universal = spec.kind == JointKind::universal;
    if (joint.axis2 && !universal) problem(path + ".axis2", "only a universal joint has a second axis");
    if (!joint.axis2 && universal) problem(path + ".axis2", "is missing: a universal joint has two axes");
    if (joint.axis2 && universal && std::abs(joint.axis2->dot(spec.axis)) > kRightAngle)
      problem(path + ".axis2", "must be at right angles to axis");
  }

  /// Each body is the child of at most one joint, and going from child to parent ends at the world or at a floating
  /// body.
  void check_forest() {
    std::map<std::string, const JointSpec*> joint_of;
    for (const JointInFile& joint : file_.joints) {
      if (!is_sound("joint", joint.spec.name)) continue;
      const auto [entry, is_new] = joint_of.emplace(joint.spec.child, &joint.spec);
      if (!is_new)
        problem("joint." + joint.spec.name + ".child", toml_text(joint.spec.child) + " is already the child of joint." +
                                                           entry->second->name +
                                                           "; a body can be the child of only one joint");
    }
    for (const auto& [child, joint] : joint_of)
      if (is_in_loop(*joint, joint_of))
        problem("joint." + joint->name + ".parent", "the joints form a loop; a robot must be a tree of bodies");
  }

  bool is_in_loop(const JointSpec& start, const std::map<std::string, const JointSpec*>& joint_of) const {
    std::string body = start.parent;
    for (std::size_t i = 0; i <= file_.joints.size(); ++i) {
      if (body == start.child) return true;
      const auto above = joint_of.find(body);
      if (above == joint_of.end()) return false;
      body = above->second->parent;
    }
    return false;
  }

  void check_actuator(const ActuatorSpec& actuator) {
    const std::string path = "actuator." + actuator.name;
    check_name("actuator", actuator.name);
    expect_name(path + ".joint", "joint", actuator.joint, joints_);
    const JointSpec* joint = find_joint(actuator.joint);
    if (joint && (joint->kind == JointKind::fixed || joint->kind == JointKind::ball || joint->kind == JointKind::free))
      problem(path + ".joint", "an actuator drives a hinge, a slider or the first axis of a universal joint, and " +
                                   actuator.joint + " is none of these");
    if (!(actuator.command_lower < actuator.command_upper))
      problem(path + ".command_lower", "the lower bound must be below the upper one");
    if (actuator.transmission.ratio == 0.0) problem(path + ".transmission.ratio", "must not be 0");
    check_gains(actuator, path);
  }

  void check_gains(const ActuatorSpec& actuator, const std::string& path) {
    const bool by_position = actuator.kind == ActuatorKind::position_servo || actuator.kind == ActuatorKind::pid ||
                             actuator.kind == ActuatorKind::voltage_servo;
    const bool has_no_gains = actuator.kind == ActuatorKind::force || actuator.kind == ActuatorKind::voltage ||
                              actuator.kind == ActuatorKind::motion;
    if (by_position && actuator.kp == 0.0 && actuator.ki == 0.0)
      problem(path + ".kp", "is missing: without it a servo of this kind exerts no force");
    if (actuator.kind == ActuatorKind::velocity_servo && actuator.kd == 0.0)
      problem(path + ".kd", "is missing: without it a velocity servo exerts no force");
    if (!by_position && actuator.kp != 0.0)
      problem(path + ".kp", "is not used by an actuator of this kind; leave it out");
    if (actuator.kind != ActuatorKind::pid && actuator.ki != 0.0)
      problem(path + ".ki", "is not used by an actuator of this kind, only by a pid; leave it out");
    if (has_no_gains && actuator.kd != 0.0)
      problem(path + ".kd", "is not used by an actuator of this kind; leave it out");
    check_motor(actuator, path);
  }

  void check_motor(const ActuatorSpec& actuator, const std::string& path) {
    const bool is_servo = actuator.kind == ActuatorKind::voltage_servo;
    if (!is_servo && actuator.kind != ActuatorKind::voltage) {
      if (locations_.count(path + ".motor") > 0)
        problem(path + ".motor",
                "is not used by an actuator of this kind; write kind = \"voltage_servo\" (its command is a position) "
                "or \"voltage\"");
      return;
    }
    if (actuator.motor.torque_constant == 0.0)
      problem(path + ".motor.torque_constant", "is missing: the torque at the joint per current");
    if (locations_.count(path + ".motor.resistance") == 0)
      problem(path + ".motor.resistance", "is missing: the resistance of the winding and its driver");
    if (!is_servo && actuator.motor.sample_time > 0.0)
      problem(path + ".motor.sample_time", "is not used by a motor without a servo; write kind = \"voltage_servo\"");
    if (is_servo && !std::isfinite(actuator.motor.supply))
      problem(path + ".motor.supply", "is missing: the supply voltage of the servo");
  }

  void check_coupling(const CouplingSpec& coupling) {
    const std::string path = "coupling." + coupling.name;
    check_name("coupling", coupling.name);
    for (const auto& [key, name] : {std::pair(".joint", &coupling.joint), std::pair(".follows", &coupling.follows)}) {
      expect_name(path + key, "joint", *name, joints_);
      const JointSpec* joint = find_joint(*name);
      if (joint && joint->kind != JointKind::hinge && joint->kind != JointKind::slider)
        problem(path + key, *name + " is neither a hinge nor a slider");
    }
    if (coupling.joint == coupling.follows)
      problem(path + ".follows", "a joint cannot follow itself; name another joint");
    for (const CouplingSpec& other : file_.couplings) {
      if (&other != &coupling && other.joint == coupling.joint)
        problem(path + ".joint", coupling.joint + " follows another joint already, in coupling." + other.name);
      if (other.joint == coupling.follows)
        problem(path + ".follows", coupling.follows + " follows " + other.follows + " itself; follow that one");
    }
  }

  void check_sensor(const SensorInFile& sensor) {
    const std::string path = "sensor." + sensor.spec.name;
    check_name("sensor", sensor.spec.name);
    const bool of_joint = sensor.spec.kind == SensorKind::joint_position ||
                          sensor.spec.kind == SensorKind::joint_velocity ||
                          sensor.spec.kind == SensorKind::joint_force || sensor.spec.kind == SensorKind::drive_force ||
                          sensor.spec.kind == SensorKind::link_angle || sensor.spec.kind == SensorKind::link_velocity;
    const std::string wanted = of_joint ? "joint" : "body";
    const std::string& name = of_joint ? sensor.joint : sensor.body;
    const std::string& other = of_joint ? sensor.body : sensor.joint;
    if (!other.empty())
      problem(path + "." + (of_joint ? "body" : "joint"),
              "a sensor of this kind is on a " + wanted + "; write " + wanted);
    if (name.empty())
      problem(path + "." + wanted, "is missing: the " + wanted + " of this sensor");
    else
      expect_name(path + "." + wanted, wanted, name, of_joint ? joints_ : bodies_);
    const JointSpec* joint = of_joint ? find_joint(name) : nullptr;
    if (joint && joint->kind == JointKind::fixed)
      problem(path + ".joint", name + " is a fixed joint, which has no motion to measure");
    if (joint && joint->kind == JointKind::free)
      problem(path + ".joint", name +
                                   " is a free joint; sensors of its body read how it moves (body_position, "
                                   "body_orientation, body_velocity, body_angular_velocity)");
    if (sensor.spec.kind != SensorKind::accelerometer && locations_.contains(path + ".at"))
      problem(path + ".at", "only an accelerometer has a position on its body");
    if (sensor.spec.kind == SensorKind::beacon_range && !locations_.contains(path + ".beacon"))
      problem(path + ".beacon", "is missing: the point from which the distance is measured, [x, y, z] in m");
  }

  const JointSpec* find_joint(const std::string& name) const {
    for (const JointInFile& joint : file_.joints)
      if (joint.spec.name == name) return &joint.spec;
    return nullptr;
  }

  const RobotInFile& file_;
  const Locations& locations_;
  Reading& reading_;
  std::vector<std::string> bodies_;
  std::vector<std::string> joints_;
};

}  // namespace

void check_robot(const RobotInFile& file, const Locations& locations, Reading& reading) {
  RobotChecker(file, locations, reading).check();
}

}  // namespace lacuna

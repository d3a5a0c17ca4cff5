#include "mjcf_robot.h"

#include "mjcf_actuators.h"
#include "mjcf_couplings.h"
#include "mjcf_sensors.h"

#include "inertia_repair.h"

#include <algorithm>
#include <set>

namespace lacuna::mjcf {
namespace {

using robot_files::body_of;
using robot_files::joined;
using robot_files::moved;
using robot_files::RigidMass;

constexpr double kLeastMass = 1e-3;       ///< kg, of a body that moves but has no mass
constexpr double kNextToNothing = 1e-11;  ///< of the mass of a body, for bodies between its joints
constexpr double kSmallest = 1e-12;       ///< kg

bool is_free(const Body& body) { return !body.joints.empty() && body.joints.front().kind == JointKind::free; }

/// Frees or fixes the bodies in the world, as the user asks.
void set_base(File& file, RobotBase base) {
  const bool any_free = std::any_of(file.bodies.begin(), file.bodies.end(), is_free);
  if (base == RobotBase::held)
    for (Body& body : file.bodies)
      if (is_free(body)) body.joints.clear();
  if (base != RobotBase::free || any_free) return;
  const auto root = std::find_if(file.bodies.begin() + 1, file.bodies.end(),
                                 [](const Body& body) { return body.parent == 0 && body.joints.empty(); });
  if (root == file.bodies.end())
    return file.problems->push_back(
        {0, "base = \"free\": each body in the world has its own joint; only a fixed body can be set free", {}});
  Joint floats;
  floats.kind = JointKind::free;
  floats.name = file.names.new_name("joint", root->name + "_free");
  root->joints.push_back(std::move(floats));
}

class RobotMaker {
 public:
  RobotMaker(const Document& document, const DefaultClasses& classes, File& file)
      : document_(document), classes_(classes), file_(file) {}

  RobotSpec make() {
    place();
    weigh();
    robot_.name = file_.name;
    robot_.gravity = file_.settings.gravity;
    for (std::size_t i = 1; i < file_.bodies.size(); ++i)
      if (carrier_[i] == i) add_body(i);
    robot_.actuators = read_actuators(document_, classes_, felt_inertias(), file_);
    robot_.sensors = read_sensors(document_, carried(), file_);
    robot_.couplings = read_couplings(document_, classes_, file_);
    add_what_is_usual();
    note_chains();
    note_sections();
    if (robot_.bodies.empty())
      file_.problems->push_back({0, "no body has a joint, so nothing in it moves; a robot needs at least one", {}});
    return std::move(robot_);
  }

 private:
  void place() {
    carrier_.resize(file_.bodies.size());
    world_.resize(file_.bodies.size());
    for (std::size_t i = 1; i < file_.bodies.size(); ++i) {
      const Body& body = file_.bodies[i];
      world_[i] = world_[body.parent] * body.pose;
      world_[i].orientation.normalize();
      carrier_[i] = body.joints.empty() ? carrier_[body.parent] : i;
    }
  }

  Pose in_carrier(std::size_t body) const { return world_[carrier_[body]].inverse() * world_[body]; }

  /// All bodies that move with each carrier, in its frame.
  void weigh() {
    std::vector<std::vector<RigidMass>> parts(file_.bodies.size());
    std::vector<std::size_t> meshes(file_.bodies.size());
    for (std::size_t i = 1; i < file_.bodies.size(); ++i) {
      const Body& body = file_.bodies[i];
      meshes[carrier_[i]] += body.unread_meshes;
      if (!body.mass) continue;
      parts[carrier_[i]].push_back(carrier_[i] == i ? *body.mass : moved(*body.mass, in_carrier(i)));
    }
    masses_.resize(file_.bodies.size());
    for (std::size_t i = 1; i < file_.bodies.size(); ++i) {
      if (carrier_[i] != i) continue;
      masses_[i] = joined(parts[i]);
      if (meshes[i] > 0) guess(i, "body " + file_.bodies[i].name + " has meshes without a mass; a mass of 0 is used");
      if (masses_[i].mass > 0.0) continue;
      guess(i, "body " + file_.bodies[i].name + " moves but has no mass; 1 g is used");
      masses_[i].mass = kLeastMass;
      masses_[i].inertia = robot_files::repaired(Eigen::Matrix3d::Zero(), kLeastMass);
    }
  }

  void guess(std::size_t body, std::string text) {
    file_.remarks.push_back(
        {RobotRemarkKind::guessed, file_.bodies[body].line, std::move(text), file_.bodies[body].file});
  }

  std::string name_of(std::size_t carrier) const { return carrier == 0 ? kWorld : file_.bodies[carrier].name; }

  /// A chain of its joints, the last of which holds the body.
  void add_body(std::size_t index) {
    const Body& body = file_.bodies[index];
    std::string parent = name_of(carrier_[body.parent]);
    for (std::size_t j = 0; j + 1 < body.joints.size(); ++j) {
      const std::string between = file_.names.new_name("body", body.name + "_on_" + body.joints[j].name);
      const double share = std::max(kNextToNothing, kSmallest / masses_[index].mass);
      RigidMass mass = masses_[index];
      mass.mass *= share;
      mass.inertia *= share;
      robot_.bodies.push_back(body_of(between, mass, world_[index]));
      add_joint(index, body.joints[j], parent, between);
      parent = between;
    }
    robot_.bodies.push_back(body_of(body.name, masses_[index], world_[index]));
    if (std::string reason = robot_files::why_too_large(robot_.bodies.back()); !reason.empty())
      file_.problems->push_back({body.line, std::move(reason), body.file});
    add_joint(index, body.joints.back(), parent, body.name);
    if (body.joints.size() > 1) ++bodies_on_chains_;
  }

  void add_joint(std::size_t index, const Joint& joint, const std::string& parent, const std::string& child) {
    JointSpec spec;
    spec.name = joint.name;
    spec.kind = joint.kind;
    spec.parent = parent;
    spec.child = child;
    spec.anchor = world_[index].position + world_[index].orientation * joint.anchor;
    spec.axis = world_[index].orientation * joint.axis;
    spec.lower = joint.lower;
    spec.upper = joint.upper;
    spec.damping = joint.damping;
    spec.dry_friction = joint.dry_friction;
    spec.stiffness = joint.stiffness;
    spec.rest = joint.rest;
    spec.armature = joint.armature;
    robot_.joints.push_back(std::move(spec));
  }

  std::vector<Carried> carried() const {
    std::vector<Carried> all(file_.bodies.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = {name_of(carrier_[i]), in_carrier(i)};
    return all;
  }

  /// Inertia that each joint moves at position zero, including its own; kg·m² or kg.
  std::vector<std::vector<double>> felt_inertias() const {
    std::vector<RigidMass> moved_by(file_.bodies.size());  // in the world
    for (std::size_t i = 1; i < moved_by.size(); ++i)
      if (carrier_[i] == i) moved_by[i] = moved(masses_[i], world_[i]);
    for (std::size_t i = moved_by.size() - 1; i > 0; --i) {
      const std::size_t on = carrier_[file_.bodies[i].parent];
      if (carrier_[i] == i && on != 0) moved_by[on] = joined({moved_by[on], moved_by[i]});
    }
    std::vector<std::vector<double>> felt(file_.bodies.size());
    for (std::size_t i = 1; i < felt.size(); ++i)
      for (const Joint& joint : file_.bodies[i].joints) felt[i].push_back(felt_by(joint, world_[i], moved_by[i]));
    return felt;
  }

  static double felt_by(const Joint& joint, const Pose& pose, const RigidMass& mass) {
    if (joint.kind != JointKind::hinge) return mass.mass + joint.armature;
    const Eigen::Vector3d axis = pose.orientation * joint.axis;
    const Eigen::Vector3d away = mass.com - (pose.position + pose.orientation * joint.anchor);
    return axis.dot((mass.inertia + robot_files::point_inertia(mass.mass, away)) * axis) + joint.armature;
  }

  void add_what_is_usual() {
    const bool has_motors = !robot_.actuators.empty() || !document_.sections("actuator").empty();
    bool any = false;
    for (const JointSpec& joint : robot_.joints) {
      if (joint.kind == JointKind::free) add_body_sensors(joint.child);
      if (joint.kind != JointKind::hinge && joint.kind != JointKind::slider) continue;
      add_joint_sensors(joint.name);
      const bool follows = std::any_of(robot_.couplings.begin(), robot_.couplings.end(),
                                       [&](const CouplingSpec& one) { return one.joint == joint.name; });
      if (has_motors || follows) continue;
      ActuatorSpec motor;
      motor.name = motor.joint = joint.name;
      robot_.actuators.push_back(std::move(motor));
      any = true;
    }
    if (any)
      file_.remarks.push_back(
          {RobotRemarkKind::guessed, 0, "it has no actuator; each joint gets a motor with the joint's name", {}});
  }

  void add_sensor(SensorKind kind, const std::string& element, const std::string& ending) {
    const bool is_there = std::any_of(robot_.sensors.begin(), robot_.sensors.end(), [&](const SensorSpec& one) {
      return one.kind == kind && one.element == element;
    });
    if (is_there) return;
    SensorSpec sensor;
    sensor.name = file_.names.new_name("sensor", element + ending);
    sensor.kind = kind;
    sensor.element = element;
    if (kind == SensorKind::joint_position) sensor.offset = references().at(element);
    robot_.sensors.push_back(std::move(sensor));
  }

  void add_joint_sensors(const std::string& joint) {
    add_sensor(SensorKind::joint_position, joint, "_position");
    add_sensor(SensorKind::joint_velocity, joint, "_velocity");
  }

  void add_body_sensors(const std::string& body) {
    add_sensor(SensorKind::body_position, body, "_position");
    add_sensor(SensorKind::body_orientation, body, "_orientation");
    add_sensor(SensorKind::body_velocity, body, "_velocity");
    add_sensor(SensorKind::body_angular_velocity, body, "_angular_velocity");
  }

  const std::map<std::string, double>& references() {
    if (references_.empty())
      for (const Body& body : file_.bodies)
        for (const Joint& joint : body.joints) references_[joint.name] = joint.reference;
    return references_;
  }

  void note_chains() {
    if (bodies_on_chains_ > 0)
      file_.remarks.push_back({RobotRemarkKind::guessed,
                               0,
                               "bodies with several joints: " + std::to_string(bodies_on_chains_) +
                                   "; bodies of almost no mass are put between their joints",
                               {}});
  }

  void note_sections() {
    static const std::set<std::string_view> kKnown = {"compiler",  "option",   "size",   "visual",
                                                      "statistic", "default",  "asset",  "custom",
                                                      "worldbody", "actuator", "sensor", "equality"};
    std::set<std::string> noted;
    for (const XmlElement& section : document_.sections()) {
      const std::string name(section.name());
      if (kKnown.contains(section.name()) || !noted.insert(name).second) continue;
      file_.remark(RobotRemarkKind::left_out, section,
                   name == "tendon" ? "tendons: their forces and constraints are not in the model"
                                    : "<" + name + "> has no equivalent in a model");
    }
  }

  const Document& document_;
  const DefaultClasses& classes_;
  File& file_;
  RobotSpec robot_;
  std::vector<std::size_t> carrier_;  ///< by body: the one whose joint moves it; the world's for fixed bodies
  std::vector<Pose> world_;           ///< by body, all joints at zero
  std::vector<RigidMass> masses_;     ///< by carrier, in its frame
  std::map<std::string, double> references_;
  std::size_t bodies_on_chains_ = 0;
};

/// One remark for all guesses from names and about the base.
void note_base(const File& file, std::vector<RobotRemark>& remarks) {
  for (const Body& body : file.bodies)
    if (is_free(body)) return;
  remarks.push_back({RobotRemarkKind::guessed, 0, "no body floats: all are fixed to the world", {}});
}

}  // namespace

ReadRobot read_robot(const RobotText& text) {
  File file;
  return read_robot(text, file);
}

ReadRobot read_robot(const RobotText& text, File& file) {
  ReadRobot read;
  const Document document(text, read.problems);
  if (!read.problems.empty()) return read;
  file.problems = &read.problems;
  file.name = file.names.named("model", document.root().text_of("model").value_or("robot"), 0, {}, file.remarks);
  file.settings = read_settings(document, file.remarks);
  const DefaultClasses classes(document);
  read_bodies(document, classes, file);
  set_base(file, text.base);
  if (read.problems.empty()) read.robot = RobotMaker(document, classes, file).make();
  if (text.base == RobotBase::as_written) note_base(file, file.remarks);  // else it was asked for
  read.remarks = std::move(file.remarks);
  return read;
}

}  // namespace lacuna::mjcf

#include "urdf_robot.h"

#include "inertia_repair.h"
#include "urdf_motor.h"

#include <algorithm>
#include <map>

namespace lacuna::urdf {
namespace {

using robot_files::body_of;
using robot_files::can_be;
using robot_files::joined;
using robot_files::moved;
using robot_files::repaired;

constexpr double kLeastMass = 1e-3;  ///< kg, of a body that moves but has no mass
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The place of a link, and the link with which it moves.
struct Placed {
  Pose pose;                    ///< in the world, all joints at zero
  std::size_t carrier = kNone;  ///< the link whose joint moves it; the root for fixed links
  std::size_t joint = kNone;    ///< joint that holds it; the root has none
};

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

class RobotMaker {
 public:
  RobotMaker(const File& file, RobotBase base) : file_(file), base_(base), made_{{}, file.remarks, file.problems} {
    for (std::size_t i = 0; i < file.links.size(); ++i) link_of_name_.try_emplace(file.links[i].name, i);
    placed_.resize(file.links.size());
  }

  ReadRobot make() {
    if (!made_.problems.empty()) return std::move(made_);
    hold_links();
    if (made_.problems.empty()) place_links();
    if (!made_.problems.empty()) return std::move(made_);
    made_.robot.name = file_.name;
    if (is_free()) float_root();
    for (const std::size_t link : order_)
      if (placed_[link].carrier == link && placed_[link].joint != kNone) add_body(link);
    add_couplings();
    note_what_is_left_out();
    return std::move(made_);
  }

 private:
  void problem(int line, std::string text) { made_.problems.push_back({line, std::move(text)}); }
  void remark(RobotRemarkKind kind, int line, std::string text) {
    made_.remarks.push_back({kind, line, std::move(text)});
  }

  std::size_t link_of(const std::string& name, const Joint& joint) {
    const auto found = link_of_name_.find(name);
    if (found != link_of_name_.end()) return found->second;
    problem(joint.line, "joint " + joint.name + " names the link \"" + name + "\", which does not exist");
    return kNone;
  }

  /// Parent and child joints of the links.
  void hold_links() {
    hanging_.resize(file_.links.size());
    for (std::size_t j = 0; j < file_.joints.size(); ++j) {
      const Joint& joint = file_.joints[j];
      const std::size_t parent = link_of(joint.parent, joint), child = link_of(joint.child, joint);
      if (parent == kNone || child == kNone) continue;
      if (placed_[child].joint != kNone)
        problem(joint.line, "link " + joint.child + " is the child of two joints, " +
                                file_.joints[placed_[child].joint].name + " and " + joint.name +
                                "; a URDF must be a tree");
      placed_[child].joint = j;
      hanging_[parent].push_back(child);
    }
  }

  void place_links() {
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < placed_.size(); ++i)
      if (placed_[i].joint == kNone) roots.push_back(i);
    if (roots.empty()) return problem(0, "its joints form a loop without a fixed link; a URDF must be a tree");
    if (roots.size() > 1)
      return problem(file_.links[roots[1]].line, "links " + file_.links[roots[0]].name + " and " +
                                                     file_.links[roots[1]].name +
                                                     " are both without a parent; join them, or leave one out");
    order_ = roots;
    placed_[roots.front()].carrier = roots.front();
    for (std::size_t i = 0; i < order_.size(); ++i)
      for (const std::size_t child : hanging_[order_[i]]) {
        place(child, order_[i]);
        order_.push_back(child);
      }
    if (order_.size() < placed_.size()) problem(0, "some of its joints form a loop; a URDF must be a tree");
  }

  void place(std::size_t link, std::size_t parent) {
    const Joint& joint = file_.joints[placed_[link].joint];
    placed_[link].pose = placed_[parent].pose * joint.origin;
    placed_[link].pose.orientation.normalize();
    placed_[link].carrier = moves(joint) ? link : placed_[parent].carrier;
  }

  std::size_t root() const { return order_.front(); }
  bool is_free() const { return base_ == RobotBase::free; }
  bool moves(const Joint& joint) const {
    return joint.type != JointType::fixed && (joint.type != JointType::floating || base_ != RobotBase::held);
  }

  std::string name_of(std::size_t carrier) const {
    return carrier == root() && !is_free() ? kWorld : file_.links[carrier].name;
  }

  void float_root() {
    const std::string& name = file_.links[root()].name;
    put_body(root(), mass_of(root()), placed_[root()].pose);
    JointSpec joint;
    joint.name = name + "_free";
    joint.kind = JointKind::free;
    joint.child = name;
    joint.anchor = placed_[root()].pose.position;
    made_.robot.joints.push_back(std::move(joint));
    add_sensors(name, {{SensorKind::body_position, "_position"},
                       {SensorKind::body_orientation, "_orientation"},
                       {SensorKind::body_velocity, "_velocity"},
                       {SensorKind::body_angular_velocity, "_angular_velocity"}});
  }

  void add_sensors(const std::string& element, const std::vector<std::pair<SensorKind, const char*>>& kinds) {
    for (const auto& [kind, what] : kinds) {
      SensorSpec sensor;
      sensor.name = element + what;
      sensor.kind = kind;
      sensor.element = element;
      made_.robot.sensors.push_back(std::move(sensor));
    }
  }

  void add_body(std::size_t link) {
    const Pose& pose = placed_[link].pose;
    const RigidMass mass = mass_of(link);
    put_body(link, mass, pose);
    add_joint(link);
  }

  void put_body(std::size_t link, const RigidMass& mass, const Pose& pose) {
    const Link& of = file_.links[link];
    made_.robot.bodies.push_back(body_of(of.name, mass, pose));
    if (std::string reason = robot_files::why_too_large(made_.robot.bodies.back()); !reason.empty())
      problem(of.line, std::move(reason));
  }

  /// Total of all links that a joint moves together, in the frame of the first.
  RigidMass mass_of(std::size_t carrier) {
    std::vector<RigidMass> parts;
    for (const std::size_t link : order_)
      if (placed_[link].carrier == carrier && file_.links[link].mass) {
        const Pose& own = placed_[carrier].pose;
        const Eigen::Quaterniond back = own.orientation.conjugate();
        const Pose in_carrier{back * (placed_[link].pose.position - own.position),
                              back * placed_[link].pose.orientation};
        parts.push_back(moved(possible(file_.links[link]), in_carrier));
      }
    RigidMass whole = joined(parts);
    if (whole.mass > 0.0) return whole;
    remark(RobotRemarkKind::guessed, file_.links[carrier].line,
           "link " + file_.links[carrier].name + " moves but has no mass; 1 g is used");
    whole.mass = kLeastMass;
    whole.inertia = repaired(Eigen::Matrix3d::Zero(), kLeastMass);
    return whole;
  }

  RigidMass possible(const Link& link) {
    RigidMass mass = *link.mass;
    if (mass.mass == 0.0 || can_be(mass.inertia)) return mass;
    mass.inertia = repaired(mass.inertia, mass.mass);
    remark(
        RobotRemarkKind::repaired, link.line,
        "the inertia of link " + link.name +
            " is impossible: a principal moment is not above 0, or above the sum of the others; the nearest possible "
            "one is used");
    return mass;
  }

  void add_joint(std::size_t link) {
    const Joint& joint = file_.joints[placed_[link].joint];
    const std::size_t parent = placed_[link_of_name_.at(joint.parent)].carrier;
    if (joint.type == JointType::planar)
      return problem(joint.line, "joint " + joint.name + " is planar; write two prismatic joints and a revolute one");
    if (joint.type == JointType::floating && (parent != root() || is_free()))
      return problem(joint.line,
                     "joint " + joint.name + " floats on a link that moves; only a body in the world can float");
    JointSpec spec;
    spec.name = joint.name;
    spec.parent = name_of(parent);
    spec.child = file_.links[link].name;
    spec.anchor = placed_[link].pose.position;
    spec.axis = placed_[link].pose.orientation * joint.axis;
    spec.kind = joint.type == JointType::prismatic  ? JointKind::slider
                : joint.type == JointType::floating ? JointKind::free
                                                    : JointKind::hinge;
    if (spec.kind != JointKind::free) {
      spec.lower = joint.lower;
      spec.upper = joint.upper;
      spec.damping = joint.damping;
      spec.dry_friction = joint.friction;
      add_channels(joint);
    }
    made_.robot.joints.push_back(std::move(spec));
  }

  void add_channels(const Joint& joint) {
    add_sensors(joint.name, {{SensorKind::joint_position, "_position"}, {SensorKind::joint_velocity, "_velocity"}});
    if (joint.mimic) return;
    if (std::optional<ActuatorSpec> motor = motor_of(joint, file_.says_commands, made_.remarks))
      made_.robot.actuators.push_back(std::move(*motor));
  }

  const Joint* joint_called(const std::string& name) const {
    const auto found =
        std::find_if(file_.joints.begin(), file_.joints.end(), [&](const Joint& joint) { return joint.name == name; });
    return found == file_.joints.end() ? nullptr : &*found;
  }

  void add_couplings() {
    for (const Joint& joint : file_.joints) {
      if (!joint.mimic) continue;
      const Joint* followed = joint_called(joint.mimic->joint);
      if (!followed || followed->type == JointType::fixed)
        problem(joint.line,
                "joint " + joint.name + " follows \"" + joint.mimic->joint + "\", which is not a moving joint");
      else if (followed->mimic)
        problem(joint.line,
                "joint " + joint.name + " follows " + followed->name + ", which follows another; follow that one");
      else
        made_.robot.couplings.push_back(
            {joint.name, joint.name, followed->name, joint.mimic->multiplier, joint.mimic->offset});
    }
  }

  void note_what_is_left_out() {
    std::size_t collisions = 0, velocities = 0;
    for (const Link& link : file_.links) collisions += link.collisions;
    for (const Joint& joint : file_.joints) velocities += joint.velocity > 0.0 ? 1 : 0;
    if (collisions > 0)
      remark(RobotRemarkKind::left_out, 0, counted(collisions, "collision shape") + ": the robot touches nothing");
    if (velocities > 0)
      remark(RobotRemarkKind::left_out, 0, counted(velocities, "velocity limit") + ": not limited in a model");
    if (!is_free())
      remark(RobotRemarkKind::guessed, file_.links[root()].line,
             "link " + file_.links[root()].name + " is fixed to the world");
  }

  const File& file_;
  RobotBase base_;
  ReadRobot made_;
  std::map<std::string, std::size_t> link_of_name_;
  std::vector<Placed> placed_;                     ///< by link
  std::vector<std::vector<std::size_t>> hanging_;  ///< by link
  std::vector<std::size_t> order_;                 ///< of links, each after its parent
};

}  // namespace

ReadRobot robot_of(const File& file, RobotBase base) { return RobotMaker(file, base).make(); }

}  // namespace lacuna::urdf

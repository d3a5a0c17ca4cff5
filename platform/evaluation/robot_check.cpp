#include "evaluation/robot_check.h"

#include "foundation/address.h"
#include "foundation/problem.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

namespace lacuna {
namespace {

constexpr double kUnitTolerance = 1e-6;

/// Values that mean "no limit" or "rigid" where they are infinite.
bool may_be_infinite(std::string_view address) {
  static constexpr std::array<std::string_view, 8> kEndings = {
      ".lower",         ".upper",          ".force_limit",      ".command_lower",
      ".command_upper", "ssion.stiffness", "contact.stiffness", "contact.friction"};
  return std::any_of(kEndings.begin(), kEndings.end(), [&](std::string_view end) { return address.ends_with(end); });
}

class RobotCheck {
 public:
  explicit RobotCheck(const RobotSpec& robot) : robot_(robot) {}

  std::vector<std::string> run() {
    check_names("body", robot_.bodies);
    check_names("joint", robot_.joints);
    check_names("actuator", robot_.actuators);
    check_names("sensor", robot_.sensors);
    if (robot_.bodies.empty()) add("the robot has no body");
    check_tree();
    for (const JointSpec& joint : robot_.joints) check_axes(joint);
    for (const BodySpec& body : robot_.bodies) check_body(body);
    check_references();
    check_values();
    return std::move(problems_);
  }

 private:
  void add(const std::string& sentence) { problems_.push_back(sentence); }

  template <class Spec>
  void check_names(const std::string& kind, const std::vector<Spec>& specs) {
    std::set<std::string> seen;
    for (const Spec& spec : specs) {
      if (spec.name.empty() || spec.name.find_first_of(".* ") != std::string::npos)
        add("a " + kind + " is named \"" + spec.name + "\"; give it a name without dots, stars and blanks");
      if (!seen.insert(spec.name).second) add("two are named " + kind + "." + spec.name + "; rename one");
    }
  }

  void check_tree() {
    std::map<std::string, std::string> parents;  // of each child
    for (const JointSpec& joint : robot_.joints) {
      const std::string name = "joint." + joint.name;
      if (joint.parent != kWorld) need(name, "parent", joint.parent, robot_.bodies);
      need(name, "child", joint.child, robot_.bodies);
      if (!parents.emplace(joint.child, joint.parent).second)
        add(name + ": body." + joint.child + " is the child of another joint already; a body has one parent");
    }
    for (const BodySpec& body : robot_.bodies) {
      std::size_t steps = 0;
      auto link = parents.find(body.name);
      for (; link != parents.end() && steps <= parents.size(); ++steps) link = parents.find(link->second);
      if (steps <= parents.size()) continue;
      add("the joints above body." + body.name + " form a circle; a robot is a tree");
      return;
    }
  }

  template <class Spec>
  void need(const std::string& owner, const std::string& role, const std::string& name,
            const std::vector<Spec>& specs) {
    std::vector<std::string> names;
    names.reserve(specs.size());
    for (const Spec& spec : specs) names.push_back(spec.name);
    if (std::find(names.begin(), names.end(), name) == names.end())
      add(owner + ": its " + role + " \"" + name + "\" does not exist" + did_you_mean(name, names));
  }

  void check_axes(const JointSpec& joint) {
    const std::string name = "joint." + joint.name;
    const bool has_axis = joint.kind != JointKind::fixed && joint.kind != JointKind::ball;
    if (has_axis && !(std::abs(joint.axis.norm() - 1.0) < kUnitTolerance)) add(name + ": its axis is no unit vector");
    if (!joint.anchor.allFinite()) add(name + ": its anchor is not a number");
    if (!(joint.lower <= joint.upper)) add(name + ": its lower stop lies above the upper one");
    if (joint.kind != JointKind::universal) return;
    if (!(std::abs(joint.axis2.norm() - 1.0) < kUnitTolerance) ||
        !(std::abs(joint.axis.dot(joint.axis2)) < kUnitTolerance))
      add(name + ": its axis2 is no unit vector perpendicular to its axis");
  }

  void check_body(const BodySpec& body) {
    const std::string name = "body." + body.name;
    if (!body.position.allFinite()) add(name + ": its position is not a number");
    check_rotation(name, body.orientation);
    const InertiaSpec& i = body.inertia;
    Eigen::Matrix3d tensor;
    tensor << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
    if (tensor.allFinite() && !(tensor.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() > 0.0))
      add(name + ": its inertia is not positive definite; no body has such an inertia");
    for (const ShapeSpec& shape : body.shapes) check_shape(name, shape);
  }

  void check_shape(const std::string& name, const ShapeSpec& shape) {
    const int used = shape.kind == ShapeKind::box ? 3 : shape.kind == ShapeKind::sphere ? 1 : 2;
    for (int i = 0; i < used; ++i)
      if (!(shape.size[i] > 0.0) || !std::isfinite(shape.size[i])) add(name + ": a shape's size is not positive");
    if (!shape.position.allFinite()) add(name + ": a shape's position is not a number");
    check_rotation(name, shape.orientation);
  }

  void check_rotation(const std::string& name, const Eigen::Quaterniond& rotation) {
    if (!(std::abs(rotation.norm() - 1.0) < kUnitTolerance)) add(name + ": an orientation is no unit quaternion");
  }

  void check_references() {
    for (const ActuatorSpec& actuator : robot_.actuators)
      need("actuator." + actuator.name, "joint", actuator.joint, robot_.joints);
    for (const SensorSpec& sensor : robot_.sensors) {
      const bool on_joint = sensor.kind == SensorKind::joint_position || sensor.kind == SensorKind::joint_velocity ||
                            sensor.kind == SensorKind::joint_force;
      if (on_joint)
        need("sensor." + sensor.name, "joint", sensor.element, robot_.joints);
      else
        need("sensor." + sensor.name, "body", sensor.element, robot_.bodies);
    }
  }

  void check_values() {
    RobotSpec copy = robot_;
    for (const AddressedValue& value : addressed_values(copy)) {
      if (std::isnan(*value.value) || (std::isinf(*value.value) && !may_be_infinite(value.address)))
        add(value.address + " is " + std::to_string(*value.value) + "; give it a number");
      else if (*value.value < value.lower || *value.value > value.upper)
        add(value.address + " is " + std::to_string(*value.value) + " " + value.unit +
            ", which is outside its physical bounds");
    }
  }

  const RobotSpec& robot_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> robot_problems(const RobotSpec& robot) { return RobotCheck(robot).run(); }

}  // namespace lacuna

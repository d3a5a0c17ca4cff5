#include "simulation/shared/robot_checks.h"

#include "foundation/address.h"
#include "foundation/text/counted.h"
#include "foundation/link_angle.h"
#include "foundation/text/number_text.h"
#include "foundation/text/problem.h"
#include "simulation/shared/joint_tree.h"
#include "simulation/shared/sensor_bank.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna::simulation {
namespace {

constexpr double kAxisTolerance = 1e-6;  // of unit length and of a right angle
constexpr double kLargest = 1e12;        // of masses and inertias, SI

bool positive_definite(const InertiaSpec& inertia) {
  Eigen::Matrix3d matrix;
  matrix << inertia.xx, inertia.xy, inertia.xz, inertia.xy, inertia.yy, inertia.yz, inertia.xz, inertia.yz, inertia.zz;
  if (!matrix.allFinite() || matrix.cwiseAbs().maxCoeff() > kLargest) return false;
  const Eigen::LLT<Eigen::Matrix3d> factor(matrix);
  return factor.info() == Eigen::Success && factor.matrixLLT().diagonal().minCoeff() > 0.0;
}

std::string body_complaint(const BodySpec& body) {
  if (!(body.mass > 0.0) || body.mass > kLargest)
    return "body \"" + body.name + "\": its mass is " + number_text(body.mass) +
           " kg, it must be positive and at most " + number_text(kLargest) + " kg";
  if (!positive_definite(body.inertia))
    return "body \"" + body.name + "\": its moments of inertia are not positive definite; check xx, yy, zz, xy, xz, yz";
  if (!body.com.allFinite() || !body.position.allFinite() || !body.orientation.coeffs().allFinite())
    return "body \"" + body.name + "\": its pose or centre of mass is not finite";
  return {};
}

std::string gap_complaint(const ActuatorSpec& actuator) {
  const TransmissionSpec& transmission = actuator.transmission;
  if (transmission.gap > 0.0 && !std::isfinite(transmission.stiffness))
    return "actuator \"" + actuator.name + "\": its transmission has a gap but infinite stiffness; give the stiffness";
  return {};
}

template <class Spec>
void check_names(const std::vector<Spec>& specs, const std::string& kind, ProblemList& problems) {
  std::set<std::string> seen;
  for (const Spec& spec : specs) {
    if (spec.name.empty() || spec.name.find_first_of(".* ") != std::string::npos)
      problems.add({}, with_article(kind) + " of the robot is named \"" + spec.name +
                           "\"; give it a name without dots, stars and blanks");
    if (!seen.insert(spec.name).second)
      problems.add({}, "two " + kind + "s of the robot have the name \"" + spec.name + "\"; names must differ");
  }
}

template <class Spec>
std::vector<std::string> names_of(const std::vector<Spec>& specs) {
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const Spec& spec : specs) names.push_back(spec.name);
  return names;
}

void check_bodies(const RobotSpec& robot, ProblemList& problems) {
  for (const BodySpec& body : robot.bodies) {
    if (const std::string complaint = body_complaint(body); !complaint.empty()) problems.add({}, complaint);
    if (body.name == kWorld) problems.add({}, "a body must not have the name \"world\"");
    if (std::abs(body.orientation.norm() - 1.0) > kAxisTolerance)
      problems.add({}, "body \"" + body.name + "\": its orientation is not a unit quaternion");
    for (const ShapeSpec& shape : body.shapes) {
      const int sizes = shape.kind == ShapeKind::box ? 3 : shape.kind == ShapeKind::sphere ? 1 : 2;
      const bool sound = shape.size.allFinite() && shape.position.allFinite() &&
                         std::abs(shape.orientation.norm() - 1.0) < kAxisTolerance &&
                         (shape.size.head(sizes).array() > 0.0).all();
      if (!sound)
        problems.add(
            {}, "body \"" + body.name + "\": a shape's sizes must be positive and its orientation a unit quaternion");
    }
  }
}

void check_joints(const RobotSpec& robot, ProblemList& problems) {
  for (const JointSpec& joint : robot.joints) {
    const std::string where = "joint \"" + joint.name + "\": ";
    const bool has_axis =
        joint.kind != JointKind::ball && joint.kind != JointKind::fixed && joint.kind != JointKind::free;
    if (joint.kind == JointKind::free && joint.parent != kWorld)
      problems.add({}, where + "a free joint holds its body to nothing, so its parent must be the world");
    if (!joint.anchor.allFinite()) problems.add({}, where + "its anchor is not finite");
    if (has_axis && !(std::abs(joint.axis.norm() - 1.0) < kAxisTolerance))
      problems.add({}, where + "its axis is not a unit vector");
    if (joint.kind == JointKind::universal && !(std::abs(joint.axis2.norm() - 1.0) < kAxisTolerance &&
                                                std::abs(joint.axis.dot(joint.axis2)) < kAxisTolerance))
      problems.add({}, where + "its axis2 is not a unit vector perpendicular to its axis");
    if (!(joint.lower <= joint.upper)) problems.add({}, where + "its lower stop is above its upper stop");
  }
}

void check_actuators(const RobotSpec& robot, ProblemList& problems) {
  for (const ActuatorSpec& actuator : robot.actuators) {
    const std::string where = "actuator \"" + actuator.name + "\": ";
    const int joint = index_of(robot.joints, actuator.joint);
    if (joint < 0) {
      problems.add({}, where + "its joint \"" + actuator.joint + "\" is not a joint of the robot" +
                           did_you_mean(actuator.joint, names_of(robot.joints)));
      continue;
    }
    const JointKind kind = robot.joints[static_cast<std::size_t>(joint)].kind;
    if (kind == JointKind::ball || kind == JointKind::fixed || kind == JointKind::free)
      problems.add({},
                   where + "its joint \"" + actuator.joint +
                       "\" is a ball, free or fixed joint; actuators drive hinges, sliders and the first coordinate of "
                       "universal joints");
    if (!(actuator.command_lower <= actuator.command_upper))
      problems.add({}, where + "its command_lower is above its command_upper");
    if (const std::string complaint = gap_complaint(actuator); !complaint.empty()) problems.add({}, complaint);
  }
}

void check_sensors(const RobotSpec& robot, ProblemList& problems) {
  for (const SensorSpec& sensor : robot.sensors) {
    const std::string where = "sensor \"" + sensor.name + "\": ";
    const std::vector<std::string> known = reads_joint(sensor.kind) ? names_of(robot.joints) : names_of(robot.bodies);
    const int element =
        reads_joint(sensor.kind) ? index_of(robot.joints, sensor.element) : index_of(robot.bodies, sensor.element);
    if (element < 0)
      problems.add({}, where + "it reads \"" + sensor.element + "\", which is not a " +
                           (reads_joint(sensor.kind) ? "joint" : "body") + " of the robot" +
                           did_you_mean(sensor.element, known));
    else if (reads_joint(sensor.kind) && robot.joints[static_cast<std::size_t>(element)].kind == JointKind::fixed)
      problems.add({}, where + "it reads the fixed joint \"" + sensor.element + "\", which has no coordinate");
    else if (reads_joint(sensor.kind) && robot.joints[static_cast<std::size_t>(element)].kind == JointKind::free)
      problems.add({}, where + "it reads the free joint \"" + sensor.element + "\"; read its body instead");
  }
}

void check_couplings(const RobotSpec& robot, ProblemList& problems) {
  for (const CouplingSpec& coupling : robot.couplings) {
    const std::string where = "coupling \"" + coupling.name + "\": ";
    for (const std::string* name : {&coupling.joint, &coupling.follows}) {
      const int joint = index_of(robot.joints, *name);
      const JointKind kind = joint < 0 ? JointKind::fixed : robot.joints[static_cast<std::size_t>(joint)].kind;
      if (kind != JointKind::hinge && kind != JointKind::slider)
        problems.add({}, where + "\"" + *name + "\" is neither a hinge nor a slider of the robot");
    }
    for (const CouplingSpec& other : robot.couplings)
      if (other.joint == coupling.follows || (&other != &coupling && other.joint == coupling.joint))
        problems.add({}, where + "a joint can follow only one other joint, which must not follow another");
  }
}

void check_link_angles(const RobotSpec& robot, ProblemList& problems) {
  for (const SensorSpec& sensor : robot.sensors) {
    if (sensor.kind != SensorKind::link_angle && sensor.kind != SensorKind::link_velocity) continue;
    try {
      turns_of_link(robot, sensor.element);
    } catch (const Error& error) {
      problems.add({}, "sensor \"" + sensor.name + "\": " + error.what());
    }
  }
}

void check_values(const RobotSpec& robot, ProblemList& problems) {
  if (values_in_bounds(robot)) return;
  RobotSpec copy = robot;  // only addresses of values that may be written
  for (const AddressedValue& value : addressed_values(copy)) {
    if (value.address.starts_with("body.")) continue;  // already checked by check_bodies
    const bool inside = *value.value >= value.lower && *value.value <= value.upper;
    if (inside && (value.may_be_infinite || std::isfinite(*value.value))) continue;
    problems.add({}, value.address + " is " + number_text(*value.value) + " " + value.unit + ", outside of " +
                         number_text(value.lower) + " to " + number_text(value.upper));
  }
}

}  // namespace

void check_robot(const RobotSpec& robot) {
  ProblemList problems;
  if (robot.bodies.empty()) problems.add({}, "the robot has no body");
  check_names(robot.bodies, "body", problems);
  check_names(robot.joints, "joint", problems);
  check_names(robot.actuators, "actuator", problems);
  check_names(robot.sensors, "sensor", problems);
  check_bodies(robot, problems);
  check_joints(robot, problems);
  check_actuators(robot, problems);
  check_sensors(robot, problems);
  if (problems.empty()) check_link_angles(robot, problems);
  check_couplings(robot, problems);
  check_values(robot, problems);
  problems.throw_if_any();
}

void check_settings(const EngineSettings& settings) {
  ProblemList problems;
  if (!(settings.step > 0.0) || !std::isfinite(settings.step))
    problems.add({}, "engine.step is " + number_text(settings.step) + " s, it must be positive");
  if (settings.substeps < 1)
    problems.add({}, "engine.substeps is " + std::to_string(settings.substeps) + ", it must be at least 1");
  if (!(settings.control_period >= 0.0) || !std::isfinite(settings.control_period))
    problems.add({}, "engine.control_period is " + number_text(settings.control_period) +
                         " s, it must be positive, or 0 for every step");
  if (!(settings.joint_erp >= 0.0 && settings.joint_erp <= 1.0))
    problems.add({}, "engine.joint_erp is " + number_text(settings.joint_erp) + ", it must lie in 0 to 1");
  problems.throw_if_any();
}

std::string unphysical(const RobotSpec& robot) {
  for (const BodySpec& body : robot.bodies)
    if (std::string complaint = body_complaint(body); !complaint.empty()) return complaint;
  for (const ActuatorSpec& actuator : robot.actuators)
    if (std::string complaint = gap_complaint(actuator); !complaint.empty()) return complaint;
  for (const JointSpec& joint : robot.joints) {
    const double laws[] = {joint.damping, joint.dry_friction, joint.stiffness, joint.armature};
    for (const double law : laws)
      if (!(law >= 0.0) || std::isinf(law))
        return "joint \"" + joint.name +
               "\": damping, dry friction, stiffness and armature must be finite and not negative";
    if (!std::isfinite(joint.rest) || !std::isfinite(joint.force) || !(joint.lower <= joint.upper))
      return "joint \"" + joint.name +
             "\": its rest position or force is not finite, or its lower stop is above the upper one";
  }
  if (!robot.gravity.allFinite()) return "gravity is not finite";
  const ContactSpec& contact = robot.contact;
  if (!(contact.stiffness > 0.0) || !(contact.damping >= 0.0) || !(contact.friction >= 0.0) ||
      !std::isfinite(contact.slope) || std::isinf(contact.damping))
    return "contact: stiffness must be positive, damping and friction not negative, slope finite";
  if (!(contact.impact_damping >= 0.0) || !(contact.restitution >= 0.0 && contact.restitution <= 1.0) ||
      !(contact.rolling_lever >= 0.0) || !(contact.creep >= 0.0))
    return "contact: impact damping, rolling lever and creep must not be negative, restitution lie between 0 and 1";
  return {};
}

}  // namespace lacuna::simulation

#include "mjcf_file.h"

#include <algorithm>

namespace lacuna::mjcf {
namespace {

JointKind kind_of(const Attributes& joint) {
  static const std::map<std::string, JointKind> kKinds = {
      {"hinge", JointKind::hinge}, {"slide", JointKind::slider}, {"ball", JointKind::ball}, {"free", JointKind::free}};
  if (joint.element().name() == "freejoint") return JointKind::free;
  const std::string type = joint.text_of("type").value_or("hinge");
  const auto found = kKinds.find(type);
  if (found != kKinds.end()) return found->second;
  joint.element().problem("joint's type \"" + type + "\" is unknown; known are hinge, slide, ball and free");
  return JointKind::hinge;
}

double at_least_zero(const Attributes& joint, const char* attribute) {
  const double value = joint.number(attribute, 0.0);
  if (value < 0.0) joint.element().problem(std::string("joint's ") + attribute + " is negative");
  return std::max(value, 0.0);
}

/// Angles of hinges are written in the unit of the compiler.
double coordinate(const Joint& joint, double written, const Settings& settings) {
  return joint.kind == JointKind::hinge ? settings.angle(written) : written;
}

void read_range(const Attributes& element, const Settings& settings, Joint& joint, File& file) {
  const auto range = element.numbers("range", 2, 2);
  const bool is_limited = element.flag("limited", range && settings.auto_limits && range->at(0) < range->at(1));
  if (!is_limited) return;
  if (joint.kind == JointKind::ball)
    return file.remark(RobotRemarkKind::left_out, element.element(), "the range of ball joint " + joint.name);
  if (!range || !(range->at(0) < range->at(1)))
    return element.element().problem("joint is limited, but the lower bound of its range is not below the upper one");
  joint.lower = coordinate(joint, range->at(0), settings) - joint.reference;
  joint.upper = coordinate(joint, range->at(1), settings) - joint.reference;
}

void read_force_limit(const Attributes& element, const Settings& settings, Joint& joint) {
  const auto range = element.numbers("actuatorfrcrange", 2, 2);
  if (range && element.flag("actuatorfrclimited", settings.auto_limits))
    joint.force_limit = std::max(std::abs(range->at(0)), std::abs(range->at(1)));
}

}  // namespace

Joint read_joint(const Attributes& element, const Settings& settings, File& file) {
  Joint joint;
  joint.line = element.element().line();
  joint.file = element.element().file();
  joint.kind = kind_of(element);
  if (joint.kind == JointKind::free) return joint;
  joint.anchor = element.vector("pos", Eigen::Vector3d::Zero());
  joint.axis = element.vector("axis", Eigen::Vector3d::UnitZ());
  if (joint.axis.stableNorm() > 0.0)
    joint.axis.stableNormalize();
  else
    element.element().problem("joint's axis \"0 0 0\" has no direction");
  if (joint.kind != JointKind::ball) joint.reference = coordinate(joint, element.number("ref", 0.0), settings);
  joint.damping = at_least_zero(element, "damping");
  joint.dry_friction = at_least_zero(element, "frictionloss");
  joint.stiffness = at_least_zero(element, "stiffness");
  joint.armature = at_least_zero(element, "armature");
  joint.rest = coordinate(joint, element.number("springref", 0.0), settings) - joint.reference;
  if (joint.kind == JointKind::ball || joint.stiffness == 0.0) joint.rest = 0.0;
  read_range(element, settings, joint, file);
  read_force_limit(element, settings, joint);
  if (element.numbers("springdamper", 2, 2).value_or(std::vector<double>{0.0, 0.0})[0] > 0.0)
    file.remark(RobotRemarkKind::left_out, element.element(),
                "the springdamper of a joint; write its stiffness and damping");
  return joint;
}

}  // namespace lacuna::mjcf

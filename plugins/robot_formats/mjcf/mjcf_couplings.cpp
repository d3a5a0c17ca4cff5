#include "mjcf_couplings.h"

#include <algorithm>
#include <set>

namespace lacuna::mjcf {
namespace {

const Joint* joint_called(const File& file, const std::string& written) {
  const auto found = file.joint_of_name.find(written);
  if (found == file.joint_of_name.end()) return nullptr;
  const Body& body = file.bodies[found->second.first];
  return found->second.second < body.joints.size() ? &body.joints[found->second.second] : nullptr;
}

bool has_one_coordinate(const Joint& joint) {
  return joint.kind == JointKind::hinge || joint.kind == JointKind::slider;
}

/// A joint that follows another must not be followed.
bool makes_a_chain(const std::vector<CouplingSpec>& couplings, const Joint& joint, const Joint& follows) {
  return std::any_of(couplings.begin(), couplings.end(), [&](const CouplingSpec& other) {
    return other.joint == joint.name || other.joint == follows.name || other.follows == joint.name;
  });
}

/// Whether the element is handled: one more coupling, or a problem.
bool read_coupling(const Attributes& tie, const File& file, std::vector<CouplingSpec>& couplings) {
  if (tie.element().name() != "joint" || !tie.flag("active", true) || !tie.has("joint2")) return false;
  const Joint* joint = joint_called(file, tie.text_of("joint1").value_or(""));
  const Joint* follows = joint_called(file, tie.text_of("joint2").value_or(""));
  if (!joint || !follows) {
    tie.element().problem("an equality names a joint that does not exist");
    return true;
  }
  std::vector<double> line = tie.numbers("polycoef", 1, 5).value_or(std::vector<double>{0.0, 1.0});
  line.resize(5, 0.0);
  const bool is_straight = line[2] == 0.0 && line[3] == 0.0 && line[4] == 0.0 && line[1] != 0.0;
  if (!is_straight || !has_one_coordinate(*joint) || !has_one_coordinate(*follows) || joint == follows ||
      makes_a_chain(couplings, *joint, *follows))
    return false;
  couplings.push_back({joint->name, joint->name, follows->name, line[1], line[0]});
  return true;
}

}  // namespace

std::vector<CouplingSpec> read_couplings(const Document& document, const DefaultClasses& classes, File& file) {
  std::vector<CouplingSpec> couplings;
  std::set<std::string> others;
  const std::vector<XmlElement> elements = document.sections("equality");
  for (const XmlElement& element : elements)
    if (!read_coupling(classes.of(element, "", {"equality"}), file, couplings))
      others.insert(std::string(element.name()));
  std::string kinds;
  for (const std::string& kind : others) kinds += (kinds.empty() ? "" : ", ") + kind;
  if (!kinds.empty())
    file.remark(RobotRemarkKind::left_out, elements.front(), "equality constraints of these kinds: " + kinds);
  return couplings;
}

}  // namespace lacuna::mjcf

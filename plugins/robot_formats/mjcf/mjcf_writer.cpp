#include "mjcf_writer.h"

#include "inertia_repair.h"
#include "mjcf_robot.h"
#include "xml_editing.h"
#include "xml_writing.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna::mjcf {
namespace {

using robot_files::joined;
using robot_files::matrix_of;
using robot_files::moved;
using robot_files::number_text;
using robot_files::numbers_text;
using robot_files::RigidMass;
using robot_files::text_of;
using robot_files::without;
using tinyxml2::XMLElement;

void put(XMLElement& element, const char* attribute, double value) {
  element.SetAttribute(attribute, number_text(value).c_str());
}

template <class Spec>
const Spec* spec_called(const std::vector<Spec>& specs, const std::string& name) {
  const auto found = std::find_if(specs.begin(), specs.end(), [&](const Spec& one) { return one.name == name; });
  return found == specs.end() ? nullptr : &*found;
}

bool same_mass(const BodySpec& a, const BodySpec& b) {
  return a.mass == b.mass && a.com == b.com && matrix_of(a.inertia) == matrix_of(b.inertia);
}

/// The file from which a robot was read, with other numbers.
class FileEditor {
 public:
  FileEditor(const RobotSpec& wanted, const File& file, const RobotSpec& read)
      : wanted_(wanted), file_(file), read_(read) {}

  void edit(XMLElement& root) {
    for (XMLElement* section = root.FirstChildElement("worldbody"); section;
         section = section->NextSiblingElement("worldbody"))
      edit_inside(*section);
    for (XMLElement* section = root.FirstChildElement("actuator"); section;
         section = section->NextSiblingElement("actuator"))
      for (XMLElement* one = section->FirstChildElement(); one; one = one->NextSiblingElement()) edit_actuator(*one);
  }

 private:
  void edit_inside(XMLElement& element) {
    for (XMLElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
      const std::string_view name = child->Name();
      if (name == "joint") edit_joint(*child);
      if (name == "body") edit_body(*child);
      if (name == "body" || name == "frame") edit_inside(*child);
    }
  }

  void edit_body(XMLElement& element) {
    const char* written = element.Attribute("name");
    const auto found = file_.body_of_name.find(written ? written : "");
    if (found == file_.body_of_name.end()) return;
    const std::string& name = file_.bodies[found->second].name;
    const BodySpec *wanted = spec_called(wanted_.bodies, name), *before = spec_called(read_.bodies, name);
    if (!wanted || !before || same_mass(*wanted, *before)) return;
    RigidMass own{wanted->mass, wanted->com, matrix_of(wanted->inertia)};
    if (const std::optional<RigidMass> others = carried_by(found->second)) own = without(own, *others);
    if (own.mass > 0.0 && robot_files::can_be(own.inertia)) put_inertial(element, own);
  }

  /// Mass of the bodies without joints inside it, in its frame.
  std::optional<RigidMass> carried_by(std::size_t carrier) const {
    std::vector<RigidMass> parts;
    std::vector<std::pair<std::size_t, Pose>> open = {{carrier, {}}};
    while (!open.empty()) {
      const auto [body, pose] = open.back();
      open.pop_back();
      for (std::size_t i = 1; i < file_.bodies.size(); ++i) {
        const Body& one = file_.bodies[i];
        if (one.parent != body || i == body || !one.joints.empty()) continue;
        open.emplace_back(i, pose * one.pose);
        if (one.mass) parts.push_back(moved(*one.mass, pose * one.pose));
      }
    }
    return parts.empty() ? std::nullopt : std::optional(joined(parts));
  }

  const Joint* joint_in_file(const std::string& written) const {
    const auto found = file_.joint_of_name.find(written);
    return found == file_.joint_of_name.end() ? nullptr
                                              : &file_.bodies[found->second.first].joints[found->second.second];
  }

  double written_angle(const Joint& joint, double value) const {
    const double counted = value + joint.reference;
    return joint.kind == JointKind::hinge && file_.settings.degrees ? counted * 180.0 / std::numbers::pi : counted;
  }

  void edit_joint(XMLElement& element) {
    const char* written = element.Attribute("name");
    const Joint* joint = joint_in_file(written ? written : "");
    if (!joint) return;
    const JointSpec *wanted = spec_called(wanted_.joints, joint->name),
                    *before = spec_called(read_.joints, joint->name);
    if (!wanted || !before || wanted->kind != before->kind) return;
    const std::pair<const char*, double JointSpec::*> plain[] = {{"damping", &JointSpec::damping},
                                                                 {"frictionloss", &JointSpec::dry_friction},
                                                                 {"stiffness", &JointSpec::stiffness},
                                                                 {"armature", &JointSpec::armature}};
    for (const auto& [attribute, value] : plain)
      if (wanted->*value != before->*value) put(element, attribute, wanted->*value);
    if (wanted->rest != before->rest) put(element, "springref", written_angle(*joint, wanted->rest));
    if (wanted->lower == before->lower && wanted->upper == before->upper) return;
    if (!std::isfinite(wanted->lower) || !std::isfinite(wanted->upper)) return;
    element.SetAttribute(
        "range", numbers_text({written_angle(*joint, wanted->lower), written_angle(*joint, wanted->upper)}).c_str());
    element.SetAttribute("limited", "true");
  }

  static bool same_law(const ActuatorSpec& a, const ActuatorSpec& b) {
    return a.gain == b.gain && a.offset == b.offset && a.kp == b.kp && a.kd == b.kd && a.force_limit == b.force_limit &&
           a.command_lower == b.command_lower && a.command_upper == b.command_upper;
  }

  void edit_actuator(XMLElement& element) {
    const char* written = element.Attribute("name");
    const std::string name = written ? written : "";
    const ActuatorSpec *wanted = spec_called(wanted_.actuators, name), *before = spec_called(read_.actuators, name);
    if (!wanted || !before || wanted->kind != before->kind || same_law(*wanted, *before)) return;
    const char* joint = element.Attribute("joint");
    const Joint* driven = joint_in_file(joint ? joint : "");
    if (driven) put_actuator(element, *wanted, driven->reference);
  }

  const RobotSpec& wanted_;
  const File& file_;
  const RobotSpec& read_;
};

void put_range(XMLElement& element, const char* range, const char* flag, double lower, double upper) {
  const bool is_limited = std::isfinite(lower) && std::isfinite(upper);
  element.SetAttribute(flag, is_limited);
  if (is_limited) element.SetAttribute(range, numbers_text({lower, upper}).c_str());
}

}  // namespace

void put_inertial(XMLElement& body, const RigidMass& mass) {
  XMLElement* inertial = body.FirstChildElement("inertial");
  if (!inertial) {
    inertial = body.GetDocument()->NewElement("inertial");
    body.InsertFirstChild(inertial);
  }
  for (const char* other : {"fullinertia", "euler", "axisangle", "xyaxes", "zaxis"}) inertial->DeleteAttribute(other);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(mass.inertia);
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
  const Eigen::Quaterniond turn(axes);
  inertial->SetAttribute("pos", robot_files::vector_text(mass.com).c_str());
  inertial->SetAttribute("quat", numbers_text({turn.w(), turn.x(), turn.y(), turn.z()}).c_str());
  put(*inertial, "mass", mass.mass);
  inertial->SetAttribute("diaginertia", robot_files::vector_text(principal.eigenvalues()).c_str());
}

bool put_actuator(XMLElement& element, const ActuatorSpec& actuator, double reference) {
  double gain = actuator.gain, bias = actuator.offset, per_length = 0.0, per_velocity = 0.0;
  if (actuator.kind == ActuatorKind::position_servo) {
    gain *= actuator.kp;
    bias = actuator.kp * (actuator.offset + reference);
    per_length = -actuator.kp;
    per_velocity = -actuator.kd;
  } else if (actuator.kind == ActuatorKind::velocity_servo) {
    gain *= actuator.kd;
    bias *= actuator.kd;
    per_velocity = -actuator.kd;
  } else if (actuator.kind != ActuatorKind::force) {
    return false;
  }
  element.SetName("general");
  for (const char* other : {"kp", "kv", "dampratio", "gear", "class", "timeconst", "inheritrange"})
    element.DeleteAttribute(other);
  element.SetAttribute("dyntype", "none");
  element.SetAttribute("gaintype", "fixed");
  element.SetAttribute("gear", "1");
  put(element, "gainprm", gain);
  element.SetAttribute("biastype", "affine");
  element.SetAttribute("biasprm", numbers_text({bias, per_length, per_velocity}).c_str());
  double lower = (actuator.command_lower - actuator.offset) / actuator.gain;
  double upper = (actuator.command_upper - actuator.offset) / actuator.gain;
  if (lower > upper) std::swap(lower, upper);
  put_range(element, "ctrlrange", "ctrllimited", lower, upper);
  put_range(element, "forcerange", "forcelimited", -actuator.force_limit, actuator.force_limit);
  return true;
}

WrittenRobot write_mjcf(const RobotToWrite& robot) {
  WrittenRobot written;
  if (robot.original) {
    File file;
    const ReadRobot read = read_robot(*robot.original, file);
    written.problems = read.problems;
    if (!written.problems.empty()) return written;
    robot_files::XmlEditing editing(robot_files::without_late_declarations(robot.original->text));
    FileEditor(robot.robot, file, read.robot).edit(*editing.document().RootElement());
    written.text = editing.text(robot.comment);
    return written;
  }
  tinyxml2::XMLDocument document;
  XMLElement* root = document.NewElement("mujoco");
  document.InsertEndChild(root);
  make_file(robot.robot, *root, written.remarks);
  written.text = text_of(document, robot.comment);
  return written;
}

}  // namespace lacuna::mjcf

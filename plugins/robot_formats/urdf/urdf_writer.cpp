#include "urdf_writer.h"

#include "inertia_repair.h"
#include "urdf_elements.h"
#include "urdf_robot.h"
#include "xml_editing.h"
#include "xml_element.h"
#include "xml_writing.h"

#include <algorithm>
#include <map>

namespace lacuna::urdf {
namespace {

using robot_files::joined;
using robot_files::matrix_of;
using robot_files::moved;
using robot_files::text_of;
using robot_files::without;
using tinyxml2::XMLElement;

RigidMass mass_of_body(const BodySpec& body) { return {body.mass, body.com, matrix_of(body.inertia)}; }

bool same_mass(const BodySpec& a, const BodySpec& b) {
  return a.mass == b.mass && a.com == b.com && matrix_of(a.inertia) == matrix_of(b.inertia);
}

/// The file from which a robot was read, with other numbers.
class FileEditor {
 public:
  FileEditor(const RobotToWrite& wanted, const File& file, const RobotSpec& read)
      : wanted_(wanted.robot), file_(file), read_(read) {}

  void edit(XMLElement& root) {
    std::size_t link = 0, joint = 0;
    for (XMLElement* one = root.FirstChildElement("link"); one; one = one->NextSiblingElement("link"))
      links_[file_.links.at(link++).name] = one;
    for (XMLElement* one = root.FirstChildElement("joint"); one; one = one->NextSiblingElement("joint"))
      edit_joint(*one, file_.joints.at(joint++).name);
    for (const BodySpec& body : wanted_.bodies) edit_body(body);
  }

 private:
  void edit_joint(XMLElement& element, const std::string& name) {
    const auto called = [&](const JointSpec& one) { return one.name == name; };
    const auto wanted = std::find_if(wanted_.joints.begin(), wanted_.joints.end(), called);
    const auto before = std::find_if(read_.joints.begin(), read_.joints.end(), called);
    if (wanted == wanted_.joints.end() || before == read_.joints.end()) return;
    if (wanted->damping != before->damping || wanted->dry_friction != before->dry_friction)
      put_dynamics(element, *wanted);
    const double effort = effort_of(wanted_, name);
    if (effort != effort_of(read_, name) || wanted->lower != before->lower || wanted->upper != before->upper)
      put_limits(element, *wanted, effort);
  }

  /// The carrier gets the mass that the links fixed to it do not have.
  void edit_body(const BodySpec& body) {
    const BodySpec* before = body_called(read_, body.name);
    const auto element = links_.find(body.name);
    if (!before || element == links_.end() || same_mass(body, *before)) return;
    RigidMass own = mass_of_body(body);
    const std::vector<std::pair<std::string, RigidMass>> others = held_by(body.name);
    if (!others.empty()) {
      std::vector<RigidMass> masses;
      for (const auto& [name, mass] : others) masses.push_back(mass);
      const RigidMass rest = without(own, joined(masses));
      if (rest.mass > 0.0 && robot_files::can_be(rest.inertia))
        own = rest;
      else
        for (const auto& [name, mass] : others) empty(*links_.at(name));
    }
    put_inertial(*element->second, own);
  }

  static void empty(XMLElement& link) {
    if (XMLElement* inertial = link.FirstChildElement("inertial")) link.DeleteChild(inertial);
  }

  /// Links with a mass that are fixed to one, and their total in its frame.
  std::vector<std::pair<std::string, RigidMass>> held_by(const std::string& carrier) const {
    std::vector<std::pair<std::string, RigidMass>> held;
    std::vector<std::pair<std::string, Pose>> open = {{carrier, {}}};
    while (!open.empty()) {
      const auto [name, pose] = open.back();
      open.pop_back();
      for (const Joint& joint : file_.joints) {
        if (joint.parent != name || joint.type != JointType::fixed) continue;
        const Pose child = pose * joint.origin;
        open.emplace_back(joint.child, child);
        const auto link = std::find_if(file_.links.begin(), file_.links.end(),
                                       [&](const Link& one) { return one.name == joint.child; });
        if (link->mass && link->mass->mass > 0.0) held.emplace_back(joint.child, moved(possible(*link->mass), child));
      }
    }
    return held;
  }

  static RigidMass possible(RigidMass mass) {
    if (!robot_files::can_be(mass.inertia)) mass.inertia = robot_files::repaired(mass.inertia, mass.mass);
    return mass;
  }

  const RobotSpec& wanted_;
  const File& file_;
  const RobotSpec& read_;
  std::map<std::string, XMLElement*> links_;
};

}  // namespace

WrittenRobot write_urdf(const RobotToWrite& robot) {
  WrittenRobot written;
  if (!robot.original) {
    tinyxml2::XMLDocument document;
    document.InsertFirstChild(document.NewDeclaration());
    XMLElement* root = document.NewElement("robot");
    document.InsertEndChild(root);
    make_file(robot.robot, *root, written.remarks);
    written.text = text_of(document, robot.comment);
    return written;
  }
  const File file = read_file(robot.original->text, robot.original->base);
  const ReadRobot read = robot_of(file, robot.original->base);
  written.problems = read.problems;
  if (!written.problems.empty()) return written;
  robot_files::XmlEditing editing(robot_files::without_late_declarations(robot.original->text));
  FileEditor(robot, file, read.robot).edit(*editing.document().RootElement());
  written.text = editing.text(robot.comment);
  return written;
}

}  // namespace lacuna::urdf

#include "urdf_elements.h"
#include "xml_writing.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace lacuna::urdf {
namespace {

using robot_files::moved;
using robot_files::number_text;
using robot_files::vector_text;
using tinyxml2::XMLElement;

/// A file of its own: the frame of each link stands where its joint does.
class FileMaker {
 public:
  FileMaker(const RobotSpec& robot, std::vector<RobotRemark>& remarks) : robot_(robot), remarks_(remarks) {}

  void make(XMLElement& root) {
    root.SetAttribute("name", robot_.name.c_str());
    root.InsertNewChildElement("link")->SetAttribute("name", kWorld);
    for (const BodySpec& body : robot_.bodies) add_link(root, body);
    for (const JointSpec& joint : robot_.joints) add_joint(root, joint);
    add_commands(root);
  }

 private:
  void left_out(std::string text) { remarks_.push_back({RobotRemarkKind::left_out, 0, std::move(text), {}}); }

  const JointSpec* joint_of(const std::string& body) const {
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&](const JointSpec& one) { return one.child == body; });
    return found == robot_.joints.end() ? nullptr : &*found;
  }

  Pose frame_of(const std::string& name) const {
    const BodySpec* body = body_called(robot_, name);
    if (!body) return {};
    const JointSpec* joint = joint_of(name);
    return {joint ? joint->anchor : body->position, body->orientation};
  }

  void add_link(XMLElement& root, const BodySpec& body) {
    XMLElement& link = *root.InsertNewChildElement("link");
    link.SetAttribute("name", body.name.c_str());
    const Pose in_link = frame_of(body.name).inverse() * Pose{body.position, body.orientation};
    put_inertial(link, moved({body.mass, body.com, robot_files::matrix_of(body.inertia)}, in_link));
    if (!joint_of(body.name)) add_hold(root, body.name, "floating", kWorld, body.name + "_free");
    if (!body.shapes.empty()) left_out("the shapes of body " + body.name);
  }

  XMLElement& add_hold(XMLElement& root, const std::string& child, const char* type, const std::string& parent,
                       const std::string& name) {
    XMLElement& joint = *root.InsertNewChildElement("joint");
    joint.SetAttribute("name", name.c_str());
    joint.SetAttribute("type", type);
    joint.InsertNewChildElement("parent")->SetAttribute("link", parent.c_str());
    joint.InsertNewChildElement("child")->SetAttribute("link", child.c_str());
    const Pose pose = frame_of(parent).inverse() * frame_of(child);
    const Eigen::Matrix3d r = pose.orientation.normalized().toRotationMatrix();
    const double across = std::hypot(r(0, 0), r(1, 0));
    XMLElement& origin = *joint.InsertNewChildElement("origin");
    origin.SetAttribute("xyz", vector_text(pose.position).c_str());
    origin.SetAttribute(
        "rpy",
        vector_text(across < 1e-9 ? Eigen::Vector3d(std::atan2(-r(1, 2), r(1, 1)), std::atan2(-r(2, 0), across), 0.0)
                                  : Eigen::Vector3d(std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), across),
                                                    std::atan2(r(1, 0), r(0, 0))))
            .c_str());
    return joint;
  }

  void add_joint(XMLElement& root, const JointSpec& joint) {
    if (joint.kind == JointKind::universal || joint.kind == JointKind::ball)
      left_out("joint " + joint.name + " turns about several axes; it is written as a fixed joint");
    const bool is_limited = std::isfinite(joint.lower) && std::isfinite(joint.upper);
    const char* type = joint.kind == JointKind::hinge    ? (is_limited ? "revolute" : "continuous")
                       : joint.kind == JointKind::slider ? "prismatic"
                       : joint.kind == JointKind::free   ? "floating"
                                                         : "fixed";
    XMLElement& element = add_hold(root, joint.child, type, joint.parent, joint.name);
    if (joint.kind != JointKind::hinge && joint.kind != JointKind::slider) return;
    const Eigen::Vector3d axis = frame_of(joint.child).orientation.conjugate() * joint.axis;
    element.InsertNewChildElement("axis")->SetAttribute("xyz", vector_text(axis).c_str());
    put_limits(element, joint, effort_of(robot_, joint.name));
    put_dynamics(element, joint);
    for (const CouplingSpec& coupling : robot_.couplings) {
      if (coupling.joint != joint.name) continue;
      XMLElement& mimic = *element.InsertNewChildElement("mimic");
      mimic.SetAttribute("joint", coupling.follows.c_str());
      mimic.SetAttribute("multiplier", number_text(coupling.ratio).c_str());
      mimic.SetAttribute("offset", number_text(coupling.offset).c_str());
    }
  }

  /// Distinguishes joints without a motor from those with one, and servos from forces.
  void add_commands(XMLElement& root) {
    XMLElement& control = *root.InsertNewChildElement("ros2_control");
    control.SetAttribute("name", robot_.name.c_str());
    control.SetAttribute("type", "system");
    std::set<std::string> driven;
    for (const ActuatorSpec& actuator : robot_.actuators) {
      if (!driven.insert(actuator.joint).second) {
        left_out("actuator " + actuator.name + ": joint " + actuator.joint + " already has one");
        continue;
      }
      XMLElement& joint = *control.InsertNewChildElement("joint");
      joint.SetAttribute("name", actuator.joint.c_str());
      joint.InsertNewChildElement("command_interface")
          ->SetAttribute("name", actuator.kind == ActuatorKind::position_servo   ? "position"
                                 : actuator.kind == ActuatorKind::velocity_servo ? "velocity"
                                                                                 : "effort");
    }
  }

  const RobotSpec& robot_;
  std::vector<RobotRemark>& remarks_;
};

}  // namespace

void make_file(const RobotSpec& robot, XMLElement& root, std::vector<RobotRemark>& remarks) {
  FileMaker(robot, remarks).make(root);
}

}  // namespace lacuna::urdf

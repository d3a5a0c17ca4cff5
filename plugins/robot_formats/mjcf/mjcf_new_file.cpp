#include "mjcf_writer.h"
#include "xml_writing.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna::mjcf {
namespace {

using robot_files::matrix_of;
using robot_files::number_text;
using robot_files::numbers_text;
using robot_files::vector_text;
using tinyxml2::XMLElement;

/// A new file for a robot: the frames of bodies are those of the robot.
class NewFile {
 public:
  NewFile(const RobotSpec& robot, std::vector<RobotRemark>& remarks) : robot_(robot), remarks_(remarks) {
    for (const BodySpec& body : robot.bodies) children_[parent_of(body.name)].push_back(&body);
  }

  void make(XMLElement& mujoco) {
    mujoco.SetAttribute("model", robot_.name.c_str());
    XMLElement& compiler = *mujoco.InsertNewChildElement("compiler");
    compiler.SetAttribute("angle", "radian");
    compiler.SetAttribute("autolimits", "true");
    compiler.SetAttribute("inertiafromgeom", "false");
    mujoco.InsertNewChildElement("option")->SetAttribute("gravity", vector_text(robot_.gravity).c_str());
    XMLElement& world = *mujoco.InsertNewChildElement("worldbody");
    std::vector<std::pair<XMLElement*, std::string>> open = {{&world, kWorld}};
    while (!open.empty()) {
      const auto [element, name] = open.back();
      open.pop_back();
      for (const BodySpec* body : children_[name]) open.emplace_back(&add_body(*element, name, *body), body->name);
    }
    add_actuators(mujoco);
    add_sensors(mujoco);
    add_couplings(mujoco);
  }

 private:
  void left_out(std::string text) { remarks_.push_back({RobotRemarkKind::left_out, 0, std::move(text), {}}); }

  const JointSpec* joint_of(const std::string& body) const {
    const auto found = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&](const JointSpec& one) { return one.child == body; });
    return found == robot_.joints.end() ? nullptr : &*found;
  }
  std::string parent_of(const std::string& body) const {
    const JointSpec* joint = joint_of(body);
    return joint ? joint->parent : kWorld;
  }
  Pose pose_of_body(const std::string& name) const {
    for (const BodySpec& body : robot_.bodies)
      if (body.name == name) return {body.position, body.orientation};
    return {};
  }

  XMLElement& add_body(XMLElement& around, const std::string& parent, const BodySpec& body) {
    XMLElement& element = *around.InsertNewChildElement("body");
    elements_[body.name] = &element;
    element.SetAttribute("name", body.name.c_str());
    const Pose pose = pose_of_body(parent).inverse() * Pose{body.position, body.orientation};
    const Eigen::Quaterniond& q = pose.orientation;
    element.SetAttribute("pos", vector_text(pose.position).c_str());
    element.SetAttribute("quat", numbers_text({q.w(), q.x(), q.y(), q.z()}).c_str());
    put_inertial(element, {body.mass, body.com, matrix_of(body.inertia)});
    if (!body.shapes.empty()) left_out("the shapes of body " + body.name);
    const JointSpec* joint = joint_of(body.name);
    if (!joint)
      element.InsertNewChildElement("freejoint")->SetAttribute("name", (body.name + "_free").c_str());
    else
      add_joint(element, body, *joint);
    return element;
  }

  void add_joint(XMLElement& element, const BodySpec& body, const JointSpec& joint) {
    if (joint.kind == JointKind::fixed) return;
    if (joint.kind == JointKind::free) {
      element.InsertNewChildElement("freejoint")->SetAttribute("name", joint.name.c_str());
      return;
    }
    if (joint.kind == JointKind::universal) left_out("joint " + joint.name + " is written as two hinges");
    add_axis(element, body, joint, joint.name, joint.axis);
    if (joint.kind == JointKind::universal) add_axis(element, body, joint, joint.name + "_2", joint.axis2);
  }

  void add_axis(XMLElement& element, const BodySpec& body, const JointSpec& joint, const std::string& name,
                const Eigen::Vector3d& axis) {
    XMLElement& one = *element.InsertNewChildElement("joint");
    const Eigen::Quaterniond back = body.orientation.conjugate();
    one.SetAttribute("name", name.c_str());
    one.SetAttribute("type", joint.kind == JointKind::slider ? "slide"
                             : joint.kind == JointKind::ball ? "ball"
                                                             : "hinge");
    one.SetAttribute("pos", vector_text(back * (joint.anchor - body.position)).c_str());
    one.SetAttribute("axis", vector_text(back * axis).c_str());
    const std::pair<const char*, double> laws[] = {{"damping", joint.damping},
                                                   {"frictionloss", joint.dry_friction},
                                                   {"stiffness", joint.stiffness},
                                                   {"springref", joint.rest},
                                                   {"armature", joint.armature}};
    for (const auto& [attribute, value] : laws)
      if (value != 0.0) one.SetAttribute(attribute, number_text(value).c_str());
    if (std::isfinite(joint.lower) && std::isfinite(joint.upper))
      one.SetAttribute("range", numbers_text({joint.lower, joint.upper}).c_str());
  }

  void add_actuators(XMLElement& mujoco) {
    XMLElement& section = *mujoco.InsertNewChildElement("actuator");
    for (const ActuatorSpec& actuator : robot_.actuators) {
      XMLElement& element = *section.InsertNewChildElement("general");
      element.SetAttribute("name", actuator.name.c_str());
      element.SetAttribute("joint", actuator.joint.c_str());
      if (put_actuator(element, actuator, 0.0)) continue;
      left_out("actuator " + actuator.name + ": MJCF has no such kind");
      section.DeleteChild(&element);
    }
  }

  static const char* word_of(SensorKind kind) {
    switch (kind) {
      case SensorKind::joint_position: return "jointpos";
      case SensorKind::joint_velocity: return "jointvel";
      case SensorKind::drive_force: return "jointactuatorfrc";
      case SensorKind::body_position: return "framepos";
      case SensorKind::body_orientation: return "framequat";
      case SensorKind::body_velocity: return "framelinvel";
      case SensorKind::body_angular_velocity: return "frameangvel";
      case SensorKind::accelerometer: return "accelerometer";
      default: return nullptr;
    }
  }

  void add_sensors(XMLElement& mujoco) {
    XMLElement& section = *mujoco.InsertNewChildElement("sensor");
    for (const SensorSpec& sensor : robot_.sensors) {
      const char* kind = word_of(sensor.kind);
      if (!kind) {
        left_out("sensor " + sensor.name + ": MJCF has no such kind");
        continue;
      }
      XMLElement& element = *section.InsertNewChildElement(kind);
      element.SetAttribute("name", sensor.name.c_str());
      const std::string_view word = kind;
      if (word.starts_with("joint")) {
        element.SetAttribute("joint", sensor.element.c_str());
      } else if (word.starts_with("frame")) {
        element.SetAttribute("objtype", "xbody");
        element.SetAttribute("objname", sensor.element.c_str());
      } else {
        XMLElement& site = *elements_.at(sensor.element)->InsertNewChildElement("site");
        site.SetAttribute("name", sensor.name.c_str());
        site.SetAttribute("pos", vector_text(sensor.at).c_str());
        element.SetAttribute("site", sensor.name.c_str());
      }
    }
  }

  void add_couplings(XMLElement& mujoco) {
    if (robot_.couplings.empty()) return;
    XMLElement& section = *mujoco.InsertNewChildElement("equality");
    for (const CouplingSpec& coupling : robot_.couplings) {
      XMLElement& element = *section.InsertNewChildElement("joint");
      element.SetAttribute("joint1", coupling.joint.c_str());
      element.SetAttribute("joint2", coupling.follows.c_str());
      element.SetAttribute("polycoef", numbers_text({coupling.offset, coupling.ratio, 0.0, 0.0, 0.0}).c_str());
    }
  }

  const RobotSpec& robot_;
  std::vector<RobotRemark>& remarks_;
  std::map<std::string, std::vector<const BodySpec*>> children_;
  std::map<std::string, XMLElement*> elements_;
};

}  // namespace

void make_file(const RobotSpec& robot, XMLElement& mujoco, std::vector<RobotRemark>& remarks) {
  NewFile(robot, remarks).make(mujoco);
}

}  // namespace lacuna::mjcf

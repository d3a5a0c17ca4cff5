#include "urdf_commands.h"

namespace lacuna::urdf {
namespace {

using robot_files::XmlElement;

/// "position", "hardware_interface/PositionJointInterface", "PositionJointInterface".
void add_interface(const XmlElement& element, std::string name, JointCommands& commands) {
  name.erase(0, name.rfind('/') + 1);
  if (name == "effort" || name == "EffortJointInterface")
    commands.interfaces.insert(Interface::effort);
  else if (name == "position" || name == "PositionJointInterface")
    commands.interfaces.insert(Interface::position);
  else if (name == "velocity" || name == "VelocityJointInterface")
    commands.interfaces.insert(Interface::velocity);
  else
    return;  // a gripper's or a sensor's
  if (commands.line == 0) commands.line = element.line();
}

std::string text_in(const XmlElement& element) {
  const char* text = element.xml().GetText();
  const std::vector<std::string_view> words = robot_files::words_of(text ? text : "");
  return words.empty() ? "" : std::string(words.front());
}

void read_ros2_control(const XmlElement& system, std::map<std::string, JointCommands>& all) {
  for (const XmlElement& joint : system.children("joint")) {
    JointCommands& commands = all[joint.required_text("name")];
    for (const XmlElement& one : joint.children("command_interface"))
      add_interface(one, one.required_text("name"), commands);
  }
}

void read_transmission(const XmlElement& transmission, std::map<std::string, JointCommands>& all) {
  for (const XmlElement& joint : transmission.children("joint")) {
    JointCommands& commands = all[joint.required_text("name")];
    for (const XmlElement& one : joint.children("hardwareInterface")) add_interface(one, text_in(one), commands);
    for (const XmlElement& actuator : transmission.children("actuator"))
      for (const XmlElement& reduction : actuator.children("mechanicalReduction")) {
        const std::optional<double> ratio = reduction.own_number();
        if (ratio && *ratio != 0.0) commands.reduction = *ratio;
      }
  }
}

}  // namespace

std::map<std::string, JointCommands> read_commands(const XmlElement& robot) {
  std::map<std::string, JointCommands> all;
  for (const XmlElement& element : robot.children())
    if (element.name() == "ros2_control")
      read_ros2_control(element, all);
    else if (element.name() == "transmission")
      read_transmission(element, all);
  return all;
}

}  // namespace lacuna::urdf

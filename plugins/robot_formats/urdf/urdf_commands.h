#pragma once

#include "xml_element.h"

#include <map>
#include <set>
#include <string>

namespace lacuna::urdf {

/// The quantity of a joint that a controller may command.
enum class Interface { effort, position, velocity };

/// The settings of <ros2_control> and <transmission> for a joint.
struct JointCommands {
  int line = 0;
  std::set<Interface> interfaces;
  double reduction = 1.0;  ///< motor turns per joint turn
};

/// By joint, as written. Empty: the file names no commands.
std::map<std::string, JointCommands> read_commands(const robot_files::XmlElement& robot);

}  // namespace lacuna::urdf

#pragma once

#include "xml_element.h"

#include <map>
#include <set>
#include <string>

namespace lacuna::urdf {

/// What a controller may command of a joint.
enum class Interface { effort, position, velocity };

/// What <ros2_control> and <transmission> say of a joint.
struct JointCommands {
  int line = 0;
  std::set<Interface> interfaces;
  double reduction = 1.0;  ///< motor turns per joint turn
};

/// By joint, as written. Empty: the file says nothing of commands.
std::map<std::string, JointCommands> read_commands(const robot_files::XmlElement& robot);

}  // namespace lacuna::urdf

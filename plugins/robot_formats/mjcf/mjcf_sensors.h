#pragma once

#include "mjcf_file.h"

namespace lacuna::mjcf {

/// The relation of a body of the file to one of the robot.
struct Carried {
  std::string body;  ///< of the robot; the world's name: it is fixed
  Pose pose;         ///< in that body's frame
};

/// Sensors that the program supports: of joints, of bodies, accelerometers at sites along the body's axes. The others
/// are named in one remark. `carried` is by body of the file.
std::vector<SensorSpec> read_sensors(const Document& document, const std::vector<Carried>& carried, File& file);

}  // namespace lacuna::mjcf

#pragma once

#include "mjcf_file.h"

namespace lacuna::mjcf {

/// How a body of the file moves with one of the robot.
struct Carried {
  std::string body;  ///< of the robot; the world's name: it stands still
  Pose pose;         ///< in that body's frame
};

/// Sensors that the program has: of joints, of bodies, accelerometers at sites along the body's axes. The others are
/// named in one remark. `carried` is by body of the file.
std::vector<SensorSpec> read_sensors(const Document& document, const std::vector<Carried>& carried, File& file);

}  // namespace lacuna::mjcf

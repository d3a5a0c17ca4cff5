#pragma once

#include <lacuna/robot_definition.h>

namespace lacuna {

/// A robot that is written down in a TOML file: the host reads the file, this plugin hands it on.
class Declared : public RobotDefinition {
 public:
  std::string summary() const override;
  /// Throws `Error` where the experiment names no robot file.
  RobotSpec build(const RobotRequest& request) const override;
};

}  // namespace lacuna

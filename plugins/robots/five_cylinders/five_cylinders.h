#pragma once

#include <lacuna/robot_definition.h>

namespace lacuna {

/// The target of J. Bongard, H. Lipson, "Automatic Synthesis of Multiple Internal Models Through Active Exploration",
/// experiment 2: three spinal cylinders and two arms, flat on the ground, four motorised hinges, touch, angle and range
/// sensors. The README tells geometry and conventions.
class FiveCylinders : public RobotDefinition {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  /// Throws `Error` for a number of beacons that is none of 0 to 4.
  RobotSpec build(const RobotRequest& request) const override;
};

}  // namespace lacuna

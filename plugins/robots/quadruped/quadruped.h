#pragma once

#include <lacuna/robot_definition.h>

namespace lacuna {

/// The quadruped of J. Bongard, H. Lipson, "Automatic Synthesis of Multiple Internal Models Through
/// Active Exploration", experiment 1: a torso, four legs of two parts, eight motorised hinges, touch sensors
/// on the lower legs and angle sensors at the knees. The README tells geometry and conventions.
class Quadruped : public RobotDefinition {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  RobotSpec build(const RobotRequest& request) const override;
};

}  // namespace lacuna

#pragma once

#include "evaluation/model/model_definition.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// A model with its fitted values: the part that a robot file can hold, and the rest.
struct IdentifiedRobot {
  RobotSpec robot;     ///< with the fitted values, and with effects that only change values of the robot
  EffectList effects;  ///< the other effects; `start` has their values, `fixed` all of their parameters

  struct Absorbed {
    std::string effect;                  ///< "viscous_friction @ joint.hinge"
    std::vector<std::string> addresses;  ///< changed values: "joint.hinge.damping"
  };
  std::vector<Absorbed> absorbed;

  /// Values of single setups, which no robot has: "body.load.mass@heavy".
  std::vector<std::pair<std::string, double>> of_setups;
};

/// `values` are those of `definition.free`, in that order. Effects become values of the robot where the remaining
/// effects then act on it as before; else all remain effects.
IdentifiedRobot identified_robot(const ModelDefinition& definition, std::span<const double> values);

}  // namespace lacuna

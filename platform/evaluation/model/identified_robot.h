#pragma once

#include "evaluation/model/model_definition.h"

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// A model with its fitted values: what a robot file can hold of it, and the rest.
struct IdentifiedRobot {
  RobotSpec robot;     ///< with the values in place, and with effects that are nothing but values of the robot
  EffectList effects;  ///< the other effects; `start` has their values, `fixed` all of their parameters

  struct Absorbed {
    std::string effect;                  ///< "viscous_friction @ joint.hinge"
    std::vector<std::string> addresses;  ///< what it changed: "joint.hinge.damping"
  };
  std::vector<Absorbed> absorbed;

  /// Values that belong to some trials alone, which no robot has: "body.load.mass@heavy".
  std::vector<std::pair<std::string, double>> of_setups;
};

/// `values` are those of `definition.free`, in that order. Effects are taken into the robot where the others then do to
/// it what they did before; else all remain effects.
IdentifiedRobot identified_robot(const ModelDefinition& definition, std::span<const double> values);

}  // namespace lacuna

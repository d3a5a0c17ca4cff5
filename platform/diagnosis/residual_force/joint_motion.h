#pragma once

#include "diagnosis/noise/base_solution.h"
#include "diagnosis/noise/force_responses.h"
#include "fitting/start_states.h"

#include <string>
#include <vector>

namespace lacuna {

/// What a joint did at every pulse of every segment, as the measurements tell it: what an unmodelled force may follow.
struct JointMotion {
  std::string joint;          ///< without "joint."
  std::size_t index = 0;      ///< of the force responses
  std::string position_unit;  ///< rad or m
  std::string force_unit;     ///< N*m or N
  std::string command_unit;   ///< of the joint's actuator; empty: it has none
  /// By segment, a value a pulse: rad or m, rad/s or m/s, the actuator's unit. `command` is empty without an actuator.
  std::vector<Eigen::VectorXd> position, velocity, command;
};

/// The motions of the joints of `forces`. `states` tells positions and velocities from the measurements around a pulse.
std::vector<JointMotion> joint_motions(const BaseSolution& base, const RobotSpec& robot,
                                       const std::vector<Coordinate>& coordinates, const StartStates& states,
                                       const ForceResponses& forces);

}  // namespace lacuna

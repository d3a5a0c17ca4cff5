#pragma once

#include <lacuna/robot_spec.h>

#include "simulation/ode/bodies.h"
#include "simulation/ode/coordinate_law.h"
#include "simulation/shared/joint_tree.h"

#include <memory>
#include <span>

namespace lacuna::ode {

/// The step of a whole robot in the place of ODE's: the equations that dWorldStep solves (constraint rows with the
/// world's ERP and CFM, implicit gyroscopic torque, semi-implicit Euler), to rounding, by shorter ways that some robots
/// allow.
class RobotStep {
 public:
  virtual ~RobotStep() = default;

  /// Moves the bodies by one step under the forces that ODE has gathered for them, gravity and `laws`. Returns the
  /// coordinates' velocities, along their axes at the step's start; `before`: those of then.
  virtual std::span<const double> advance(std::span<const CoordinateLaw> laws, std::span<const double> before) = 0;
};

/// For a robot whose bodies stand at their zero poses in ODE's world; null where only ODE can step it. `step`: of the
/// integration, s; `laws`: the most that a step can have.
std::unique_ptr<RobotStep> make_robot_step(const RobotSpec& robot, const simulation::JointTree& tree,
                                           const Bodies& bodies, dWorldID world, double step, std::size_t laws);

}  // namespace lacuna::ode

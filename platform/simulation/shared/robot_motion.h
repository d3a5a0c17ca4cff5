#pragma once

#include <lacuna/error.h>
#include <lacuna/physical_effect.h>
#include <lacuna/test.h>

#include "simulation/shared/load_source.h"
#include "simulation/shared/sensor_bank.h"
#include "simulation/shared/state_archive.h"

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lacuna::simulation {

/// Thrown out of a step that leaves a motion in no state to go on with: it must be dropped.
class EngineFailure : public Error {
 public:
  using Error::Error;
};

/// What happens in one step.
struct StepOrder {
  double begin = 0.0;                ///< s
  std::span<const double> commands;  ///< per actuator, mean over the step, as its law gets it
  std::span<const double> rates;     ///< per actuator, by how much the command changes in a second
  LoadSource* loads = nullptr;       ///< null: nothing acts besides
};

/// A robot in motion, as an engine integrates it. Belongs to one workspace.
class RobotMotion {
 public:
  virtual ~RobotMotion() = default;

  /// Takes over the numbers of a robot, which must outlive their use. Throws `Error` for numbers that it cannot move.
  virtual void build(const RobotSpec& robot) = 0;
  /// Puts it at joint coordinates and velocities; bodies that float are at their zero pose, at rest.
  virtual void begin(const StartState& start) = 0;

  /// The state now. Bodies are shown only where they are asked for.
  virtual const StepView& look(double time, bool at_bodies) = 0;
  /// Moves it through one step. Throws `Error` that names what exploded or is not finite.
  virtual void advance(const StepOrder& order) = 0;

  /// Of the last step.
  virtual SensedForces sensed_forces() const = 0;
  virtual Eigen::Vector3d centre_of_mass() const = 0;  ///< of all bodies, world, m

  /// Names and sizes of what `save` writes, in its order.
  virtual std::vector<std::pair<std::string, std::size_t>> sections() const = 0;
  virtual void save(StateWriter& writer) const = 0;
  virtual void load(StateReader& reader) = 0;
};

}  // namespace lacuna::simulation

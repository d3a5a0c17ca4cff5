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

/// Thrown by a step that leaves a motion in an unusable state: it must be dropped.
class EngineFailure : public Error {
 public:
  using Error::Error;
};

/// Input of one step.
struct StepOrder {
  double begin = 0.0;                ///< s
  std::span<const double> commands;  ///< per actuator, mean over the step, as passed to its law
  std::span<const double> rates;     ///< per actuator, change of the command per second
  LoadSource* loads = nullptr;       ///< null: no additional loads
};

/// A robot in motion, as an engine integrates it. Belongs to one workspace.
class RobotMotion {
 public:
  virtual ~RobotMotion() = default;

  /// Takes the numbers of a robot, which must outlive their use. Throws `Error` for numbers that the engine cannot
  /// simulate.
  virtual void build(const RobotSpec& robot) = 0;
  /// Sets joint coordinates and velocities; floating bodies are at their zero pose, at rest.
  virtual void begin(const StartState& start) = 0;

  /// The current state. Contains bodies only where they are requested.
  virtual const StepView& look(double time, bool at_bodies) = 0;
  /// Moves it through one step. Throws `Error` that names what exploded or is not finite.
  virtual void advance(const StepOrder& order) = 0;

  /// Of the last step.
  virtual SensedForces sensed_forces() const = 0;
  virtual Eigen::Vector3d centre_of_mass() const = 0;  ///< of all bodies, world, m

  /// Names and sizes of the parts that `save` writes, in its order.
  virtual std::vector<std::pair<std::string, std::size_t>> sections() const = 0;
  virtual void save(StateWriter& writer) const = 0;
  virtual void load(StateReader& reader) = 0;
};

}  // namespace lacuna::simulation

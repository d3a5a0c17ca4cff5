#pragma once

#include "simulation/shared/drive.h"
#include "simulation/shared/effect_runner.h"
#include "simulation/shared/engine_model.h"
#include "simulation/shared/model_instance.h"
#include "simulation/shared/robot_motion.h"
#include "simulation/shared/sensor_bank.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lacuna::simulation {

/// The parts of a simulation that are reused by the next, so that a step never allocates.
class EngineWorkspace : public Workspace {
 public:
  explicit EngineWorkspace(const EngineModel& model);

  const EngineModel& model() const { return model_; }

  /// Sets the values, amends the robot and builds it. Throws `Error` for values that are impossible for a robot.
  void build(std::span<const double> parameters, const ParameterSlots::Slots& slots);
  /// After a failure inside the engine: the next `build` makes a new motion.
  void drop_motion() { motion.reset(); }

  /// Names and sizes of the State's sections, in the order of `save`.
  std::vector<std::pair<std::string, std::size_t>> sections() const;
  void save(double origin, std::uint64_t step, State& state) const;
  /// The drive must be open, the motion built.
  void load(const State& state);
  /// Origin of the clock and steps since then.
  static std::pair<double, std::uint64_t> saved_clock(const State& state);

  // The parts, for the run that uses the workspace.
  ModelInstance instance;
  EffectRunner effects;
  SensorBank sensors;
  Drive drive;
  std::unique_ptr<RobotMotion> motion;
  StartState restart;                                          // without the coordinates that continue
  std::vector<double> commands, last_commands, command_rates;  // per actuator, as passed to its law
  std::vector<double> readings_before, output_row;             // per channel

 private:
  const EngineModel& model_;
};

}  // namespace lacuna::simulation

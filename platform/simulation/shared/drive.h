#pragma once

#include <lacuna/engine_settings.h>
#include <lacuna/test.h>

#include "simulation/shared/delay_line.h"
#include "simulation/shared/recorded_commands.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lacuna::simulation {

/// The source of the commands of one simulation: a recorded series or a controller. Gives each actuator the mean of its
/// delayed command over the coming step. Belongs to a workspace.
class Drive {
 public:
  /// `longest`: per actuator, the longest delay of any simulation.
  Drive(std::span<const Delay> longest, const EngineSettings& settings);

  /// Takes a test, which must outlive the simulation. Throws `Error` where it does not match the robot.
  void open_source(const Test& test, const RobotSpec& robot);
  /// Takes a simulation's delays. Throws `Error` for one that is longer than declared.
  void open_delays(const RobotSpec& robot);
  bool closed_loop() const { return controller_ != nullptr; }
  bool may_be_off() const { return may_be_off_; }
  std::size_t controller_state_size() const { return controller_state_.size(); }

  /// Whether the controller acts before step `step`.
  bool acts(std::uint64_t step) const;
  void act(double time, std::span<const double> sensors);
  /// Prepares the commands of step `step`, which begins at `time`; `first`: it is the first one.
  void begin_step(double time, bool first);
  /// Mean over the current step, delayed.
  double command(std::size_t actuator);
  /// The same over the step before a start at `time`, of recorded commands.
  double command_before(std::size_t actuator, double time);
  /// The command as sent, at `time` within the current step.
  double sent(std::size_t actuator, double time);

  void save_lines(StateWriter& writer) const;
  void load_lines(StateReader& reader);
  void save_controller(StateWriter& writer) const { writer.put(controller_state_); }
  void load_controller(StateReader& reader) { reader.get(controller_state_); }
  std::size_t lines_size() const;

 private:
  double recorded(std::size_t actuator, double step_begin);

  EngineSettings settings_;
  double h_;
  const Controller* controller_ = nullptr;
  bool may_be_off_ = false;
  RecordedCommands recorded_, sent_;  // two, because each is queried with ascending times
  double step_begin_ = 0.0;
  std::vector<Delay> delays_;
  std::vector<bool> of_step_end_;  // per actuator: uses its command at the end of a step, not the mean
  std::vector<DelayLine> lines_;
  std::vector<double> held_;  // per actuator, of the controller
  std::vector<double> controller_state_;
};

}  // namespace lacuna::simulation

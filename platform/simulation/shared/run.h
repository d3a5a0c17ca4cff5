#pragma once

#include "simulation/compiled_model.h"
#include "simulation/shared/engine_workspace.h"

namespace lacuna::simulation {

/// One simulation: prepares the workspace, steps, and fills the result.
class Run : private LoadSource {
 public:
  Run(const EngineModel& model, EngineWorkspace& workspace, const SimulationOptions& options, SimulationResult& result);

  /// Throws `Error` for arguments that do not match the model; a failure inside the simulation makes the result
  /// invalid.
  void carry_out(std::span<const double> parameters, const Test& test);

 private:
  void check_arguments(std::span<const double> parameters) const;
  void check_output_times(double start) const;
  void read_saved_clock();
  void prepare_result();

  void begin();
  void record_lateness();
  void begin_at_coordinates();
  void recall_commands();
  void restart();
  void advance();
  void add_loads(const StepView& view, double length, StepLoads& loads) override;
  void advance(const StepView& view, double length) override;
  void take_commands(const StepView& view);
  void take_command(std::size_t actuator, const StepView& view);
  /// An actuator's input for a command that was sent: after gain, offset, effects and limits.
  double received(std::size_t actuator, double sent, const StepView& view);
  void sense(double now);
  bool readings_wanted(double now) const;

  /// Writes the outputs up to `now`; false: the caller needs no more.
  bool write_outputs(double before, double now);
  void write_commands(double until);
  /// Adds noise and quantisation to the output row where they are requested.
  void impair(double now);
  void finish();
  void fail(const std::string& what);

  double time(std::uint64_t step) const { return origin_ + static_cast<double>(step) * h_; }

  const EngineModel& model_;
  EngineWorkspace& ws_;
  const SimulationOptions& options_;
  SimulationResult& result_;
  const double h_;
  const double tolerance_;  // s, below which two times are the same
  const bool look_at_bodies_;
  double origin_;
  std::uint64_t step_ = 0, last_step_ = 0;  // counted from origin_
  std::size_t next_output_ = 0, next_command_output_ = 0;
  Eigen::Vector3d centre_{0.0, 0.0, 0.0}, centre_before_{0.0, 0.0, 0.0};  // of mass, if recorded, m
};

}  // namespace lacuna::simulation

#pragma once

#include "simulation/compiled_model.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// A model, a test and the engine's settings, put together line by line, and run.
/// Its members are the values the engine gets; change them freely before `run`.
struct SimulationRun {
  explicit SimulationRun(RobotSpec robot, double step = 1e-3);

  ModelStructure structure;
  EngineSettings engine;
  Test test;
  std::vector<double> parameters;  ///< one for each of `structure.parameters`
  std::optional<SensorImperfections> imperfections;
  bool record_commands = false;

  /// Starts joint coordinates at these values.
  SimulationRun& from(std::vector<double> positions, std::vector<double> velocities);
  /// Commands of the actuators `names`, constant, or samples at `times` held.
  SimulationRun& command(const std::string& actuator, double value);
  SimulationRun& command(const std::string& actuator, const std::vector<double>& times,
                         const std::vector<double>& values, Hold hold);
  SimulationRun& place(const PhysicalEffect& effect, ElementKind kind, std::vector<int> elements,
                       std::vector<double> values);

  /// Readings at `times`, which start at the simulation's start. Throws `Error` unless it completes.
  SimulationResult run(const std::vector<double>& times) const;
  /// Goes on from a saved state.
  SimulationResult run(const std::vector<double>& times, const State& from) const;
  /// The channel's reading at time `end`.
  double last(const std::string& channel, double end) const;

 private:
  SimulationResult carry_out(const std::vector<double>& times, const State* from) const;
};

/// One channel of a time series. Throws `Error` if there is none of that name.
Eigen::VectorXd column(const TimeSeries& series, const std::string& channel);
Eigen::Vector3d last_vector(const TimeSeries& series, const std::string& sensor);

/// Expects |error(h)| ≤ `bound` and that halving the step at least halves the error, twice over, where it is above
/// rounding.
void expect_convergence(const std::function<double(double step)>& error, double step, double bound);

/// Expects that a run to `times.back()`, and one that is saved at `times[middle]` and continued in another
/// workspace, give the same bits: readings after the middle and the whole final state.
void expect_same_bits_after_restore(const SimulationRun& run, const std::vector<double>& times, std::size_t middle);

}  // namespace lacuna

#pragma once

#include <lacuna/engine_settings.h>
#include <lacuna/test.h>
#include <lacuna/time_series.h>

#include "foundation/processes/stop.h"
#include "simulation/model_structure.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The interface to engines: only `simulation/<engine>/` knows an engine. A model structure is compiled once;
/// simulations of it take only numbers.
namespace lacuna {

/// The complete state of a simulation: one flat vector, whose sections `StateLayout` names. Saving, restoring and
/// continuing is bit-identical to an uninterrupted run.
struct State {
  std::vector<double> values;
  bool operator==(const State&) const = default;
};

struct StateSection {
  /// "clock", "positions", "velocities", "bodies", "actuators", "effects", "sensors", "sensor_delays",
  /// "accelerometers", "commands"
  std::string name;
  std::size_t offset = 0;
  std::size_t size = 0;
};
using StateLayout = std::vector<StateSection>;

/// A joint coordinate: `joint.hinge`, or `joint.wrist.1`, `joint.wrist.2` where a joint has several.
struct Coordinate {
  std::string name;
  std::string unit;  ///< "rad" or "m"
};

/// White noise and quantisation of the sensors of a simulated target; `seed` keys a counter-based
/// generator, so that the same seed gives the same readings.
struct SensorImperfections {
  std::uint64_t seed = 0;
};

struct SimulationOptions {
  /// Where to start: a saved state, or else joint coordinates at `start_time`.
  const State* from = nullptr;
  StartState start;
  /// New coordinates at `restart_time`, with all memories as they are then; null: no restart. NaN coordinates continue
  /// as they are.
  const StartState* restart = nullptr;
  double restart_time = 0.0;  ///< s, on a step
  double start_time = 0.0;    ///< s; commands are functions of the same clock; a saved state has its own
  double end_time = 0.0;      ///< s; the last step begins before it
  std::span<const double>
      output_times;  ///< s, ascending, within [start_time, end_time]; readings between steps are interpolated linearly
  /// Called after each output sample with its readings; true abandons the simulation. Must not allocate.
  std::function<bool(std::size_t sample, std::span<const double> readings)> stop_when;
  std::optional<SensorImperfections>
      imperfections;  ///< none: ideal readings (delay, effects, scale and offset still apply)
  /// Also return the commands as sent (before delay, gain, effects), one row per output sample.
  bool record_commands = false;
  bool record_centre_of_mass = false;  ///< also return the whole robot's centre of mass, one row per output sample
  bool save_final_state = false;
  bool record_lateness = false;  ///< also return the delay of the readings
  /// A simulation is usually short and useless if incomplete: it ends more than a second after a request, by
  /// `Interrupted`; a time limit does not end it.
  Stop stop = {};
};

enum class Ending { completed, stopped, invalid };

struct SimulationResult {
  Ending ending = Ending::completed;
  std::string reason;         ///< why it is invalid, a sentence
  TimeSeries readings;        ///< output times × sensor channels; rows after an early end are NaN
  TimeSeries commands;        ///< if asked for
  TimeSeries centre_of_mass;  ///< if requested: x, y, z in the world, m
  State final_state;          ///< if asked for
  /// If requested: delay of each channel behind the motion at the start of the simulation, or at its restart, s.
  std::vector<double> lateness;
  std::uint64_t steps = 0;  ///< integration steps taken
};

/// Memory for simulations by one thread. Belongs to the model that made it.
class Workspace {
 public:
  virtual ~Workspace() = default;
};

/// Const and shared by threads, each with its own workspace. The same arguments give the same bits, whatever the
/// workspace did before.
class CompiledModel {
 public:
  virtual ~CompiledModel() = default;

  virtual const std::vector<Channel>& channels() const = 0;        ///< sensor channels, spec order
  virtual const std::vector<Coordinate>& coordinates() const = 0;  ///< joint coordinates
  virtual const StateLayout& state_layout() const = 0;             ///< without the controller's section
  /// Whether delays, lags or effects keep commands, readings or motion from earlier steps.
  virtual bool has_memory() const = 0;
  virtual double step() const = 0;  ///< s, of integration
  virtual std::unique_ptr<Workspace> make_workspace() const = 0;

  /// Simulates `test.drive` with the given parameter values. Throws `Error` for arguments that do not match the model
  /// (wrong counts, unknown actuator names). A failure inside the simulation (values out of their bounds, explosion,
  /// NaN, an engine error, an exception of an effect) makes the result `invalid` and leaves the workspace usable.
  /// `result` is overwritten and its memory reused.
  virtual void simulate(std::span<const double> parameters, const Test& test, const SimulationOptions& options,
                        Workspace& workspace, SimulationResult& result) const = 0;
};

/// The default engine of a robot: "articulated", but "ode" where bodies may touch the ground.
std::string engine_for(const RobotSpec& robot);

/// Compiles for the engine in the settings; the default is `engine_for` the robot with one substep. Throws `Error`:
/// unknown engine, addresses without a match, a robot that is not a forest, values out of bounds.
std::unique_ptr<CompiledModel> compile(ModelStructure structure, const EngineSettings& settings);

}  // namespace lacuna

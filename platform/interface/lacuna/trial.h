#pragma once

#include <lacuna/setup.h>
#include <lacuna/test.h>

#include <string>

namespace lacuna {

/// How a coordinate at the start of a trial is known.
enum class InitialKnowledge {
  given,      ///< the value is exact
  from_data,  ///< estimated from the first 50 ms, which are then not scored
  free        ///< fitted together with the parameters
};

/// One joint coordinate at the start: how it is known, and its value or first guess.
struct InitialValue {
  InitialKnowledge knowledge = InitialKnowledge::from_data;
  double position = 0.0;  ///< rad or m
  double velocity = 0.0;  ///< rad/s or m/s
};

/// One test carried out on the target.
struct Trial {
  std::string name;
  CommandSeries commands;  ///< as applied; channels have the names of the actuators
  TimeSeries measured;  ///< channels have the names of the sensors; NaN: not measured or masked; time starts near 0 s
  std::vector<InitialValue> initial;  ///< per joint coordinate; empty: all `from_data`
  std::vector<double> sensor_noise;   ///< declared standard deviation per measured channel, NaN where none is declared
  std::vector<double> command_noise;  ///< declared standard deviation per command channel, NaN where none is declared
  bool held_out = false;              ///< not used by any fit
  /// The control law that computed the commands from the readings, where it is known; shared by copies of the trial.
  std::shared_ptr<const Controller> controller;
  Setup setup = {};          ///< differences of the rig, as far as known
  bool closed_loop = false;  ///< models are driven by `controller` instead of by `commands`
  /// Path of the whole robot's centre of mass from external tracking: columns x, y, z, world frame, m; empty where
  /// there is none. Models are never scored by it.
  TimeSeries centre_of_mass;
};

}  // namespace lacuna

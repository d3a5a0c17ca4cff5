#pragma once

#include <lacuna/robot_spec.h>
#include <lacuna/trial.h>

#include "config/schema/experiment.h"
#include "evaluation/model/model_definition.h"
#include "fitting/starts/sensor_noise.h"
#include "foundation/work.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// The error of a right model's free run in one channel; channel unit, RMS over the scored time. The three parts add as
/// squares. A part without a valid disturbed run is NaN, and so is the total.
struct FloorValue {
  std::string channel;
  std::string unit;
  double sensor = 0.0;   ///< the sensor's own noise
  double input = 0.0;    ///< noise of the recorded commands, passed through the model
  double process = 0.0;  ///< unmodelled random force, passed through the model
  double total = 0.0;
  std::string origin;  ///< one sentence about all three
};

/// The floor of one trial, one value per measured channel.
struct TrialFloor {
  std::string trial;
  std::vector<FloorValue> channels;
};

struct RunPiece;

/// Where a trial's free run starts and restarts, and from which sample on it is scored.
struct ScoredStart {
  const std::vector<RunPiece>* pieces = nullptr;  ///< of the run (free_run.h)
  Eigen::Index first_scored = 0;
};

/// The input of the floor.
struct NoiseFloorTask {
  const ModelDefinition& definition;
  const CompiledModel& model;
  const std::vector<Trial>& trials;
  const NoiseSection& noise;
  const std::vector<double>& values;         ///< the model's free values
  const std::vector<ChannelNoise>& sensors;  ///< of every measured channel
  const std::vector<ScoredStart>& starts;    ///< one a trial
  std::uint64_t seed = 1;
  Work work = {};
};

/// The noise floor of every trial. Declared command noise and declared random forces are passed through the model by
/// `kNoiseDraws` disturbed simulations per trial; random forces act through additional force actuators in a second
/// compiled copy of the model. The sizes are declared or measured channel by channel, not estimated together (METHOD
/// step 1). Throws `Error` for patterns that match no joint.
std::vector<TrialFloor> noise_floor(const NoiseFloorTask& task);

inline constexpr int kNoiseDraws = 24;  ///< an RMS of independent draws is then good to about 15 %

}  // namespace lacuna

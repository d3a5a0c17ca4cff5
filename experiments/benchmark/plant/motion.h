#pragma once

#include "plant/simulation.h"

namespace hidden_effects {

/// A trial as it went, evenly spaced from its start to its last sample.
struct Motion {
  double interval = 0.0;                      ///< s
  int steps_a_sample = 1;                     ///< how many of these lie between two samples
  std::vector<std::vector<double>> position;  ///< by joint, rad or m
  std::vector<std::vector<double>> velocity;  ///< by joint
};

/// Where a trial begins, joint by joint.
struct Start {
  Coordinates position, velocity;
};

/// Carries a trial out. Keeps one motion every `keep` integration steps, or fewer where `keep` does not divide the
/// steps of a sample. A plant that runs away (not finite, or faster than 1e4 a second) ends in `std::runtime_error`.
Motion simulate(Simulation& plant, const Start& start, std::size_t samples, int keep);

/// What the sensors say of it, without noise: by sensor, one number a sample.
std::vector<std::vector<double>> read_sensors(const PlantSpec& spec, const Laws& laws, const Motion& motion);

}  // namespace hidden_effects

#pragma once

#include <lacuna/trial.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// How a quadruped is recorded: in the engine at a tenth of the model's step, on a ground that is not quite the
/// model's, with an effect that the model lacks.
struct QuadrupedTruth {
  std::string effects;       ///< as `[[model.effects]]` has them, inline; empty: nothing is hidden
  double stiffness = 2.2e4;  ///< N/m, of the ground; the model has 2e4
  double damping = 340.0;    ///< N·s/m; the model has 300
  double noise = 2e-3;       ///< of the knees' angles, in their unit of 30°
  std::uint64_t seed = 1;
};

/// The experiment of the model; its torso's mass is free. `files`: names of recordings, "0.csv" ...
std::string quadruped_experiment(std::size_t trials);

/// Trials of `duration` s from the pose in which it stands, each with commands of its own.
std::vector<Trial> quadruped_trials(const QuadrupedTruth& truth, std::size_t count, double duration);

}  // namespace lacuna

#pragma once

#include <lacuna/trial.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// A hopper on a vertical rail, and recordings of it that are integrated here, not by the engine: a trunk, a foot on a
/// springy leg with a linear motor, and the ground, from which the foot leaves with a share of its speed. The leg's
/// length and the foot's touch are measured; how high the trunk is, nobody knows after the start.
struct HopperTruth {
  double restitution = 0.0;  // of foot and ground
  double viscous = 0.0;      // N·s/m, of the leg, beside the model's
  double dry = 0.0;          // N, of the leg
  double noise = 2e-4;       // m
  std::uint64_t seed = 1;
};

inline constexpr double kHopperDrop = 0.15;  // m, of trunk and foot at the start

/// What an experiment file says of the model, which lacks whatever the truth has: its trunk's mass is free.
std::string hopper_model();
/// A whole experiment file on recordings named "0.csv", "1.csv" ...
std::string hopper_experiment(std::size_t trials);
/// The file "hopper.toml" that they declare the robot in.
std::string hopper_robot_file();

/// Trials of `duration` s, each from the same drop and with a motor program of its own.
std::vector<Trial> hopper_trials(const HopperTruth& truth, std::size_t count, double duration);

}  // namespace lacuna

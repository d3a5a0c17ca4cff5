#pragma once

#include "refit/plant_model.h"

namespace hidden_effects {

/// How the plant's state at a sample answers to small changes at the sample before and in between. A state is the
/// positions of all coordinates, their velocities, and what the laws remember.
struct LinearSample {
  Eigen::MatrixXd of_state;         ///< states × states
  Eigen::MatrixXd of_force_before;  ///< states × joints; a force that falls from 1 at the sample before to 0
  Eigen::MatrixXd of_force_after;   ///< states × joints; a force that rises from 0 to 1 at the sample
  Eigen::MatrixXd of_command;       ///< states × drives; a command that is held in between
};

/// A trial and its neighbourhood.
struct LinearTrial {
  int coordinates = 0, states = 0;
  std::vector<LinearSample> samples;         ///< one less than the trial has
  std::vector<std::vector<double>> reading;  ///< by sensor and sample: its derivative with respect to what it reads
};

/// A trial without random forces, its commands as the plant had them.
struct TrueTrial {
  Excitation excitation;
  Start start;
};

/// Differences between two flows from sample to sample, forces and commands moved by a standard deviation either way:
/// so dry friction counts as what it lets pass of a disturbance of that size. Sensors that shift or filter in time
/// count as if they did not; a command's own delay is left out, which moves white noise by that time and does no more.
LinearTrial linearised(const PlantModel& model, const Eigen::VectorXd& values, const TrueTrial& trial,
                       const std::vector<double>& force_deviations, const std::vector<double>& command_deviations,
                       double step);

}  // namespace hidden_effects

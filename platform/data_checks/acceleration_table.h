#pragma once

#include "data_checks/data_warning.h"
#include "fitting/starts/start_states.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// The accelerations in one channel of one trial: of parabolas through short stretches of a position, or of lines
/// through those of a velocity. Predictions that start from the measured state pass through the same functional, which
/// makes an error of that start nearly harmless.
struct ChannelAccelerations {
  std::size_t trial = 0;    ///< index into the table's trials
  Eigen::Index column = 0;  ///< of the trial's measured channels
  std::string channel;
  std::string unit;                      ///< of the accelerations, rad/s^2 or m/s^2
  int order = 2;                         ///< 2: the channel measures a position; 1: a velocity
  double deviation = 0.0;                ///< of a measured acceleration, from the sensor's noise
  Eigen::VectorXd measured;              ///< one a stretch
  Eigen::VectorXd uncommanded;           ///< predicted with all commands at zero
  Eigen::MatrixXd commanded;             ///< stretches × actuators: the part of the prediction due to each command
  Eigen::VectorXd position, velocity;    ///< of the joint, in the middle of the stretch
  std::vector<Eigen::Index> first;       ///< the stretch's first sample
  std::vector<Eigen::VectorXd> weights;  ///< weights of its samples in the functional

  Eigen::Index size() const { return measured.size(); }
  /// Stretches × actuators: the functional of the commands, delayed by `lag` s and integrated twice (for a velocity
  /// once); proportional to the acceleration of a constant inertia.
  Eigen::MatrixXd of_commands(const Trial& source, double lag) const;
};

struct AccelerationTable {
  std::vector<Trial> trials;                   ///< those fitted to
  double stretch = 0.0;                        ///< s
  std::vector<ChannelAccelerations> channels;  ///< by trial, then channel
  bool empty() const { return channels.empty(); }
};

/// Builds the table of every measured joint position and velocity, over stretches of 0.1 s, or 0.2 or 0.4 s where the
/// accelerations over shorter ones are below five times their noise. Stretches in which the joint rests or turns are
/// left out, since dry friction may hold any force there. Empty where a trial does not measure all of the model's
/// state. `noise`: one value per channel of the trials.
AccelerationTable acceleration_table(const DataCheckTask& task, const std::vector<ChannelNoise>& noise);

/// RMS of the measured accelerations, in multiples of their noise.
double clearness(const AccelerationTable& table);

}  // namespace lacuna

#pragma once

#include "data_checks/doubt.h"
#include "fitting/starts/start_states.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// What one channel of one trial says of accelerations: a parabola's through short stretches of a position, a line's
/// slope through those of a velocity. The same functional of a prediction that starts from the measured state is what
/// the model says, and an error of that start hardly changes it.
struct ChannelAccelerations {
  std::size_t trial = 0;    ///< index into the table's trials
  Eigen::Index column = 0;  ///< of the trial's measured channels
  std::string channel;
  std::string unit;                      ///< of the accelerations, rad/s^2 or m/s^2
  int order = 2;                         ///< 2: of a position; 1: of a velocity
  double deviation = 0.0;                ///< of a measured acceleration, from the sensor's noise
  Eigen::VectorXd measured;              ///< one a stretch
  Eigen::VectorXd uncommanded;           ///< predicted with all commands at zero
  Eigen::MatrixXd commanded;             ///< stretches × actuators: what each command adds to the prediction
  Eigen::VectorXd position, velocity;    ///< of the joint, in the middle of the stretch
  std::vector<Eigen::Index> first;       ///< the stretch's first sample
  std::vector<Eigen::VectorXd> weights;  ///< of its samples in the functional

  Eigen::Index size() const { return measured.size(); }
  /// Stretches × actuators: the functional of the twice (velocity: once) integrated commands, as they were `lag` s
  /// before; proportional to what forces do to a constant inertia.
  Eigen::MatrixXd of_commands(const Trial& source, double lag) const;
};

struct AccelerationTable {
  std::vector<Trial> trials;                   ///< those fitted to
  double stretch = 0.0;                        ///< s
  std::vector<ChannelAccelerations> channels;  ///< by trial, then channel
  bool empty() const { return channels.empty(); }
};

/// Of every measured joint position and velocity, over stretches of 0.1 s, or 0.2 or 0.4 s where the shorter ones do
/// not show five times their noise. Stretches in which the joint rests or turns are
/// left out, since dry friction may hold any force there. Empty where a trial does not measure all of the model's
/// state. `noise`: one a channel of the trials.
AccelerationTable acceleration_table(const DoubtTask& task, const std::vector<ChannelNoise>& noise);

/// RMS of the measured accelerations, in multiples of their noise.
double clearness(const AccelerationTable& table);

}  // namespace lacuna

#pragma once

#include "fitting/starts/start_states.h"
#include "prediction/random_walk_smoother.h"

#include <memory>
#include <optional>
#include <vector>

namespace lacuna {

/// Initial states at any sample of any trial, from all readings of the trial and without a model of the robot, so that
/// they favour no candidate. Coordinates of free joints come from the readings near the sample. Const and shared by
/// threads.
class SmoothedStarts {
 public:
  /// Throws `Error` where a trial has fewer than five readings of a coordinate.
  explicit SmoothedStarts(const StartStates& states, const std::vector<Trial>& trials);

  const StartStates& states() const { return states_; }
  /// Valid where every coordinate is determined.
  StartEstimate at(std::size_t trial, Eigen::Index sample) const;
  /// Moves the state at a sample along the smoothed motion, each coordinate by the delay of its readings. `lateness`:
  /// by measured channel, s.
  void move_later(std::size_t trial, Eigen::Index sample, const std::vector<double>& lateness, StartState& start) const;

  /// What the channels that determine coordinates would read a moment after a sample if its smoothed acceleration
  /// lasted, without noise; by measured channel, NaN for the others. `later`: s.
  Eigen::VectorXd readings_after(std::size_t trial, Eigen::Index sample, double later) const;

  /// Standard deviation of a position's reading as found by the smoother, in the channel's unit; NaN where it was not
  /// estimated.
  double reading_noise(std::size_t trial, Eigen::Index channel) const;

 private:
  /// Of a position and its velocity, rad or m, rad/s or m/s.
  struct Change {
    double position = 0.0, velocity = 0.0;
  };
  struct SmoothedCoordinate {
    /// Sign of the coordinate in the reading; a link's angle includes the joints before it.
    std::optional<SmoothedMotion> motion;
    std::vector<std::pair<int, double>> others;  ///< further coordinates in it, and their signs
  };

  /// Up to this number of seconds from the sample, within the recording.
  Change change_within(std::size_t trial, Eigen::Index sample, const SmoothedMotion& motion, double seconds) const;

  const StartStates& states_;
  const std::vector<Trial>& trials_;
  std::vector<std::vector<SmoothedCoordinate>> coordinates_;  ///< by trial and coordinate
  std::vector<std::vector<double>> noise_;                    ///< by trial and channel
};

}  // namespace lacuna

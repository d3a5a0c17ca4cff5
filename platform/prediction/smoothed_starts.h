#pragma once

#include "fitting/starts/start_states.h"
#include "prediction/random_walk_smoother.h"

#include <memory>
#include <optional>
#include <vector>

namespace lacuna {

/// Start states at any sample of any trial, from all of the trial's readings and no model of the robot: they favour no
/// candidate. Coordinates of free joints come from the readings near the sample. Const and shared by threads.
class SmoothedStarts {
 public:
  /// Throws `Error` where a trial has fewer than five readings of a coordinate.
  explicit SmoothedStarts(const StartStates& states, const std::vector<Trial>& trials);

  const StartStates& states() const { return states_; }
  /// Valid where every coordinate is told.
  StartEstimate at(std::size_t trial, Eigen::Index sample) const;
  /// Moves a start at a sample along the smoothed motion, each coordinate by as much as its readings are late.
  /// `lateness`: by measured channel, s.
  void move_later(std::size_t trial, Eigen::Index sample, const std::vector<double>& lateness, StartState& start) const;

  /// Standard deviation of a position's reading as the smoother found it, in the channel's unit; NaN where it was not
  /// looked at.
  double reading_noise(std::size_t trial, Eigen::Index channel) const;

 private:
  /// Of a position and its velocity, rad or m, rad/s or m/s.
  struct Change {
    double position = 0.0, velocity = 0.0;
  };
  struct SmoothedCoordinate {
    std::optional<SmoothedMotion> motion;  ///< of what the channel reads: of a link's angle with the joints before
    std::vector<std::pair<int, double>> others;  ///< further coordinates in it, and their signs
  };

  /// Within so many s from the sample, no further than the recording goes.
  Change change_within(std::size_t trial, Eigen::Index sample, const SmoothedMotion& motion, double seconds) const;

  const StartStates& states_;
  const std::vector<Trial>& trials_;
  std::vector<std::vector<SmoothedCoordinate>> coordinates_;  ///< by trial and coordinate
  std::vector<std::vector<double>> noise_;                    ///< by trial and channel
};

}  // namespace lacuna

#pragma once

#include "fitting/start_states.h"
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

  /// Standard deviation of a position's reading as the smoother found it, in the channel's unit; NaN where it was not
  /// looked at.
  double reading_noise(std::size_t trial, Eigen::Index channel) const;

 private:
  struct SmoothedCoordinate {
    std::optional<SmoothedMotion> motion;  ///< of what the channel reads: of a link's angle with the joints before
    std::vector<std::pair<int, double>> others;  ///< further coordinates in it, and their signs
  };

  const StartStates& states_;
  const std::vector<Trial>& trials_;
  std::vector<std::vector<SmoothedCoordinate>> coordinates_;  ///< by trial and coordinate
  std::vector<std::vector<double>> noise_;                    ///< by trial and channel
};

}  // namespace lacuna

#pragma once

#include <lacuna/trial.h>

#include <cstddef>
#include <vector>

namespace lacuna {

/// Finds out how large the noise of each sensor channel is: what trials declare, or else the root mean square of what
/// the best model leaves of them, then at least a thousandth of what the channel moves through or stands at.
class ReadingNoise {
 public:
  explicit ReadingNoise(std::size_t channels) : channels_(channels) {}

  /// A trial and what the best model says of it, as long as it. `map`: channel of the model's, for each of the trial's.
  void add(const Trial& trial, const std::vector<Eigen::Index>& map, const TimeSeries& predicted);
  /// Standard deviations in the channels' units; infinite for a channel that no trial measured, 0 for one that
  /// always read 0 where the model says so.
  std::vector<double> deviations() const;

 private:
  struct Tally {
    double squares = 0.0;
    double samples = 0.0;
    double declared = 0.0;
    double lowest = 0.0, highest = 0.0;  ///< measured
  };
  std::vector<Tally> channels_;
};

}  // namespace lacuna

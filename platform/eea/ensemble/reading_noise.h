#pragma once

#include <lacuna/trial.h>

#include <cstddef>
#include <vector>

namespace lacuna {

/// Estimates the noise of each sensor channel: as trials declare it, else the RMS residual of the best model, then at
/// least a thousandth of the channel's range or constant value.
class ReadingNoise {
 public:
  explicit ReadingNoise(std::size_t channels) : channels_(channels) {}

  /// A trial and the best model's prediction, of equal length. `map`: channel of the model for each of the trial's.
  void add(const Trial& trial, const std::vector<Eigen::Index>& map, const TimeSeries& predicted);
  /// Standard deviations in the channels' units; infinite for a channel that no trial measured, 0 for one that always
  /// read 0 as the model predicts.
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

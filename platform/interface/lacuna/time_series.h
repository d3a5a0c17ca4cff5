#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace lacuna {

/// A named column of a time series and its SI unit.
struct Channel {
  std::string name;
  std::string unit;
  bool operator==(const Channel&) const = default;
};

/// Sampled signals with a common clock.
struct TimeSeries {
  /// One row per sample, one column per channel.
  using Samples = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  std::vector<Channel> channels;  ///< size C
  Eigen::VectorXd times;          ///< s, strictly increasing, size N
  Samples samples;                ///< N × C; NaN where a measured series has no (usable) value
};

}  // namespace lacuna

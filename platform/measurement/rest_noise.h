#pragma once

#include <lacuna/trial.h>

#include <Eigen/Core>

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// Consecutive samples in which a channel does not move.
struct RestStretch {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

/// Periods of at least 0.1 s and 24 samples in which a channel shows only noise: no drift within and between windows,
/// and the scatter of neighbouring samples, so that a smooth vibration does not count. A velocity also rests while it
/// is constant. `quantum` is the quantiser's step, 0 if there is none. A window with a NaN is never at rest.
std::vector<RestStretch> find_rest(const Eigen::VectorXd& times, std::span<const double> values, double quantum);

/// Noise of one channel according to the recordings, in its unit.
struct SensorNoise {
  /// Standard deviation of a reading's error: the scatter at rest, at least quantum/√12. NaN if the channel never rests
  /// and its step, if it has one, is below 10⁻⁴ of its range.
  double standard_deviation = std::numeric_limits<double>::quiet_NaN();
  double at_rest = std::numeric_limits<double>::quiet_NaN();  ///< scatter at rest about the mean of each period
  double quantum = 0.0;                                       ///< step of the quantiser; 0: none found
  double rest_duration = 0.0;                                 ///< s, in all trials together
  double correlation = 0.0;                                   ///< between neighbouring readings at rest; 0: white
  /// The source of the figure: "encoder step 2.91 mrad/√12; rest agrees".
  std::string origin(const std::string& unit) const;
};

/// Noise of the measured channel with this name, from all trials that have it, by its own readings alone: rows of other
/// devices lie between them without effect. Noise slower than the rest periods is not included. Deterministic.
SensorNoise estimate_sensor_noise(const std::vector<Trial>& trials, const std::string& channel);

}  // namespace lacuna

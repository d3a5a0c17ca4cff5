#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lacuna {

/// A signal by the clock of the device that wrote it; finite, times ascending.
struct ClockedSignal {
  std::string name;
  std::string unit;           ///< SI
  bool is_reading = true;     ///< else a command
  bool held = false;          ///< a sample stays until the next
  std::vector<double> times;  ///< s
  std::vector<double> values;
};

/// How two clocks are to each other: time of the first = t + offset + skew·(t − first time of the second).
struct ClockAlignment {
  double offset = 0.0, offset_error = 0.0;  ///< s, and its standard error
  double skew = 0.0, skew_error = 0.0;      ///< 1
  std::string by;                           ///< the signal by which it was found
};

struct AlignmentTask {
  std::pair<double, double> between;  ///< s, where the offset is looked for
  double skew = 0.0;                  ///< known, or a first guess
  bool finds_skew = false;
};

/// Finds how the clocks of two devices that watched the same motion are to each other, or says why not.
///
/// At the right offset, the signals of one device follow from the other's readings best: a command from position,
/// velocity and acceleration (inverse dynamics), a reading from another of the same motion. Both are smoothed alike, so
/// that smoothing shifts neither, and noise of readings is taken out of their products by every other reading against
/// those between (blocked_regression.h). Of all signals the one that is explained best decides. Errors are those of a
/// jackknife over sixteen stretches of time, or what windows of other lengths say, if that is more; an offset that is
/// not distinctly better than another, as of a periodic motion, is refused. A delay of a drive or a sensor is part of
/// what is found.
std::variant<ClockAlignment, std::string> align_clocks(const std::vector<ClockedSignal>& first,
                                                       const std::vector<ClockedSignal>& second,
                                                       const AlignmentTask& task);

}  // namespace lacuna

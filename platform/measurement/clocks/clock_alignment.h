#pragma once

#include "foundation/processes/stop.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lacuna {

/// A signal with time stamps of the device that recorded it; finite, times ascending.
struct ClockedSignal {
  std::string name;
  std::string unit;           ///< SI
  bool is_reading = true;     ///< else a command
  bool held = false;          ///< a sample stays until the next
  std::vector<double> times;  ///< s
  std::vector<double> values;
};

/// Relation of two clocks: time of the first = t + offset + skew·(t − first time of the second).
struct ClockAlignment {
  double offset = 0.0, offset_error = 0.0;  ///< s, and its standard error
  double skew = 0.0, skew_error = 0.0;      ///< 1
  std::string by;                           ///< the signal that determined it
};

struct AlignmentTask {
  std::pair<double, double> between;  ///< s, search range of the offset
  double skew = 0.0;                  ///< known, or a first guess
  bool finds_skew = false;
  Stop stop = {};
};

/// Finds the relation of the clocks of two devices that recorded the same motion, or says why not.
///
/// At the right offset, the signals of one device follow best from the other's readings: a command from position,
/// velocity and acceleration (inverse dynamics), a reading from another of the same motion. Both are smoothed in the
/// same way, so that smoothing shifts neither. Noise of readings is removed from their products by using every other
/// reading against those between (blocked_regression.h). The signal that is explained best decides. Errors are those of
/// a jackknife over sixteen blocks of time, or the difference to windows of other lengths if that is larger; an offset
/// that is not clearly better than another, as for a periodic motion, is refused. The offset includes any delay of a
/// drive or a sensor. Throws `Interrupted`.
std::variant<ClockAlignment, std::string> align_clocks(const std::vector<ClockedSignal>& first,
                                                       const std::vector<ClockedSignal>& second,
                                                       const AlignmentTask& task);

}  // namespace lacuna

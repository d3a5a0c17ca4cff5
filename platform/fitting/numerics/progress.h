#pragma once

#include <functional>
#include <limits>
#include <string>

namespace lacuna {

/// Progress of long work; called from the thread that started the work.
struct Progress {
  std::string what;                                                ///< "segments of 0.5 s, start 2 of 4"
  double fraction = 0.0;                                           ///< 0 ... 1, an estimate
  double seconds_left = std::numeric_limits<double>::quiet_NaN();  ///< an estimate; NaN while it is unknown
};
using ProgressCallback = std::function<void(const Progress&)>;

}  // namespace lacuna

#pragma once

#include "foundation/processes/stop.h"

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

/// The means and limits of one piece of long work. It is handed on to every part of the work. Results do not depend on
/// it, except for work that ends early.
struct Work {
  int threads = 1;
  Stop stop = {};  ///< what ends the work early
  ProgressCallback progress = {};

  /// For a part of the work that has no share in the reported progress.
  Work unreported() const { return {threads, stop, {}}; }
};

}  // namespace lacuna

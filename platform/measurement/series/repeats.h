#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// A sensor that is slower than the log, which repeats each reading until the next one.
struct Repeats {
  /// Readings of the log, usual number per reading of the sensor; 0: the sensor does not repeat.
  std::size_t every = 0;
  std::vector<std::size_t> repeated;  ///< indices of repetitions
};

/// Found where the values change at most at every other reading, at even intervals, and by more than a quantiser's
/// steps, which a slow motion shows, too. `values`: in order of time; NaN: missing.
Repeats find_repeats(std::span<const double> values);

}  // namespace lacuna

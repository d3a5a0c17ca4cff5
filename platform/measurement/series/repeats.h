#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// A sensor that is slower than the log, which repeats its reading until there is another one.
struct Repeats {
  std::size_t every = 0;              ///< readings of the log, the usual number between two of the sensor; 0: none
  std::vector<std::size_t> repeated;  ///< indices of what only repeats
};

/// Found where the values change every other reading at most, at even intervals, and by more than a quantiser's steps,
/// which a slow motion stays on, too. `values`: in order of time; NaN: missing.
Repeats find_repeats(std::span<const double> values);

}  // namespace lacuna

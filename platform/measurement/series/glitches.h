#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// Readings that leave the signal and return to its course, up to three in a row, by far more than it changes there and
/// than the other readings scatter. Impacts, steps, kicks and the largest swings are not glitches: they do not return
/// at once, or are no further away than their surroundings. All measures come from the other readings alone, so up to a
/// third may be glitches.
struct Glitches {
  std::vector<std::size_t> readings;  ///< indices of the column, ascending
  std::size_t of = 0;                 ///< readings in all
  bool may_be_motion = false;         ///< so many that start and end at one level, like pulses of a joint at rest
};

/// `times` ascend; NaN among `column`: missing.
Glitches find_glitches(std::span<const double> times, std::span<const double> column);

}  // namespace lacuna

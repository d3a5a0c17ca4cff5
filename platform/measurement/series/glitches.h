#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// Readings that leave the signal and come back to where it went on, up to three in a row, by far more than it changes
/// there and than the others are off its course. Impacts, steps, kicks and the largest swings are none: they do not
/// come back at once, or are no farther than what surrounds them. The measures are those of the other readings alone,
/// so that up to a third may be glitches.
struct Glitches {
  std::vector<std::size_t> readings;  ///< indices of the column, ascending
  std::size_t of = 0;                 ///< readings in all
  bool may_be_motion = false;         ///< so many that start and end at one level, as pulses of a joint that rests do
};

/// `times` ascend; NaN among `column`: missing.
Glitches find_glitches(std::span<const double> times, std::span<const double> column);

}  // namespace lacuna

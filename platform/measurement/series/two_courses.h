#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// For each reading the series it belongs to (0 or 1), such that each series changes as little as possible from one of
/// its readings to the next: minimises the sum of the distances to the extrapolation of its last two readings, by
/// dynamic programming. A reading of the second series costs `price` more, so that it gets few, and the series keep
/// their numbers where they cross. Readings of a single series are divided arbitrarily. `times` ascend; values are
/// finite.
std::vector<std::size_t> divide_in_two(std::span<const double> times, std::span<const double> values, double price);

}  // namespace lacuna

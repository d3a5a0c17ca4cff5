#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// For each reading which of two courses it belongs to (0 or 1), such that each course changes as little as can be from
/// one of its readings to the next: the sum of the distances to what its last two readings lead to is the least, by
/// dynamic programming. A reading of the second course costs `price` more, so that it has few, and the courses keep
/// their names where they cross. Readings of one course only are divided somehow. `times` ascend; values are finite.
std::vector<std::size_t> divide_in_two(std::span<const double> times, std::span<const double> values, double price);

}  // namespace lacuna

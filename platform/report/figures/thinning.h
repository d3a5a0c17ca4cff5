#pragma once

#include <cstddef>
#include <vector>

namespace lacuna {

/// Indices of `y` to draw so that a line of any length keeps its look on `columns` pixel columns:
/// first, last, smallest and largest sample of each column, and the NaN that ends a stretch.
std::vector<std::size_t> thinned(const std::vector<double>& y, std::size_t columns);

}  // namespace lacuna

#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// The known readings of a column, in order of time.
struct KnownReadings {
  std::vector<double> values;
  std::vector<std::size_t> places;  ///< of each in the column

  explicit KnownReadings(std::span<const double> column) {
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (!std::isfinite(column[i])) continue;
      values.push_back(column[i]);
      places.push_back(i);
    }
  }
};

}  // namespace lacuna

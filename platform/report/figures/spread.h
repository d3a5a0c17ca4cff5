#pragma once

#include <vector>

namespace lacuna {

/// Mean of several runs' figures, the standard deviation between them, and half the width of the mean's 95 % interval
/// (Student's t; infinite with a single run). NaNs are left out.
struct Spread {
  std::size_t count = 0;
  double mean = 0.0;
  double deviation = 0.0;
  double half_width = 0.0;
};
Spread spread_of(const std::vector<double>& values);

}  // namespace lacuna

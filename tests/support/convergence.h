#pragma once

#include <lacuna/time_series.h>

#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// How solutions of one problem come closer to each other as the step is halved.
struct Convergence {
  /// Root mean square, over all readings, of what each halving changes; readings of another size weigh alike.
  std::vector<double> changes;
  /// Slope of the changes' logarithm over that of the step, at the finest halvings that rounding leaves.
  double order = 0.0;
  /// Already the first halving changes nothing but rounding.
  bool exact = false;
};

/// `solution(k)`: readings, one column a channel, at the same times, with the step halved k = 0 … `halvings` times.
Convergence converge(const std::function<TimeSeries::Samples(int halving)>& solution, int halvings);

std::string to_string(const Convergence& convergence);

}  // namespace lacuna

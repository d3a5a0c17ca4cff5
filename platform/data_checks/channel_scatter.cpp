#include "data_checks/channel_scatter.h"

#include "measurement/line_departures.h"

#include <cmath>
#include <span>
#include <vector>

namespace lacuna {

double scatter_of(const TimeSeries& series, Eigen::Index channel) {
  const auto column = series.samples.col(channel);
  const std::vector<double> values(column.begin(), column.end());
  double squares = 0.0, count = 0.0;
  for (const double departure : line_departures(std::span(series.times.data(), values.size()), values)) {
    squares += departure * departure;
    count += 1.0;
  }
  return count == 0.0 ? 0.0 : std::sqrt(squares / count);
}

}  // namespace lacuna

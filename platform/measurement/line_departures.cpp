#include "measurement/line_departures.h"

#include "measurement/clocks/clock_check.h"
#include "measurement/series/known_readings.h"

#include <cmath>

namespace lacuna {
namespace {

constexpr double kPause = 5.0;  ///< median intervals over two readings: more is a gap

}  // namespace

OwnReadings::OwnReadings(std::span<const double> all_times, std::span<const double> all_values) {
  KnownReadings known(all_values);
  times.resize(static_cast<Eigen::Index>(known.places.size()));
  for (std::size_t i = 0; i < known.places.size(); ++i)
    times(static_cast<Eigen::Index>(i)) = all_times[known.places[i]];
  values = std::move(known.values);
}

std::vector<double> line_departures(std::span<const double> all_times, std::span<const double> all_values) {
  const OwnReadings own(all_times, all_values);
  const std::span times(own.times.data(), own.values.size());
  std::vector<double> departures;
  if (times.size() < 3) return departures;
  const double longest = kPause * median_interval(times);
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    const double span = times[i + 1] - times[i - 1];
    if (!(span <= longest)) continue;
    const double before = (times[i + 1] - times[i]) / span, after = (times[i] - times[i - 1]) / span;
    const double departure = own.values[i] - before * own.values[i - 1] - after * own.values[i + 1];
    departures.push_back(departure / std::sqrt(1.0 + before * before + after * after));
  }
  return departures;
}

}  // namespace lacuna

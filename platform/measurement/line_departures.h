#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace lacuna {

/// Distances of readings from the line through the one before and the one after, scaled so that white noise gives its
/// own standard deviation. Neighbours are a channel's own readings: rows of other devices and of readings left out
/// (NaN) lie between them without effect. Not across gaps.
std::vector<double> line_departures(std::span<const double> times, std::span<const double> values);

/// The known readings of a channel, with their times.
struct OwnReadings {
  Eigen::VectorXd times;
  std::vector<double> values;

  OwnReadings(std::span<const double> all_times, std::span<const double> all_values);
};

}  // namespace lacuna

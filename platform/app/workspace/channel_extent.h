#pragma once

#include <lacuna/trial.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace lacuna {

/// From which series of a trial a channel is taken.
enum class SeriesKind { measured, commanded };

/// Smallest and largest value of a channel in any trial, SI, and how many values are missing. Without any value the
/// smallest is above the largest.
struct ChannelExtent {
  double smallest = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  std::size_t missing = 0;
  std::string unit;
};

ChannelExtent extent_of(const std::string& channel, SeriesKind kind, const std::vector<Trial>& trials);

/// From the first reading to the last one, s; 0 of a trial with less than two.
double duration_of(const Trial& trial);

}  // namespace lacuna

#include "measurement/signal_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lacuna {
namespace {

constexpr std::size_t kClippedRun = 5;
constexpr std::size_t kFewestLevels = 20;
constexpr double kClippedShare = 0.01;
constexpr Eigen::Index kStretches = 50;

std::vector<double> values_of(const TimeSeries& series, Eigen::Index channel) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(series.samples.rows()));
  for (Eigen::Index i = 0; i < series.samples.rows(); ++i)
    if (const double value = series.samples(i, channel); !std::isnan(value)) values.push_back(value);
  return values;
}

bool has_many_levels(const std::vector<double>& values) {
  std::vector<double> levels;
  for (const double value : values) {
    if (std::find(levels.begin(), levels.end(), value) != levels.end()) continue;
    levels.push_back(value);
    if (levels.size() >= kFewestLevels) return true;
  }
  return false;
}

/// A change over two samples that is full motion: half the usual one, and more than a quantiser's
/// step, since a slow turn on a grid stays at its last value too.
double full_motion(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] != values[i - 1]) steps.push_back(std::abs(values[i] - values[i - 1]));
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::max(0.5 * *middle, 1.5 * *std::min_element(steps.begin(), middle + 1));
}

/// Runs at `limit` that were entered and left in full motion.
void count_clipped(const std::vector<double>& values, double limit, double motion, std::size_t& samples,
                   std::size_t& runs) {
  for (std::size_t i = 2; i < values.size(); ++i) {
    if (values[i] != limit || values[i - 1] == limit) continue;
    std::size_t end = i;
    while (end < values.size() && values[end] == limit) ++end;
    const bool fast_in = std::abs(values[i - 2] - limit) >= motion;
    const bool fast_out = end + 1 >= values.size() || std::abs(values[end + 1] - limit) >= motion;
    if (end - i < kClippedRun || !fast_in || !fast_out) continue;
    samples += end - i;
    ++runs;
  }
}

}  // namespace

SignalShape shape_of(const TimeSeries& series, Eigen::Index channel) {
  SignalShape shape;
  const std::vector<double> values = values_of(series, channel);
  shape.count = values.size();
  if (values.empty()) return shape;
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  shape.lowest = *lowest;
  shape.highest = *highest;
  if (!has_many_levels(values)) return shape;
  const double motion = full_motion(values);
  std::size_t low = 0, high = 0, low_runs = 0, high_runs = 0;
  count_clipped(values, shape.lowest, motion, low, low_runs);
  count_clipped(values, shape.highest, motion, high, high_runs);
  if (static_cast<double>(low + high) < kClippedShare * static_cast<double>(values.size())) return shape;
  shape.clipped = low + high;
  shape.clipped_runs = low_runs + high_runs;
  shape.clipped_high = high >= low;
  return shape;
}

SlopeMatch match_slope(const TimeSeries& series, Eigen::Index position, Eigen::Index velocity) {
  const Eigen::Index rows = series.times.size();
  const Eigen::Index length = rows / kStretches;
  if (length < 2) return {};
  double moved_squared = 0.0, integral_squared = 0.0, product = 0.0;
  for (Eigen::Index first = 0; first + length < rows; first += length) {
    const double moved = series.samples(first + length, position) - series.samples(first, position);
    double integral = 0.0;
    for (Eigen::Index i = first; i < first + length; ++i)
      integral += 0.5 * (series.samples(i, velocity) + series.samples(i + 1, velocity)) *
                  (series.times[i + 1] - series.times[i]);
    if (std::isnan(moved + integral)) continue;
    moved_squared += moved * moved;
    integral_squared += integral * integral;
    product += moved * integral;
  }
  if (moved_squared == 0.0 || integral_squared == 0.0) return {};
  return {product / moved_squared, product / std::sqrt(moved_squared * integral_squared)};
}

}  // namespace lacuna

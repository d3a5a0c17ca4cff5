#include "measurement/series/signal_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lacuna {
namespace {

constexpr std::size_t kClippedRun = 5;
constexpr std::size_t kFewestLevels = 20;
constexpr double kClippedShare = 0.01;
constexpr double kDeep = 3.0;  ///< of a quantiser's steps
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

struct Pace {
  double quantum = 0.0;  ///< the smallest change of a sample
  double motion = 0.0;   ///< over two samples: half the usual change, and more than a quantum
};

Pace pace_of(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] != values[i - 1]) steps.push_back(std::abs(values[i] - values[i - 1]));
  if (steps.empty()) return {};
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double quantum = *std::min_element(steps.begin(), middle + 1);
  return {quantum, std::max(0.5 * *middle, 1.5 * quantum)};
}

/// Whether a turn so fast and so long would have gone well beyond the limit: a slow turn on a grid stays at its last
/// value, too. `in`, `out`: changes over the two samples before and after; a parabola is put through them.
bool goes_beyond(double in, double out, std::size_t samples, const Pace& pace) {
  const double speed = 0.25 * (in + out);  // a sample
  return 0.25 * speed * static_cast<double>(samples) > kDeep * pace.quantum;
}

/// Runs of one value that were entered and left at full speed.
struct Stays {
  std::size_t samples = 0, runs = 0;
};

struct AllStays {
  Stays lowest, highest, elsewhere;
};

AllStays stays_of(const std::vector<double>& values, const SignalShape& shape, const Pace& pace) {
  AllStays stays;
  for (std::size_t i = 2; i < values.size(); ++i) {
    const double value = values[i];
    if (values[i - 1] == value) continue;
    std::size_t end = i;
    while (end < values.size() && values[end] == value) ++end;
    const double in = std::abs(values[i - 2] - value);
    const double out = end + 1 < values.size() ? std::abs(values[end + 1] - value) : in;
    if (end - i < kClippedRun || std::min(in, out) < pace.motion || !goes_beyond(in, out, end - i, pace)) continue;
    Stays& where = value == shape.lowest ? stays.lowest : value == shape.highest ? stays.highest : stays.elsewhere;
    if (end == values.size() && where.runs == 0) continue;  // a fall that ended, or a stop: there is no motion after it
    where.samples += end - i;
    ++where.runs;
  }
  return stays;
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
  const Pace pace = pace_of(values);
  const auto [low, high, elsewhere] = stays_of(values, shape, pace);
  const std::size_t clipped = low.samples + high.samples;
  // Dry friction stops a joint as suddenly, at any value.
  if (static_cast<double>(clipped) < kClippedShare * static_cast<double>(values.size()) || clipped < elsewhere.samples)
    return shape;
  shape.clipped = clipped;
  shape.clipped_runs = low.runs + high.runs;
  shape.clipped_high = high.samples >= low.samples;
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

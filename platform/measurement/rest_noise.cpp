#include "measurement/rest_noise.h"

#include <lacuna/robot_spec.h>

#include "foundation/unit.h"
#include "measurement/clocks/clock_check.h"
#include "measurement/line_departures.h"
#include "measurement/series/quantisation.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr double kWindowSeconds = 0.05;
constexpr Eigen::Index kWindowSamples = 12;
constexpr Eigen::Index kWindowsAtLeast = 2;
// A straight line that drifts by D over a window scatters by D/√12 about its mean, so its ratio is
// 3.5; white noise of twelve samples has 1.0 ± 0.6.
constexpr double kMostDrift = 2.0;
constexpr double kMostScatter = 5.0;  // times that of second differences: correlation of neighbours up to about 0.95
constexpr double kSameMean = 1.0;     // standard deviations between the means of neighbouring windows
constexpr double kSameScatter = 3.0;  // times that of the quietest tenth of the windows
constexpr double kFewestReadings = 48;
// A step this small compared with the range is as likely a printed digit as a quantiser, and noise may be larger.
constexpr double kCoarseStep = 1e-4;

struct Window {
  double mean = 0.0;
  double scatter = 0.0;  ///< standard deviation about the mean
  bool still = false;
};

Window look_at(std::span<const double> values, double quantum) {
  Window window;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) window.mean += value / n;
  double squares = 0.0, slope = 0.0, leverage = 0.0, curvature = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double from_mean = values[i] - window.mean;
    const double from_middle = static_cast<double>(i) - 0.5 * (n - 1.0);
    squares += from_mean * from_mean;
    slope += from_mean * from_middle;
    leverage += from_middle * from_middle;
    if (i >= 2) curvature += std::pow(values[i] - 2.0 * values[i - 1] + values[i - 2], 2);
  }
  if (!std::isfinite(window.mean)) return window;
  window.scatter = std::sqrt(squares / (n - 1.0));
  const double drift = std::abs(slope / leverage) * n;
  const double rough = std::sqrt(curvature / (6.0 * (n - 2.0)));  // white noise: its standard deviation
  const bool below_quantum = window.scatter <= 0.5 * quantum;
  window.still = drift <= std::max(kMostDrift * window.scatter, 0.5 * quantum) &&
                 (below_quantum || window.scatter <= kMostScatter * rough);
  return window;
}

/// The scatter of quiet windows: a movement that looks like noise scatters more.
double quiet_scatter(const std::vector<Window>& windows) {
  std::vector<double> scatters;
  for (const Window& window : windows)
    if (window.still) scatters.push_back(window.scatter);
  if (scatters.empty()) return 0.0;
  const auto tenth = scatters.begin() + static_cast<std::ptrdiff_t>(scatters.size() / 10);
  std::nth_element(scatters.begin(), tenth, scatters.end());
  return *tenth;
}

/// Consecutive windows at rest: neither their means nor a line through them change beyond the scatter.
class Stretch {
 public:
  /// Adds the window, or leaves the rest period unchanged and returns false.
  bool extend(const Window& window, double quantum) {
    Stretch longer = *this;
    longer.add(window);
    if (count_ > 0.0 && !longer.holds_still(window, quantum)) return false;
    *this = longer;
    return true;
  }

 private:
  void add(const Window& window) {
    if (count_ == 0.0) reference_ = window.mean;
    const double mean = window.mean - reference_;
    indices_ += count_;
    indices_squared_ += count_ * count_;
    means_ += mean;
    means_times_indices_ += mean * count_;
    variances_ += window.scatter * window.scatter;
    count_ += 1.0;
  }

  bool holds_still(const Window& last, double quantum) const {
    const double scatter = std::max(std::sqrt(variances_ / count_), 0.5 * quantum);
    const double slope =
        (count_ * means_times_indices_ - indices_ * means_) / (count_ * indices_squared_ - indices_ * indices_);
    // Means of few windows differ by chance.
    const double most_drift = std::max(1.0, 3.0 / std::sqrt(count_));
    return std::abs(slope) * count_ <= most_drift * scatter &&
           std::abs(last.mean - reference_ - means_ / count_) <= kSameMean * scatter;
  }

  double reference_ = 0.0;
  double count_ = 0.0, indices_ = 0.0, indices_squared_ = 0.0;
  double means_ = 0.0, means_times_indices_ = 0.0, variances_ = 0.0;
};

/// Sums over the rest periods of all trials.
struct RestSums {
  double squares = 0.0, products = 0.0, degrees_of_freedom = 0.0, readings = 0.0;

  void add(std::span<const double> values) {
    double mean = 0.0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      squares += (values[i] - mean) * (values[i] - mean);
      if (i > 0) products += (values[i] - mean) * (values[i - 1] - mean);
    }
    degrees_of_freedom += static_cast<double>(values.size()) - 1.0;
    readings += static_cast<double>(values.size());
  }
};

std::vector<double> values_of(const TimeSeries& series, const std::string& channel) {
  std::vector<double> values;
  for (std::size_t c = 0; c < series.channels.size(); ++c) {
    if (series.channels[c].name != channel) continue;
    const auto column = series.samples.col(static_cast<Eigen::Index>(c));
    values.assign(column.begin(), column.end());
  }
  return values;
}

}  // namespace

std::vector<RestStretch> find_rest(const Eigen::VectorXd& times, std::span<const double> values, double quantum) {
  const double interval = median_interval({times.data(), static_cast<std::size_t>(times.size())});
  if (!(interval > 0.0)) return {};
  const Eigen::Index length = std::max(kWindowSamples, static_cast<Eigen::Index>(std::ceil(kWindowSeconds / interval)));
  std::vector<Window> windows;
  for (Eigen::Index first = 0; first + length <= times.size(); first += length)
    windows.push_back(
        look_at(values.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(length)), quantum));
  const double loudest = std::max(kSameScatter * quiet_scatter(windows), 0.5 * quantum);
  std::vector<RestStretch> stretches;
  Stretch stretch;
  Eigen::Index count = 0;
  const auto finish = [&](std::size_t end) {
    if (count >= kWindowsAtLeast)
      stretches.push_back({(static_cast<Eigen::Index>(end) - count) * length, count * length});
    stretch = {};
    count = 0;
  };
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const bool still = windows[i].still && windows[i].scatter <= loudest;
    if (still && count > 0 && stretch.extend(windows[i], quantum)) {
      ++count;
      continue;
    }
    finish(i);
    if (still && stretch.extend(windows[i], quantum)) count = 1;
  }
  finish(windows.size());
  return stretches;
}

SensorNoise estimate_sensor_noise(const std::vector<Trial>& trials, const std::string& channel) {
  SensorNoise noise;
  RestSums sums;
  double lowest = kInfinity, highest = -kInfinity;
  for (const Trial& trial : trials) {
    const std::vector<double> all = values_of(trial.measured, channel);
    if (all.empty()) continue;
    const auto& [times, values] = OwnReadings({trial.measured.times.data(), all.size()}, all);
    const double quantum = quantisation_step(values);
    noise.quantum = std::max(noise.quantum, quantum);
    for (const double value : values) {
      if (value < lowest) lowest = value;
      if (value > highest) highest = value;
    }
    for (const RestStretch& stretch : find_rest(times, values, quantum)) {
      sums.add(
          std::span(values).subspan(static_cast<std::size_t>(stretch.first), static_cast<std::size_t>(stretch.count)));
      noise.rest_duration += times[stretch.first + stretch.count - 1] - times[stretch.first];
    }
  }
  const double from_quantum = noise.quantum / std::sqrt(12.0);
  if (noise.quantum > std::max(0.0, kCoarseStep * (highest - lowest))) noise.standard_deviation = from_quantum;
  if (sums.readings < kFewestReadings) return noise;
  noise.at_rest = std::sqrt(sums.squares / sums.degrees_of_freedom);
  noise.correlation = sums.squares > 0.0 ? sums.products / sums.squares : 0.0;
  noise.standard_deviation = std::max(noise.at_rest, from_quantum);
  return noise;
}

std::string SensorNoise::origin(const std::string& unit) const {
  const std::string step = "step " + format_quantity(quantum, unit) + "/\u221a12";
  if (std::isnan(standard_deviation))
    return quantum > 0.0 ? "unknown: the channel never rests, and its " + step + " is too small to estimate it"
                         : "unknown: the channel never rests and has no visible step";
  if (std::isnan(at_rest)) return step + "; no rest to compare";
  std::string rest = "rest " + format_quantity(at_rest, unit) + " in " + format_quantity(rest_duration, "s");
  if (quantum == 0.0) return rest;
  return at_rest > quantum / std::sqrt(12.0) ? rest + "; " + step + " is smaller" : step + "; rest agrees";
}

}  // namespace lacuna

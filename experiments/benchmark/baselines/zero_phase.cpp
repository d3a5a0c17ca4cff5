#include "baselines/zero_phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hidden_effects {
namespace {

constexpr double kOut = 30.0;  ///< times the power of the noise: a signal that stands out
constexpr std::size_t kFrequencies = 200;
constexpr std::size_t kNeighbours = 2;  ///< on either side

/// One pass; starts as if the first value had always been there.
void pass(std::vector<double>& x, double interval, double cutoff) {
  const double w = std::tan(std::numbers::pi * cutoff * interval), d = 1.0 + std::numbers::sqrt2 * w + w * w;
  const double b = w * w / d, a1 = 2.0 * (w * w - 1.0) / d, a2 = (1.0 - std::numbers::sqrt2 * w + w * w) / d;
  double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
  for (double& value : x) {
    const double y = b * (value + 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1, x1 = value, y2 = y1, y1 = y;
    value = y;
  }
}

/// |Fourier transform|² of a windowed signal at `cycles` a sample, by Goertzel's recursion.
double power(const std::vector<double>& windowed, double cycles) {
  const double twice = 2.0 * std::cos(2.0 * std::numbers::pi * cycles);
  double s1 = 0.0, s2 = 0.0;
  for (const double value : windowed) {
    const double s = value + twice * s1 - s2;
    s2 = s1, s1 = s;
  }
  return s1 * s1 + s2 * s2 - twice * s1 * s2;
}

std::vector<double> windowed(std::vector<double> x) {
  double mean = 0.0;
  for (const double value : x) mean += value / static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double place = (static_cast<double>(k) + 0.5) / static_cast<double>(x.size());
    x[k] = (x[k] - mean) * (0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * place));
  }
  return x;
}

std::vector<double> smoothed(const std::vector<double>& x) {
  std::vector<double> means(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t from = k < kNeighbours ? 0 : k - kNeighbours, to = std::min(x.size(), k + kNeighbours + 1);
    for (std::size_t j = from; j < to; ++j) means[k] += x[j] / static_cast<double>(to - from);
  }
  return means;
}

}  // namespace

std::vector<double> zero_phase(const std::vector<double>& values, double interval, double cutoff) {
  const auto wanted = static_cast<std::size_t>(2.0 / (cutoff * interval));
  const std::size_t n = values.size(), more = std::min(wanted, n - 1);
  std::vector<double> x;
  x.reserve(n + 2 * more);
  for (std::size_t k = more; k > 0; --k) x.push_back(2.0 * values.front() - values[k]);
  x.insert(x.end(), values.begin(), values.end());
  for (std::size_t k = 1; k <= more; ++k) x.push_back(2.0 * values.back() - values[n - 1 - k]);
  for (int direction = 0; direction < 2; ++direction) {
    pass(x, interval, cutoff);
    std::reverse(x.begin(), x.end());
  }
  const auto first = x.begin() + static_cast<std::ptrdiff_t>(more);
  return {first, first + static_cast<std::ptrdiff_t>(n)};
}

double bandwidth(const std::vector<std::vector<double>>& signals, double interval, double least, double most) {
  std::vector<double> density(kFrequencies, 0.0);
  for (const std::vector<double>& signal : signals) {
    const std::vector<double> x = windowed(signal);
    for (std::size_t k = 0; k < kFrequencies; ++k)
      density[k] += power(x, 0.5 * static_cast<double>(k + 1) / kFrequencies) / static_cast<double>(x.size());
  }
  std::vector<double> upper(density.begin() + kFrequencies / 2, density.end());
  std::nth_element(upper.begin(), upper.begin() + kFrequencies / 4, upper.end());
  const double noise = upper[kFrequencies / 4];
  const std::vector<double> mean = smoothed(density);
  std::size_t k = 0;
  while (k < kFrequencies && mean[k] > kOut * noise) ++k;
  return std::clamp(0.5 / interval * static_cast<double>(k) / kFrequencies, least, most);
}

}  // namespace hidden_effects

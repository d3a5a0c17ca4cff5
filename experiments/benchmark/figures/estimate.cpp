#include "figures/estimate.h"

#include "plant/draw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hidden_effects {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double k95 = 1.959963984540054;  // standard errors
constexpr std::size_t kResamples = 2000;
constexpr std::uint64_t kSeed = 20;

/// Where 95 % of the values lie.
void set_interval(std::vector<double>& found, Estimate& estimate) {
  std::sort(found.begin(), found.end());
  const auto quantile = [&](double p) { return found[static_cast<std::size_t>(std::lround(p * (kResamples - 1)))]; };
  estimate.lower_95 = quantile(0.025);
  estimate.upper_95 = quantile(0.975);
}

template <class Item, class Statistic>
Estimate resampled(const std::vector<Item>& items, const Statistic& of) {
  if (items.empty()) return {0, kNone, kNone, kNone};
  Estimate estimate{items.size(), of(items), kNone, kNone};
  if (items.size() < 2) return estimate;
  Draw draw(kSeed, items.size());
  std::vector<double> found(kResamples);
  std::vector<Item> sample(items.size());
  for (double& one : found) {
    for (Item& item : sample) item = items[draw.below(items.size())];
    one = of(sample);
  }
  set_interval(found, estimate);
  return estimate;
}

}  // namespace

Estimate share(const std::vector<double>& values) {
  if (values.empty()) return {0, kNone, kNone, kNone};
  const auto n = static_cast<double>(values.size());
  const double p = mean(values), z2 = k95 * k95;
  const double centre = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = k95 / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  return {values.size(), p, std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double brier_score(const std::vector<Stated>& stated) {
  double sum = 0.0;
  for (const Stated& one : stated) sum += (one.probability - one.is_right) * (one.probability - one.is_right);
  return sum / static_cast<double>(stated.size());
}

double calibration_error(const std::vector<Stated>& stated, int bins) {
  std::vector<double> excess(static_cast<std::size_t>(bins), 0.0);
  for (const Stated& one : stated) {
    const auto bin = static_cast<std::size_t>(std::clamp(static_cast<int>(one.probability * bins), 0, bins - 1));
    excess[bin] += one.probability - one.is_right;
  }
  double sum = 0.0;
  for (const double one : excess) sum += std::abs(one);
  return sum / static_cast<double>(stated.size());
}

Estimate calibration_error_by_chance(const std::vector<Stated>& stated) {
  if (stated.empty()) return {0, kNone, kNone, kNone};
  Draw draw(kSeed, stated.size());
  std::vector<double> found(kResamples);
  std::vector<Stated> drawn = stated;
  for (double& one : found) {
    for (Stated& verdict : drawn) verdict.is_right = draw.uniform() < verdict.probability ? 1.0 : 0.0;
    one = calibration_error(drawn);
  }
  Estimate estimate{stated.size(), mean(found), kNone, kNone};
  set_interval(found, estimate);
  return estimate;
}

Estimate bootstrap(const std::vector<double>& values, const std::function<double(const std::vector<double>&)>& of) {
  return resampled(values, of);
}

Estimate bootstrap(const std::vector<Stated>& stated, const std::function<double(const std::vector<Stated>&)>& of) {
  return resampled(stated, of);
}

}  // namespace hidden_effects

#include "measurement/series/quantisation.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lacuna {
namespace {

constexpr std::size_t kFewestGaps = 4;  // with fewer levels, such as a square wave, there is no grid
constexpr double kTolerance = 0.1;      // of a step, between two neighbouring values
constexpr double kNegligible = 1e-3;    // of the median gap: printing noise
constexpr double kShareOnGrid = 0.98;
constexpr std::size_t kMostValues = 200000;  // more add no information

/// Gaps between neighbouring distinct values, ascending.
std::vector<double> sorted_gaps(std::span<const double> values) {
  std::vector<double> sorted;
  const std::size_t stride = values.size() / kMostValues + 1;
  for (std::size_t i = 0; i < values.size(); i += stride)
    if (std::isfinite(values[i])) sorted.push_back(values[i]);
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i] > sorted[i - 1]) gaps.push_back(sorted[i] - sorted[i - 1]);
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

/// The step that fits best near a candidate, or 0 where the gaps are not multiples of it.
double fitted_step(const std::vector<double>& gaps, double candidate) {
  std::size_t on_grid = 0;
  double gap_steps = 0.0, steps_squared = 0.0;
  for (const double gap : gaps) {
    const double steps = std::round(gap / candidate);
    if (std::abs(gap - steps * candidate) > kTolerance * candidate) continue;
    ++on_grid;
    gap_steps += gap * steps;
    steps_squared += steps * steps;
  }
  const bool fits = static_cast<double>(on_grid) >= kShareOnGrid * static_cast<double>(gaps.size());
  return fits && steps_squared > 0.0 ? gap_steps / steps_squared : 0.0;
}

}  // namespace

double quantisation_step(std::span<const double> values) {
  std::vector<double> gaps = sorted_gaps(values);
  if (gaps.size() < kFewestGaps) return 0.0;
  const double smallest = kNegligible * gaps[gaps.size() / 2];
  gaps.erase(gaps.begin(), std::lower_bound(gaps.begin(), gaps.end(), smallest));
  if (gaps.size() < kFewestGaps) return 0.0;
  // In a well-filled grid most neighbours are one step apart; a sparse one may hold multiples only, so halves and
  // thirds of the smallest gap are tried, too.
  for (const double divisor : {1.0, 2.0, 3.0})
    if (const double step = fitted_step(gaps, gaps[gaps.size() / 50] / divisor); step > 0.0) return step;
  return 0.0;
}

}  // namespace lacuna

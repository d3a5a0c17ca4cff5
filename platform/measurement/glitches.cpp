#include "measurement/glitches.h"

#include "measurement/known_readings.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kLongest = 3;   ///< readings in a row
constexpr double kFar = 8.0;          ///< times the usual change
constexpr double kUsualShare = 0.99;  ///< quantile of all changes
constexpr double kBack = 0.25;        ///< of the departure: how far the signal may go on in the meantime
constexpr double kMostOfAll = 0.005;  ///< of all readings; more are no accidents but the signal
constexpr std::size_t kFewestValues = 50;

/// A quantile of the changes from one reading to the next.
double change_at(const std::vector<double>& values, double share) {
  std::vector<double> sizes;
  for (std::size_t i = 1; i < values.size(); ++i) sizes.push_back(std::abs(values[i] - values[i - 1]));
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

double smallest_change(const std::vector<double>& values) {
  double smallest = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double size = std::abs(values[i] - values[i - 1]);
    if (size > 0.0 && (smallest == 0.0 || size < smallest)) smallest = size;
  }
  return smallest;
}

/// How many readings from `i` on left and came back; 0: none.
std::size_t length_of_glitch(const std::vector<double>& values, std::size_t i, double far) {
  const double away = values[i] - values[i - 1];
  if (std::abs(away) <= far) return 0;
  for (std::size_t n = 1; n <= kLongest && i + n < values.size(); ++n) {
    // Further readings of a glitch stay where the first one went; a motion would not.
    if (n > 1 && std::abs(values[i + n - 1] - values[i + n - 2]) > far / kFar) return 0;
    const double back = values[i + n - 1] - values[i + n], on = values[i + n] - values[i - 1];
    if (back * away > 0.0 && std::abs(back) > far && std::abs(on) < kBack * std::abs(away)) return n;
  }
  return 0;
}

}  // namespace

std::vector<std::size_t> find_glitches(std::span<const double> all) {
  const auto [values, places] = KnownReadings(all);
  if (values.size() < kFewestValues) return {};
  const double usual = change_at(values, kUsualShare);
  const double far = kFar * std::max(usual, smallest_change(values));
  std::vector<std::size_t> glitches;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    for (std::size_t n = length_of_glitch(values, i, far); n > 0; --n) glitches.push_back(places[i++]);
  if (static_cast<double>(glitches.size()) > std::max(1.0, kMostOfAll * static_cast<double>(values.size()))) return {};
  return glitches;
}

}  // namespace lacuna

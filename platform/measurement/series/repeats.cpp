#include "measurement/series/repeats.h"

#include "measurement/series/known_readings.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kFewestChanges = 20;
constexpr double kEven = 0.9;     ///< of the intervals between changes that are the usual one, or differ from it by one
constexpr double kLarge = 0.5;    ///< of the changes that are more than one step of a quantiser
constexpr double kOneStep = 1.5;  ///< smallest changes

struct Changes {
  std::vector<std::size_t> places;  ///< of readings that differ from the one before
  std::vector<double> sizes;
};

Changes changes_of(const std::vector<double>& values) {
  Changes changes;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] == values[i - 1]) continue;
    changes.places.push_back(i);
    changes.sizes.push_back(std::abs(values[i] - values[i - 1]));
  }
  return changes;
}

}  // namespace

Repeats find_repeats(std::span<const double> all) {
  const auto [values, places] = KnownReadings(all);
  const Changes changes = changes_of(values);
  if (changes.places.size() < kFewestChanges) return {};
  std::vector<std::size_t> intervals;
  for (std::size_t i = 1; i < changes.places.size(); ++i)
    intervals.push_back(changes.places[i] - changes.places[i - 1]);
  if (std::find(intervals.begin(), intervals.end(), 1) != intervals.end()) return {};
  std::vector<std::size_t> sorted = intervals;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const std::size_t usual = *middle;
  const auto even = std::count_if(intervals.begin(), intervals.end(),
                                  [&](std::size_t n) { return n + 1 >= usual && n <= usual + 1; });
  const double smallest = *std::min_element(changes.sizes.begin(), changes.sizes.end());
  const auto large = std::count_if(changes.sizes.begin(), changes.sizes.end(),
                                   [&](double size) { return size > kOneStep * smallest; });
  if (static_cast<double>(even) < kEven * static_cast<double>(intervals.size()) ||
      static_cast<double>(large) < kLarge * static_cast<double>(changes.sizes.size()))
    return {};
  Repeats repeats{usual, {}};
  std::size_t since = 0;  // the last reading of the sensor
  for (std::size_t i = 0, next = 0; i < values.size(); ++i) {
    const bool changed = next < changes.places.size() && changes.places[next] == i;
    if (changed) ++next;
    // A sensor that reads the same value again, as at rest, looks like one that repeats: its next regular time counts.
    if (changed || i == 0 || i - since > usual)
      since = i;
    else
      repeats.repeated.push_back(places[i]);
  }
  return repeats;
}

}  // namespace lacuna

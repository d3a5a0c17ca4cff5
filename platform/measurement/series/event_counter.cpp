#include "measurement/series/event_counter.h"

#include "foundation/statistics.h"
#include "measurement/series/known_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr std::size_t kFewestEvents = 5;
constexpr double kFewestRows = 4.0;       ///< usual number of rows from event to event
constexpr double kOfOneCount = 0.98;      ///< of the changes
constexpr double kPrinted = 0.01;         ///< of a count
constexpr double kMostTurnsRound = 0.25;  ///< of the changes; a switch goes to and fro
constexpr std::size_t kFewestCountedLevels = 4;

struct CountStep {
  std::size_t row, before;  ///< after the change and before it
  double change;
};

std::vector<CountStep> steps_of(const KnownReadings& known) {
  std::vector<CountStep> steps;
  for (std::size_t i = 1; i < known.values.size(); ++i)
    if (known.values[i] != known.values[i - 1])
      steps.push_back({known.places[i], known.places[i - 1], known.values[i] - known.values[i - 1]});
  return steps;
}

/// The count by which all steps go; 0: none.
double count_of(const std::vector<CountStep>& steps) {
  std::vector<double> sizes;
  for (const CountStep& step : steps) sizes.push_back(std::abs(step.change));
  std::vector<double> sorted = sizes;
  const double count = median_of(sorted);
  const auto alike = std::count_if(sizes.begin(), sizes.end(),
                                   [&](double size) { return std::abs(size - count) <= kPrinted * count; });
  return static_cast<double>(alike) >= kOfOneCount * static_cast<double>(sizes.size()) ? count : 0.0;
}

bool counts_on(const std::vector<CountStep>& steps, const KnownReadings& known, double count) {
  double turns = 0.0;
  for (std::size_t i = 1; i < steps.size(); ++i) turns += steps[i].change * steps[i - 1].change < 0.0 ? 1.0 : 0.0;
  const auto [lowest, highest] = std::minmax_element(known.values.begin(), known.values.end());
  return turns <= kMostTurnsRound * static_cast<double>(steps.size()) &&
         *highest - *lowest > (static_cast<double>(kFewestCountedLevels) - 1.5) * count;
}

/// Speed at an event: one count in the time to the nearer neighbouring event, if that has the same direction. After a
/// reversal the motion passes the same place again, and only an upper limit is known.
double speed_at(const std::vector<CountStep>& steps, std::size_t i, std::span<const double> times, double count) {
  double longest = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t other) {
    if (steps[other].change * steps[i].change > 0.0)
      longest = std::min(longest, std::abs(times[steps[other].row] - times[steps[i].row]));
  };
  if (i > 0) look(i - 1);
  if (i + 1 < steps.size()) look(i + 1);
  return std::isfinite(longest) ? count / longest : 0.0;
}

}  // namespace

EventCounter find_events(std::span<const double> times, std::span<const double> values, double coarse) {
  const KnownReadings known(values);
  const std::vector<CountStep> steps = steps_of(known);
  if (steps.size() < kFewestEvents) return {};
  EventCounter counter;
  counter.count = count_of(steps);
  if (counter.count < coarse || !counts_on(steps, known, counter.count)) return {};
  std::vector<double> between;
  for (std::size_t i = 1; i < steps.size(); ++i)
    between.push_back(static_cast<double>(steps[i].row - steps[i - 1].row));
  counter.rows_between = median_of(between);
  if (counter.rows_between < kFewestRows) return {};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& [row, before, change] = steps[i];
    // Upwards the event is at the new count, downwards at the old one.
    const double at_event = std::max(values[row], values[before]);
    const double since = speed_at(steps, i, times, counter.count) * (times[row] - times[before]);
    counter.events.push_back({row, at_event + std::copysign(0.5 * since, change), since / std::sqrt(12.0)});
  }
  return counter;
}

}  // namespace lacuna

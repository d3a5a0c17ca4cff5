#include "measurement/series/glitches.h"

#include "foundation/statistics.h"
#include "measurement/series/course.h"
#include "measurement/series/known_readings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kLongest = 3;        ///< consecutive readings
constexpr std::size_t kLongestDetour = 6;  ///< consecutive readings, beside other glitches
constexpr double kFar = 8.0;               ///< times the distance of usual readings from the series
constexpr double kUsualShare = 0.99;       ///< quantile of the distance of usual readings
constexpr double kBeside = 4.0;            ///< times the changes next to it
constexpr double kBack = 0.25;             ///< of the departure: the most that the signal may change meanwhile
constexpr double kAccidents = 0.005;       ///< of all readings; with more, pulses are distinguished
constexpr double kAlike = 0.1;             ///< of the departure: the most by which readings of one glitch differ
constexpr double kSuspicious = 32.0;       ///< times the usual bend: the least length of a detour
constexpr std::size_t kFewPulses = 4;      ///< with fewer they are not pulses
constexpr std::size_t kFewestValues = 50;
constexpr std::size_t kOthers = 5;  ///< glitches of one reading, beside which longer ones need not have equal readings

/// Some readings in a row.
struct Run {
  std::size_t first = 0, length = 0;
};

/// The runs without which the rest has the shortest path, where each reading left out counts as a path of `price`: by
/// dynamic programming.
std::vector<Run> detours(const std::vector<double>& v, double price) {
  std::vector<double> costs(v.size(), 0.0);
  std::vector<std::size_t> left_out(v.size(), 0);  // before each reading
  for (std::size_t i = 1; i < v.size(); ++i) {
    costs[i] = costs[i - 1] + std::abs(v[i] - v[i - 1]);
    for (std::size_t n = 1; n <= kLongestDetour && n < i; ++n) {
      const double cost = costs[i - n - 1] + std::abs(v[i] - v[i - n - 1]) + price * static_cast<double>(n);
      if (cost >= costs[i]) continue;
      costs[i] = cost;
      left_out[i] = n;
    }
  }
  std::vector<Run> runs;
  for (std::size_t i = v.size() - 1; i > 0; i -= left_out[i] + 1)
    if (left_out[i] > 0) runs.push_back({i - left_out[i], left_out[i]});
  std::reverse(runs.begin(), runs.end());
  return runs;
}

/// A signal without the runs that are taken for glitches.
class Signal {
 public:
  /// `quantum`: the smallest change of all readings.
  Signal(const std::vector<double>& times, const std::vector<double>& values, double quantum,
         const std::vector<Run>& without)
      : values_(values), course_(times, values, members(values.size(), without)) {
    usual_ = std::max(course_.roughness(kUsualShare), quantum);
  }

  /// Distance of a run from the signal, of its closest reading.
  double size_of(const Run& run) const {
    double size = course_.outside(run.first);
    for (std::size_t i = 1; i < run.length; ++i) size = std::min(size, course_.outside(run.first + i));
    return size;
  }

  /// Whether the signal after a run continues as before it.
  bool is_left_by(const Run& run) const {
    const double size = size_of(run);
    const auto& kept = course_.members();
    const auto after = static_cast<std::size_t>(std::lower_bound(kept.begin(), kept.end(), run.first) - kept.begin());
    if (after < 2 || after + 1 >= kept.size()) return false;
    const auto change = [&](std::size_t to) { return std::abs(values_[kept[to]] - values_[kept[to - 1]]); };
    return change(after) < kBack * size && kBeside * std::max(change(after - 1), change(after + 1)) < size;
  }

  /// Whether the readings of a run are equal, unlike those of a motion.
  bool is_flat(const Run& run) const {
    for (std::size_t i = 1; i < run.length; ++i)
      if (std::abs(values_[run.first + i] - values_[run.first + i - 1]) > std::max(usual_, kAlike * size_of(run)))
        return false;
    return true;
  }

  double far() const { return kFar * usual_; }

 private:
  static std::vector<std::size_t> members(std::size_t count, const std::vector<Run>& without) {
    std::vector<std::size_t> kept;
    auto next = without.begin();
    for (std::size_t i = 0; i < count; ++i) {
      while (next != without.end() && i >= next->first + next->length) ++next;
      if (next == without.end() || i < next->first) kept.push_back(i);
    }
    return kept;
  }

  const std::vector<double>& values_;
  Course course_;
  double usual_ = 0.0;
};

/// The runs that are glitches. Those that are no further from the signal than other readings are put back into it,
/// which makes it rougher, until none is; so are those without a return, if they are as many as the others.
std::vector<Run> glitches_among(std::vector<Run> runs, const std::vector<double>& times,
                                const std::vector<double>& values, double quantum) {
  while (true) {
    const Signal signal(times, values, quantum, runs);
    std::vector<Run> far, glitches;
    const auto is_far = [&](const Run& run) { return signal.size_of(run) > signal.far(); };
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(far), is_far);
    std::copy_if(far.begin(), far.end(), std::back_inserter(glitches),
                 [&](const Run& run) { return signal.is_left_by(run); });
    const auto single = std::count_if(glitches.begin(), glitches.end(), [](const Run& run) { return run.length == 1; });
    if (static_cast<std::size_t>(single) < kOthers)
      std::erase_if(glitches, [&](const Run& run) { return run.length > kLongest || !signal.is_flat(run); });
    std::vector<Run>& remaining = 2 * glitches.size() < far.size() ? glitches : far;
    if (remaining.size() == runs.size()) return glitches;
    runs = remaining;
  }
}

}  // namespace

Glitches find_glitches(std::span<const double> all_times, std::span<const double> column) {
  const auto [values, places] = KnownReadings(column);
  Glitches glitches{{}, values.size()};
  if (values.size() < kFewestValues) return glitches;
  std::vector<double> times;
  for (const std::size_t place : places) times.push_back(all_times[place]);
  const double quantum = smallest_change(values);
  const std::vector<Run> runs =
      glitches_among(detours(values, kSuspicious * std::max(usual_bend(values), quantum)), times, values, quantum);
  std::vector<double> levels;
  for (const Run& run : runs) {
    for (std::size_t i = 0; i < run.length; ++i) glitches.readings.push_back(places[run.first + i]);
    levels.push_back(values[run.first - 1]);
  }
  const bool many = static_cast<double>(glitches.readings.size()) >
                    std::max<double>(kFewPulses, kAccidents * static_cast<double>(values.size()));
  if (many)
    glitches.may_be_motion =
        quantile_of(levels, 0.9) - quantile_of(levels, 0.1) < Signal(times, values, quantum, runs).far();
  return glitches;
}

}  // namespace lacuna

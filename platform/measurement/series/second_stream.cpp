#include "measurement/series/second_stream.h"

#include "foundation/statistics.h"
#include "measurement/series/course.h"
#include "measurement/series/known_readings.h"
#include "measurement/series/two_courses.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lacuna {
namespace {

constexpr std::size_t kFewestForTwo = 50;
constexpr std::size_t kFewestOfStream = 8;
constexpr double kLeastShare = 0.03;     ///< of the readings; fewer are glitches
constexpr double kSureShare = 0.35;      ///< of the readings, at most: the others are the channel's
constexpr std::size_t kLongestTurn = 3;  ///< consecutive readings of the smaller series
constexpr double kInTurns = 0.9;         ///< of its readings that are in such groups
constexpr double kCoursesApart = 8.0;    ///< usual distance of the two series over the roughness of the channel's
constexpr double kUsualRoughness = 0.9;  ///< quantile of the distances from the series, used as its roughness
constexpr double kMoves = 5.0;           ///< deviation of a series that moves, over its roughness
constexpr double kSmooth = 0.25;         ///< roughness of the other series, over the distance
constexpr double kOwnCourse = 0.4;       ///< deviation of the distance, over that of the series
constexpr double kMirrored = 0.8;        ///< correlation of series that are the two sides of one vibration
constexpr double kConstant = 0.8;        ///< of a series' readings with one value: it is constant
constexpr double kSeldom = 20.0;         ///< usual bends: noise rarely leaves its neighbours by as much
constexpr double kPrice = 12.0;          ///< usual bends: of a reading that is assigned to the other series
constexpr int kRefinements = 4;

/// The known readings of a channel.
struct Readings {
  std::vector<double> times, values;
  std::vector<std::size_t> places;

  Readings(std::span<const double> all_times, std::span<const double> column) {
    KnownReadings known(column);
    values = std::move(known.values);
    places = std::move(known.places);
    for (const std::size_t place : places) times.push_back(all_times[place]);
  }
  std::size_t size() const { return values.size(); }
};

struct TwoCourses {
  Course channel, other;
};

TwoCourses courses_of(const Readings& readings, const std::vector<bool>& of_other) {
  std::vector<std::size_t> channel, other;
  for (std::size_t i = 0; i < readings.size(); ++i) (of_other[i] ? other : channel).push_back(i);
  return {Course(readings.times, readings.values, std::move(channel)),
          Course(readings.times, readings.values, std::move(other))};
}

/// Whether enough readings leave both neighbours by far to make a search for a second series worth its time.
bool may_have_two(const std::vector<double>& v, double bend) {
  std::size_t leaving = 0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const double before = v[i] - v[i - 1], after = v[i] - v[i + 1];
    if (before * after > 0.0 && std::min(std::abs(before), std::abs(after)) > kSeldom * bend) ++leaving;
  }
  return static_cast<double>(leaving) >=
         std::max<double>(kFewestOfStream, 0.5 * kLeastShare * static_cast<double>(v.size()));
}

/// Each reading to the closer series.
void refine(const Readings& readings, std::vector<bool>& of_other) {
  for (int round = 0; round < kRefinements; ++round) {
    const auto [channel, other] = courses_of(readings, of_other);
    if (channel.members().size() < kFewestOfStream || other.members().size() < kFewestOfStream) return;
    const std::vector<bool> before = of_other;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const double to_channel = std::abs(readings.values[i] - channel.at(i)),
                   to_other = std::abs(readings.values[i] - other.at(i));
      if (to_channel < to_other) of_other[i] = false;
      if (to_other < to_channel) of_other[i] = true;
    }
    if (of_other == before) return;
  }
}

/// The most frequent value of a series.
std::optional<double> constant_of(const Course& course, const std::vector<double>& values) {
  std::map<double, std::size_t> counts;
  for (const std::size_t member : course.members()) ++counts[values[member]];
  for (const auto& [value, count] : counts)
    if (static_cast<double>(count) >= kConstant * static_cast<double>(course.members().size())) return value;
  return std::nullopt;
}

/// Length of each reading's group of consecutive readings that are equal in `is_one`.
std::vector<std::size_t> turns_of(const std::vector<bool>& is_one) {
  std::vector<std::size_t> lengths(is_one.size());
  for (std::size_t i = 0, end = 0; i < is_one.size(); i = end) {
    while (end < is_one.size() && is_one[end] == is_one[i]) ++end;
    std::fill(lengths.begin() + static_cast<std::ptrdiff_t>(i), lengths.begin() + static_cast<std::ptrdiff_t>(end),
              end - i);
  }
  return lengths;
}

/// All readings with exactly that value, unless the channel rests there.
std::vector<bool> readings_of_value(const std::vector<double>& values, double value) {
  std::vector<bool> is_value;
  for (const double one : values) is_value.push_back(one == value);
  const std::vector<std::size_t> turns = turns_of(is_value);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (turns[i] > kLongestTurn) is_value[i] = false;
  return is_value;
}

bool comes_in_turns(const Course& course, const std::vector<bool>& of_other) {
  const std::vector<std::size_t> turns = turns_of(of_other);
  const auto in_short = std::count_if(course.members().begin(), course.members().end(),
                                      [&](std::size_t i) { return turns[i] <= kLongestTurn; });
  return static_cast<double>(in_short) >= kInTurns * static_cast<double>(course.members().size());
}

/// Distance of the other series' readings from the range of the channel's: the usual one, or for a constant series, at
/// which the channel may rest, that of a quarter.
double distance_of(const TwoCourses& two, bool constant) {
  std::vector<double> distances;
  for (const std::size_t i : two.other.members())
    if (const double distance = two.channel.outside(i); std::isfinite(distance)) distances.push_back(distance);
  return quantile_of(distances, constant ? 0.75 : 0.5);
}

/// Whether the other series follows the channel's at a distance, or mirrors it.
bool is_related(const TwoCourses& two, const std::vector<double>& values, bool even) {
  double n = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  for (const std::size_t i : two.other.members()) {
    const double x = two.channel.at(i), y = values[i];
    if (!std::isfinite(x)) continue;
    n += 1.0;
    a += x;
    b += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
  const double va = aa / n - a / n * a / n, vb = bb / n - b / n * b / n, cov = ab / n - a / n * b / n;
  const double apart = std::max(va + vb - 2.0 * cov, 0.0);
  if (std::sqrt(apart) < kOwnCourse * std::sqrt(std::max(va, vb))) return true;
  return even && std::abs(cov) > kMirrored * std::sqrt(va * vb);
}

bool is_apart(const TwoCourses& two, const std::vector<double>& values, bool constant) {
  return distance_of(two, constant) >
         kCoursesApart * std::max(two.channel.roughness(kUsualRoughness), smallest_change(values));
}

/// Whether the second series of a division differs from the first, which is a channel's.
bool is_second(const Readings& readings, const std::vector<bool>& of_other, const std::optional<double>& constant) {
  const TwoCourses two = courses_of(readings, of_other);
  const double share = static_cast<double>(two.other.members().size()) / static_cast<double>(readings.size());
  if (two.other.members().size() < kFewestOfStream || share < kLeastShare ||
      two.channel.members().size() < kFewestOfStream)
    return false;
  const bool even = share > 0.4;
  if (!comes_in_turns(two.other, of_other) || (share > 0.5 && !comes_in_turns(two.channel, of_other))) return false;
  if (!is_apart(two, readings.values, constant.has_value())) return false;
  if (!(two.channel.deviation() > kMoves * two.channel.roughness(kUsualRoughness))) return false;
  if (!constant && two.other.roughness(kUsualRoughness) > kSmooth * distance_of(two, false)) return false;
  return !is_related(two, readings.values, even);
}

SecondStream stream_of(const Readings& readings, const std::vector<bool>& of_other,
                       const std::optional<double>& constant) {
  SecondStream stream{{}, readings.size(), constant};
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (of_other[i]) stream.readings.push_back(readings.places[i]);
  stream.is_sure = static_cast<double>(stream.readings.size()) <= kSureShare * static_cast<double>(stream.of);
  return stream;
}

}  // namespace

std::optional<SecondStream> find_second_stream(std::span<const double> times, std::span<const double> column) {
  const Readings readings(times, column);
  if (readings.size() < kFewestForTwo) return std::nullopt;
  const double bend = std::max(usual_bend(readings.values), smallest_change(readings.values));
  if (!may_have_two(readings.values, bend)) return std::nullopt;
  const std::vector<std::size_t> courses = divide_in_two(readings.times, readings.values, kPrice * bend);
  std::vector<bool> of_other;
  for (const std::size_t course : courses) of_other.push_back(course == 1);
  refine(readings, of_other);
  const TwoCourses two = courses_of(readings, of_other);
  if (two.channel.members().empty() || two.other.members().empty()) return std::nullopt;
  if (two.other.members().size() > two.channel.members().size()) of_other.flip();
  for (int side = 0; side < 2; ++side, of_other.flip()) {
    const std::optional<double> constant = constant_of(courses_of(readings, of_other).other, readings.values);
    const std::vector<bool> division = constant ? readings_of_value(readings.values, *constant) : of_other;
    if (is_second(readings, division, constant)) return stream_of(readings, division, constant);
  }
  return std::nullopt;
}

bool stands_apart(std::span<const double> times, std::span<const double> column, std::span<const std::size_t> rows) {
  const Readings readings(times, column);
  std::vector<bool> of_other;
  for (const std::size_t place : readings.places)
    of_other.push_back(std::binary_search(rows.begin(), rows.end(), place));
  const TwoCourses two = courses_of(readings, of_other);
  if (two.other.members().size() < kFewestOfStream || two.channel.members().size() < kFewestForTwo) return false;
  return is_apart(two, readings.values, false);
}

}  // namespace lacuna

#include "measurement/series/two_courses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lacuna {
namespace {

constexpr std::size_t kLongestAbsence = 24;  ///< consecutive readings of the other series that are distinguished

/// The last two readings of a course.
struct CourseHead {
  double time = 0.0, value = 0.0, time_before = 0.0, value_before = 0.0;
  int count = 0;

  double surprise(double t, double y) const {
    if (count == 0) return 0.0;
    const double stays = std::abs(y - value);
    if (count == 1) return stays;
    return std::min(stays, std::abs(y - value - (value - value_before) * (t - time) / (time - time_before)));
  }
  void take(double t, double y) {
    time_before = time;
    value_before = value;
    time = t;
    value = y;
    ++count;
  }
};

/// The best division of the readings so far, for a given last reading and the last few readings of its series.
struct Division {
  double cost = std::numeric_limits<double>::infinity();
  CourseHead current, resting;
};

/// By the number of the current course's last readings in a row.
using OfOneCourse = std::array<Division, kLongestAbsence>;

/// Which series is current: the first or the second.
using Divisions = std::array<OfOneCourse, 2>;

/// The previous state where the position does not determine it: the first and the last of a series.
struct Step {
  std::array<std::uint8_t, 2> switched_from{}, stayed_from{};
};

/// `prices`: of a reading in each series.
Step advance(double t, double y, const std::array<double, 2>& prices, Divisions& states) {
  Divisions next;
  Step step;
  for (std::size_t course = 0; course < 2; ++course)
    for (std::size_t age = 0; age < kLongestAbsence; ++age) {
      const Division& from = states[course][age];
      if (std::isinf(from.cost)) continue;
      Division& switched = next[1 - course][0];
      if (const double cost = from.cost + from.resting.surprise(t, y) + prices[1 - course]; cost < switched.cost) {
        switched = {cost, from.resting, from.current};
        step.switched_from[1 - course] = static_cast<std::uint8_t>(age);
      }
      Division& stayed = next[course][std::min(age + 1, kLongestAbsence - 1)];
      if (const double cost = from.cost + from.current.surprise(t, y) + prices[course]; cost < stayed.cost) {
        stayed = {cost, from.current, from.resting};
        if (age + 2 >= kLongestAbsence) step.stayed_from[course] = static_cast<std::uint8_t>(age);
      }
    }
  for (OfOneCourse& one : next)
    for (Division& state : one)
      if (!std::isinf(state.cost)) state.current.take(t, y);
  states = next;
  return step;
}

}  // namespace

std::vector<std::size_t> divide_in_two(std::span<const double> times, std::span<const double> values, double price) {
  std::vector<std::size_t> courses(values.size(), 0);
  if (values.empty()) return courses;
  Divisions states;
  for (std::size_t course = 0; course < 2; ++course) {
    states[course][0].cost = 0.0;
    states[course][0].current.take(times[0], values[0]);
  }
  std::vector<Step> steps(values.size());
  for (std::size_t i = 1; i < values.size(); ++i) steps[i] = advance(times[i], values[i], {0.0, price}, states);
  std::size_t course = 0, age = 0;
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t a = 0; a < kLongestAbsence; ++a)
      if (states[c][a].cost < states[course][age].cost) course = c, age = a;
  for (std::size_t i = values.size() - 1;; --i) {
    courses[i] = course;
    if (i == 0) return courses;
    if (age == 0) {
      age = steps[i].switched_from[course];
      course = 1 - course;
    } else {
      age = age + 1 == kLongestAbsence ? steps[i].stayed_from[course] : age - 1;
    }
  }
}

}  // namespace lacuna

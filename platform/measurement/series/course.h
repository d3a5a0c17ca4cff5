#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// Some of a channel's readings, in order of time, as one smooth series that predicts the readings between.
class Course {
 public:
  /// `members`: ascending indices of readings. `times` and `values` must outlive the course.
  Course(std::span<const double> times, std::span<const double> values, std::vector<std::size_t> members);

  const std::vector<std::size_t>& members() const { return members_; }

  /// The prediction at another reading's time: a cubic through the two members before and the two after it, or a line
  /// where there is only one on a side. The reading itself does not count. NaN outside the series.
  double at(std::size_t reading) const;

  /// Distance of a reading from the range of its neighbours in the series; NaN outside the series.
  double outside(std::size_t reading) const;

  /// A quantile of the distances of members from the prediction by the others.
  double roughness(double share) const;

  double deviation() const;  ///< standard deviation of the members' values

 private:
  /// The number of members before a reading; `after`: the first one after it.
  std::size_t before(std::size_t reading, std::size_t& after) const;
  /// At a reading with so many members before it, and from `after` on after it.
  double between(std::size_t count, std::size_t after, std::size_t reading) const;

  std::span<const double> times_, values_;
  std::vector<std::size_t> members_;
};

/// Usual distance of a reading to the closest of the lines through two of its neighbours: small even where a third of
/// the readings belong to another series.
double usual_bend(std::span<const double> values);

/// The smallest change from one reading to the next; 0: all are equal.
double smallest_change(std::span<const double> values);

}  // namespace lacuna

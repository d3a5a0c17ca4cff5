#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacuna {

/// Part of a channel's readings, in order of time, as one course: what it says of the readings between.
class Course {
 public:
  /// `members`: ascending indices of readings. `times` and `values` must outlive the course.
  Course(std::span<const double> times, std::span<const double> values, std::vector<std::size_t> members);

  const std::vector<std::size_t>& members() const { return members_; }

  /// The course at another reading's time: of a cubic through the two members before and the two after it, of a line
  /// where there is but one on a side. The reading itself does not count. NaN outside of the course.
  double at(std::size_t reading) const;

  /// How far a reading lies outside of what its neighbours in the course span; NaN outside of the course.
  double outside(std::size_t reading) const;

  /// A quantile of how far members are from the course of the others.
  double roughness(double share) const;

  double deviation() const;  ///< standard deviation of the members' values

 private:
  /// The number of members before a reading; `after`: the first one behind it.
  std::size_t before(std::size_t reading, std::size_t& after) const;
  /// At a reading with so many members before it, and from `after` on behind it.
  double between(std::size_t count, std::size_t after, std::size_t reading) const;

  std::span<const double> times_, values_;
  std::vector<std::size_t> members_;
};

/// Usual distance of a reading to the closest of the lines through two of its neighbours: small also where a third of
/// the readings are others.
double usual_bend(std::span<const double> values);

/// The smallest change from one reading to the next; 0: all are alike.
double smallest_change(std::span<const double> values);

}  // namespace lacuna

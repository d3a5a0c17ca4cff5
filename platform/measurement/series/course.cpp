#include "measurement/series/course.h"

#include "foundation/statistics.h"

#include <algorithm>
#include <cmath>

namespace lacuna {

Course::Course(std::span<const double> times, std::span<const double> values, std::vector<std::size_t> members)
    : times_(times), values_(values), members_(std::move(members)) {}

std::size_t Course::before(std::size_t reading, std::size_t& after) const {
  const auto place = std::lower_bound(members_.begin(), members_.end(), reading);
  const auto count = static_cast<std::size_t>(place - members_.begin());
  after = count + (place != members_.end() && *place == reading ? 1 : 0);
  return count;
}

double Course::at(std::size_t reading) const {
  std::size_t after = 0;
  const std::size_t count = before(reading, after);
  return between(count, after, reading);
}

double Course::between(std::size_t count, std::size_t after, std::size_t reading) const {
  if (count == 0 || after >= members_.size()) return std::nan("");
  const bool cubic = count > 1 && after + 1 < members_.size();
  const std::size_t near[4] = {members_[count - 1], members_[after], members_[count - (cubic ? 2 : 1)],
                               members_[after + (cubic ? 1 : 0)]};
  const std::size_t points = cubic ? 4 : 2;
  double sum = 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j < points; ++j)
      if (j != i) weight *= (times_[reading] - times_[near[j]]) / (times_[near[i]] - times_[near[j]]);
    sum += weight * values_[near[i]];
  }
  return sum;
}

double Course::outside(std::size_t reading) const {
  std::size_t after = 0;
  const std::size_t count = before(reading, after);
  if (count == 0 || after >= members_.size()) return std::nan("");
  const auto [low, high] = std::minmax(values_[members_[count - 1]], values_[members_[after]]);
  return std::max({0.0, low - values_[reading], values_[reading] - high});
}

double Course::roughness(double share) const {
  std::vector<double> errors;
  errors.reserve(members_.size());
  for (std::size_t k = 0; k < members_.size(); ++k)
    if (const double error = std::abs(values_[members_[k]] - between(k, k + 1, members_[k])); std::isfinite(error))
      errors.push_back(error);
  return quantile_of(errors, share);
}

double Course::deviation() const {
  double sum = 0.0, squares = 0.0;
  for (const std::size_t member : members_) sum += values_[member];
  const double mean = sum / static_cast<double>(members_.size());
  for (const std::size_t member : members_) squares += (values_[member] - mean) * (values_[member] - mean);
  return std::sqrt(squares / static_cast<double>(members_.size()));
}

double usual_bend(std::span<const double> v) {
  std::vector<double> bends;
  const auto line = [](double from, double to, double share) { return from + share * (to - from); };
  for (std::size_t i = 2; i + 2 < v.size(); ++i) {
    const double lines[] = {line(v[i - 1], v[i + 1], 0.5),     line(v[i - 2], v[i + 2], 0.5),
                            line(v[i - 2], v[i - 1], 2.0),     line(v[i + 2], v[i + 1], 2.0),
                            line(v[i - 2], v[i + 1], 2.0 / 3), line(v[i - 1], v[i + 2], 1.0 / 3)};
    double bend = std::abs(v[i] - lines[0]);
    for (const double one : lines) bend = std::min(bend, std::abs(v[i] - one));
    bends.push_back(bend);
  }
  return quantile_of(bends, 0.5);
}

double smallest_change(std::span<const double> values) {
  double smallest = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double size = std::abs(values[i] - values[i - 1]);
    if (size > 0.0 && (smallest == 0.0 || size < smallest)) smallest = size;
  }
  return smallest;
}

}  // namespace lacuna

#include "foundation/statistics.h"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

double ranked(std::vector<double>& numbers, std::size_t rank) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(numbers.begin(), at, numbers.end());
  return *at;
}

double root_of_mean(double squares, double count) { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }

}  // namespace

double within_95_of_students_t(double degrees) {
  return boost::math::quantile(boost::math::students_t(degrees), 0.975);
}

double root_mean_square(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return root_of_mean(squares, static_cast<double>(values.size()));
}

double root_mean_square(const Eigen::VectorXd& values) {
  return root_of_mean(values.squaredNorm(), static_cast<double>(values.size()));
}

double root_mean_square(const std::vector<Eigen::VectorXd>& parts) {
  double squares = 0.0, count = 0.0;
  for (const Eigen::VectorXd& part : parts) {
    squares += part.squaredNorm();
    count += static_cast<double>(part.size());
  }
  return root_of_mean(squares, count);
}

double quantile_of(std::vector<double>& numbers, double share) {
  return ranked(numbers,
                numbers.empty() ? 0 : static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1)));
}

double median_of(std::vector<double>& numbers) { return ranked(numbers, numbers.size() / 2); }

}  // namespace lacuna

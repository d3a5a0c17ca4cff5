#include "fitting/fitted_values.h"

#include <cmath>

namespace lacuna {
namespace {

/// Half an interval, in coordinates of the space.
double half_interval(const Uncertainty& known, Eigen::Index j) {
  return known.quantile * std::sqrt(known.covariance(j, j));
}

void enter_interval(const FoundValues& found, Eigen::Index j, FittedValue& value) {
  const FreeValue& free = found.free[static_cast<std::size_t>(j)];
  if (!value.identified) {
    value.standard_error = kInfinity;
    value.lower_95 = free.lower;
    value.upper_95 = free.upper;
    return;
  }
  const double half = half_interval(found.known, j);
  value.standard_error = std::sqrt(found.known.covariance(j, j)) * found.space.slope(j, found.best(j));
  value.lower_95 = found.space.logarithmic(j) ? value.value * std::exp(-half) : value.value - half;
  value.upper_95 = found.space.logarithmic(j) ? value.value * std::exp(half) : value.value + half;
}

}  // namespace

int bound_side(const ParameterSpace& space, const Eigen::VectorXd& values, Eigen::Index j) {
  const double near = 1e-9 * (space.upper()(j) - space.lower()(j));
  if (values(j) <= space.lower()(j) + near) return -1;
  return values(j) >= space.upper()(j) - near ? 1 : 0;
}

void enter_values(const FoundValues& found, FitResult& result) {
  const std::vector<double> values = found.space.to_values(found.best);
  Eigen::VectorXd slopes(found.space.size());
  for (Eigen::Index j = 0; j < found.space.size(); ++j) slopes(j) = found.space.slope(j, found.best(j));
  result.covariance = slopes.asDiagonal() * found.known.covariance * slopes.asDiagonal();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    FittedValue& value = result.values[i];
    value.value = values[i];
    value.at_lower_bound = bound_side(found.space, found.best, j) < 0;
    value.at_upper_bound = bound_side(found.space, found.best, j) > 0;
    value.identified = found.known.determined[i];
    if (!value.at_lower_bound && !value.at_upper_bound) enter_interval(found, j, value);
  }
}

}  // namespace lacuna

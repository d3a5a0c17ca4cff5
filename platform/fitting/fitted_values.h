#pragma once

#include "fitting/intervals/covariance.h"
#include "fitting/fit.h"

#include <vector>

namespace lacuna {

/// −1 where a value, in coordinates of the space, is at its lower bound, 1 at its upper, else 0.
int bound_side(const ParameterSpace& space, const Eigen::VectorXd& values, Eigen::Index j);

/// The end of a search. Everything that it refers to must outlive the use.
struct FoundValues {
  const ParameterSpace& space;
  const std::vector<FreeValue>& free;
  const Eigen::VectorXd& best;  ///< in coordinates of the space
  const Uncertainty& known;
};

/// Enters values, 95 % intervals and covariance into a result, in SI units: Student's t on the coordinates of the
/// space. Values at a bound have no interval; for values that the data do not determine it is their bounds.
void enter_values(const FoundValues& found, FitResult& result);

}  // namespace lacuna

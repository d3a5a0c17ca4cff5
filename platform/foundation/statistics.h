#pragma once

#include <Eigen/Core>

#include <vector>

namespace lacuna {

/// Half of a normal distribution's 95 % interval, in standard deviations.
inline constexpr double kWithin95 = 1.959963984540054;

/// Half of a Student distribution's 95 % interval, in standard errors. `degrees` of freedom, above 0.
double within_95_of_students_t(double degrees);

/// Root mean square of all values together; 0 without any.
double root_mean_square(const std::vector<double>& values);
double root_mean_square(const Eigen::VectorXd& values);
double root_mean_square(const std::vector<Eigen::VectorXd>& parts);

/// The value at `share`, 0 to 1, of the way through the sorted numbers, rounded down; NaN without any. Reorders them.
double quantile_of(std::vector<double>& numbers, double share);

/// The middle one of the sorted numbers, the upper one of two; NaN without any. Reorders them.
double median_of(std::vector<double>& numbers);

}  // namespace lacuna

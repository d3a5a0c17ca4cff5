#pragma once

#include <Eigen/Core>

#include <limits>

namespace lacuna {

/// The parts of an error. All are pure numbers; NaN where they are not defined.
struct ErrorParts {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  /// Theil's inequality coefficient (1966): RMSE over the sum of the root mean squares of measured and predicted,
  /// 0 for a perfect prediction, 1 at worst.
  double theil_u = kUnknown;
  /// Theil's shares of the mean squared error, which sum to 1: of different means, of different standard deviations,
  /// and of incomplete correlation (wrong phase or form).
  double bias_share = kUnknown;
  double magnitude_share = kUnknown;
  double form_share = kUnknown;
  double spread_error = kUnknown;  ///< standard deviation of predicted over that of measured, less 1
  /// Sprague and Geers (2004): relative error of the size, positive where the prediction is too large, and of the
  /// phase, 0 in step to 1 opposed.
  double sprague_geers_magnitude = kUnknown;
  double sprague_geers_phase = kUnknown;
};

/// Rows where either is not finite do not count.
ErrorParts error_parts(const Eigen::VectorXd& measured, const Eigen::VectorXd& predicted);

}  // namespace lacuna

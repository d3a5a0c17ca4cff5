#include "fitting/error_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

/// Means of two series, of their squares and of their product.
struct Moments {
  double measured = 0.0, predicted = 0.0, measured_square = 0.0, predicted_square = 0.0, product = 0.0;
  double error_square = 0.0;
  double count = 0.0;
};

Moments moments_of(const Eigen::VectorXd& measured, const Eigen::VectorXd& predicted) {
  Moments sum;
  for (Eigen::Index i = 0; i < measured.size(); ++i) {
    const double m = measured(i), p = predicted(i);
    if (!std::isfinite(m) || !std::isfinite(p)) continue;
    sum.measured += m;
    sum.predicted += p;
    sum.measured_square += m * m;
    sum.predicted_square += p * p;
    sum.product += m * p;
    sum.error_square += (m - p) * (m - p);
    sum.count += 1.0;
  }
  for (double* value :
       {&sum.measured, &sum.predicted, &sum.measured_square, &sum.predicted_square, &sum.product, &sum.error_square})
    *value /= sum.count;
  return sum;
}

}  // namespace

ErrorParts error_parts(const Eigen::VectorXd& measured, const Eigen::VectorXd& predicted) {
  ErrorParts parts;
  const Moments mean = moments_of(measured, predicted);
  const double power = mean.measured_square * mean.predicted_square;
  if (power > 0.0) {
    const double cosine = std::clamp(mean.product / std::sqrt(power), -1.0, 1.0);
    parts.sprague_geers_magnitude = std::sqrt(mean.predicted_square / mean.measured_square) - 1.0;
    parts.sprague_geers_phase = std::acos(cosine) / std::numbers::pi;
  }
  const double sizes = std::sqrt(mean.measured_square) + std::sqrt(mean.predicted_square);
  if (sizes > 0.0) parts.theil_u = std::sqrt(mean.error_square) / sizes;
  const double spread_measured = std::sqrt(std::max(0.0, mean.measured_square - mean.measured * mean.measured));
  const double spread_predicted = std::sqrt(std::max(0.0, mean.predicted_square - mean.predicted * mean.predicted));
  if (spread_measured > 0.0) parts.spread_error = spread_predicted / spread_measured - 1.0;
  if (!(mean.error_square > 0.0)) return parts;
  parts.bias_share = std::pow(mean.measured - mean.predicted, 2) / mean.error_square;
  parts.magnitude_share = std::pow(spread_measured - spread_predicted, 2) / mean.error_square;
  parts.form_share = std::max(0.0, 1.0 - parts.bias_share - parts.magnitude_share);
  return parts;
}

}  // namespace lacuna

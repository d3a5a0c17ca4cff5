#include "bench/zero_phase.h"

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

/// By the bilinear transform, its frequency corrected; transposed direct form II.
Eigen::VectorXd forwards(const Eigen::VectorXd& values, double interval, double cutoff) {
  const double k = std::tan(std::numbers::pi * cutoff * interval);
  const double scale = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  const double b0 = k * k * scale, b1 = 2.0 * b0, b2 = b0;
  const double a1 = 2.0 * (k * k - 1.0) * scale, a2 = (1.0 - std::numbers::sqrt2 * k + k * k) * scale;
  double first = values(0) * (1.0 - b0), second = values(0) * (b2 - a2);
  Eigen::VectorXd filtered(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    filtered(i) = b0 * values(i) + first;
    first = b1 * values(i) - a1 * filtered(i) + second;
    second = b2 * values(i) - a2 * filtered(i);
  }
  return filtered;
}

}  // namespace

Eigen::VectorXd low_passed(const Eigen::VectorXd& values, double interval, double cutoff) {
  const Eigen::VectorXd once = forwards(values, interval, cutoff).reverse();
  return forwards(once, interval, cutoff).reverse();
}

}  // namespace lacuna

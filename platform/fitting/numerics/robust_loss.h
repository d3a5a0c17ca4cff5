#pragma once

#include <cmath>
#include <limits>

namespace lacuna {

/// Huber's loss on a whitened residual r: r² up to `threshold`, linear beyond it. An infinite threshold
/// is the squared loss.
struct RobustLoss {
  double threshold = std::numeric_limits<double>::infinity();

  double cost(double r) const {
    const double size = std::abs(r);
    return size <= threshold ? r * r : threshold * (2.0 * size - threshold);
  }
  /// The weight with which a squared residual has the loss's gradient.
  double weight(double r) const {
    const double size = std::abs(r);
    return size <= threshold ? 1.0 : threshold / size;
  }
  /// Half the loss's second derivative.
  double curvature(double r) const { return std::abs(r) <= threshold ? 1.0 : 0.0; }
};

}  // namespace lacuna

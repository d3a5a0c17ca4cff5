#pragma once

#include <span>

namespace lacuna {

/// Correlation time of a residual: 1 + 2 Σ of its autocorrelation up to where it falls below 0.1, in samples; at least
/// 1. The mean is not removed, because a bias is an error that never decays.
double correlation_samples(std::span<const double> residuals);

}  // namespace lacuna

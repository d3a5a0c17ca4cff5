#pragma once

#include <span>

namespace lacuna {

/// How long a residual remembers: 1 + 2 Σ of its autocorrelation up to where it falls below 0.1, in samples; at
/// least 1. The mean is not taken off, since a bias is an error that never ends.
double correlation_samples(std::span<const double> residuals);

}  // namespace lacuna

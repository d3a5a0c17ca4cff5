#pragma once

#include <lacuna/fitness_metric.h>

namespace lacuna {

/// The seed's subjective error (Bongard and Lipson, Eq. 1): the mean of |predicted − measured| over all
/// samples and channels, each channel in its own unit. A measured NaN is left out of sum and count; a
/// predicted value that is not finite makes the score infinite, and so does a comparison of nothing.
class MeanAbsoluteDifference : public FitnessMetric {
 public:
  std::string summary() const override;
  std::unique_ptr<ScoreAccumulator> accumulator(const ComparisonShape& shape,
                                                std::span<const double> parameters) const override;
};

}  // namespace lacuna

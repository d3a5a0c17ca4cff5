#pragma once

#include <lacuna/parameter.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace lacuna {

/// The size of a comparison, so that denominators are known before the first sample.
struct ComparisonShape {
  std::size_t trials = 0;
  std::size_t samples = 0;  ///< of all trials together
  std::size_t channels = 0;
};

/// Collects one evaluation. Smaller scores are better.
class ScoreAccumulator {
 public:
  virtual ~ScoreAccumulator() = default;
  /// One sample: one value per channel, in channel units; NaN in `measured` is left out.
  virtual void add(std::span<const double> predicted, std::span<const double> measured) = 0;
  /// The smallest final score that is still possible; never decreases.
  virtual double bound() const = 0;
  virtual double score() const = 0;
  virtual void reset() = 0;
};

/// Scores predictions against measurements. Const and shared by threads; accumulators are not.
class FitnessMetric {
 public:
  virtual ~FitnessMetric() = default;
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  virtual std::unique_ptr<ScoreAccumulator> accumulator(const ComparisonShape& shape,
                                                        std::span<const double> parameters) const = 0;
};

}  // namespace lacuna

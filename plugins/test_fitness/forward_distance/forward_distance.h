#pragma once

#include <lacuna/test_fitness.h>

namespace lacuna {

/// How far forward the best model's centre of mass gets during the test, m.
class ForwardDistance : public TestFitness {
 public:
  std::string summary() const override;
  std::string unit() const override { return "m"; }
  std::size_t models(std::span<const double> parameters) const override;
  /// Throws `Error` where there is no prediction or the path has no sample.
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

}  // namespace lacuna

#pragma once

#include <lacuna/test_fitness.h>

namespace lacuna {

/// All tests are worth the same, so that exploration ends with the first test it drew at random. Needs no model.
class Random : public TestFitness {
 public:
  std::string summary() const override;
  std::string unit() const override { return "1"; }
  std::size_t models(std::span<const double> parameters) const override;
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

}  // namespace lacuna

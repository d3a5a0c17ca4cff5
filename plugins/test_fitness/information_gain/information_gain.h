#pragma once

#include <lacuna/test_fitness.h>

namespace lacuna {

/// What a test is expected to tell about the models' free values: the mean over the models of how much narrower it
/// makes what the trials so far and the ranges leave of them, in nats, to first order (Bayesian D-optimality).
///
/// Literature: D. V. Lindley, Annals of Mathematical Statistics 27 (1956) 986-1005; K. Chaloner and I. Verdinelli,
/// Statistical Science 10 (1995) 273-304.
class InformationGain : public TestFitness {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  std::string unit() const override { return "1"; }
  std::size_t models(std::span<const double> parameters) const override;
  bool wants_slopes(std::span<const double>) const override { return true; }
  /// Throws `Error` where there is no prediction or no noise is known.
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

}  // namespace lacuna

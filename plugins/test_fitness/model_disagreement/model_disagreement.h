#pragma once

#include <lacuna/test_fitness.h>

namespace lacuna {

/// How far apart the best models' predictions of the sensors are: the mean over all pairs of half their squared
/// difference in noise deviations, which is what one trial is expected to add to the log likelihood of the right one
/// over the other. With `refit`, of what is left of the difference when the wrong one has been fitted to the trial.
///
/// Literature: W. G. Hunter and A. M. Reiner, Technometrics 7 (1965) 307-323; A. C. Atkinson and V. V. Fedorov,
/// Biometrika 62 (1975) 57-70.
class ModelDisagreement : public TestFitness {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  std::string unit() const override { return "1"; }
  std::size_t models(std::span<const double> parameters) const override;
  bool wants_slopes(std::span<const double> parameters) const override;
  /// Throws `Error` where there are less than two predictions, they differ in their shape, no noise is known, or slopes
  /// are missing that a refit needs.
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

}  // namespace lacuna

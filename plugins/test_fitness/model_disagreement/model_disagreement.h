#pragma once

#include <lacuna/test_fitness.h>

namespace lacuna {

/// How far apart the best models' predictions of the sensors are: the mean over all pairs of half their squared
/// difference in noise deviations, which is what one trial is expected to add to the log likelihood of the right one
/// over the other. It counts what it is given: whoever wants rivals that would be refitted to the trial hands over
/// what a refit leaves of their difference (diagnosis/rival_refit.h), in multiples of the deviation.
///
/// Literature: W. G. Hunter and A. M. Reiner, Technometrics 7 (1965) 307-323; A. C. Atkinson and V. V. Fedorov,
/// Biometrika 62 (1975) 57-70.
class ModelDisagreement : public TestFitness {
 public:
  std::string summary() const override;
  ParameterDeclarations parameters() const override;
  std::string unit() const override { return "1"; }
  std::size_t models(std::span<const double> parameters) const override;
  /// Throws `Error` where there are less than two predictions or they differ in their shape.
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

}  // namespace lacuna

#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/plugin.h>
#include <lacuna/test_fitness.h>

#include "pair_difference.h"

#include <algorithm>
#include <vector>

namespace lacuna {

/// Difference between the best models' predictions of the sensors: the mean over all pairs of half their squared
/// difference in standard deviations of the noise, which one trial is expected to add to the log likelihood of the
/// right one over the other. With `refit`, the difference that remains after the wrong one was fitted to the trial.
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
  /// Throws `Error` where there are fewer than two predictions, they differ in their shape, the noise is unknown, or
  /// slopes are missing that a refit needs.
  double score(const Test& test, std::span<const TestPrediction> predictions,
               std::span<const double> parameters) const override;
};

namespace {

enum Parameter : std::size_t { kModels, kNoise, kRefit };

/// For each channel: the value in the file for all, or that of the predictions.
std::vector<double> noise_of(const TestPrediction& prediction, double for_all) {
  std::vector<double> noise = prediction.noise;
  if (for_all > 0.0) noise.assign(static_cast<std::size_t>(prediction.sensors.samples.cols()), for_all);
  if (noise.empty() || !std::all_of(noise.begin(), noise.end(), [](double deviation) { return deviation > 0.0; }))
    throw Error("the noise of the sensors is unknown; state it with fitness_parameters = { noise = ... }");
  return noise;
}

}  // namespace

std::string ModelDisagreement::summary() const {
  return "Difference between the best models' predictions: expected evidence of a trial between two of them, in nats";
}

ParameterDeclarations ModelDisagreement::parameters() const {
  return {{"models", "1", 2.0, 2.0, 100.0, Scale::linear, "Number of models that are compared"},
          {"noise", "1", 0.0, 0.0, 1e12, Scale::linear,
           "Standard deviation of a reading, in the SI unit of its channel, for all channels; 0: for each channel as "
           "declared or as estimated from the trials so far"},
          {"refit", "1", 0.0, 0.0, 1.0, Scale::linear,
           "1: only the part of a difference that remains after a refit of the wrong model counts; 0: all of it"}};
}

std::size_t ModelDisagreement::models(std::span<const double> parameters) const {
  return count_parameter(this->parameters()[kModels], parameters[kModels]);
}

bool ModelDisagreement::wants_slopes(std::span<const double> parameters) const {
  return count_parameter(this->parameters()[kRefit], parameters[kRefit]) == 1;
}

double ModelDisagreement::score(const Test&, std::span<const TestPrediction> predictions,
                                std::span<const double> parameters) const {
  if (predictions.size() < 2)
    throw Error("one model alone cannot disagree; raise the population or the number of models kept to at least 2");
  const std::vector<double> noise = noise_of(predictions.front(), parameters[kNoise]);
  const bool refit = wants_slopes(parameters);
  double sum = 0.0, pairs = 0.0;
  for (std::size_t i = 0; i < predictions.size(); ++i)
    for (std::size_t j = i + 1; j < predictions.size(); ++j, ++pairs) {
      const PairDifference difference(predictions[i], predictions[j], noise);
      sum += refit ? difference.squared_after_refit() : difference.squared();
    }
  return 0.5 * sum / pairs;
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestFitness, lacuna::ModelDisagreement>("model_disagreement"))

#include "model_disagreement.h"

#include <lacuna/count_parameter.h>
#include <lacuna/error.h>
#include <lacuna/plugin.h>

namespace lacuna {
namespace {

enum Parameter : std::size_t { kModels, kNoise };

double squared_difference(const TestPrediction& one, const TestPrediction& other) {
  const TimeSeries::Samples &a = one.sensors.samples, &b = other.sensors.samples;
  if (a.rows() != b.rows() || a.cols() != b.cols())
    throw Error("the models predict " + std::to_string(a.rows()) + " × " + std::to_string(a.cols()) + " and " +
                std::to_string(b.rows()) + " × " + std::to_string(b.cols()) +
                " readings; they must be of one test and the same sensors");
  return (a - b).squaredNorm();
}

}  // namespace

std::string ModelDisagreement::summary() const {
  return "How far apart the best models' predictions are, in nats that a trial is expected to tell between two of them";
}

ParameterDeclarations ModelDisagreement::parameters() const {
  return {{"models", "1", 2.0, 2.0, 100.0, Scale::linear, "Number of the best models that are held against each other"},
          {"noise", "1", 1.0, 1e-12, 1e12, Scale::logarithmic,
           "Standard deviation of a reading, in the SI unit of its channel"}};
}

std::size_t ModelDisagreement::models(std::span<const double> parameters) const {
  return count_parameter(this->parameters()[kModels], parameters[kModels]);
}

double ModelDisagreement::score(const Test&, std::span<const TestPrediction> predictions,
                                std::span<const double> parameters) const {
  if (predictions.size() < 2)
    throw Error("one model alone disagrees with nobody; raise the population, or the number kept, to two at least");
  double sum = 0.0, pairs = 0.0;
  for (std::size_t i = 0; i < predictions.size(); ++i)
    for (std::size_t j = i + 1; j < predictions.size(); ++j, ++pairs)
      sum += squared_difference(predictions[i], predictions[j]);
  return 0.5 * sum / (pairs * parameters[kNoise] * parameters[kNoise]);
}

}  // namespace lacuna

LACUNA_PLUGIN(lacuna::component<lacuna::TestFitness, lacuna::ModelDisagreement>("model_disagreement"))

#include "eea/ensemble/ensemble_prediction.h"

#include "eea/ensemble/reading_noise.h"
#include "evaluation/model/channel_map.h"
#include "evaluation/prediction/test_predictor.h"
#include "foundation/parallel.h"

#include <algorithm>
#include <utility>

namespace lacuna {

std::vector<double> sampled_at(const ScoredTrial& scored) {
  return {scored.trial.measured.times.begin(), scored.trial.measured.times.end()};
}

void add_unless_copy(PassEnsemble& ensemble, std::uint64_t number, ModelProposal model, const Phenotypes& phenotypes) {
  const std::string phenotype = phenotypes.of(model);
  if (std::any_of(ensemble.models.begin(), ensemble.models.end(),
                  [&](const ModelProposal& other) { return phenotypes.of(other) == phenotype; })) {
    ++ensemble.copies;
    return;
  }
  ensemble.numbers.push_back(number);
  ensemble.models.push_back(std::move(model));
}

Test as_carried_out(const ScoredTrial& observed) {
  Test test = observed.test;
  test.start = {};
  for (const InitialValue& value : observed.trial.initial) {
    test.start.positions.push_back(value.position);
    test.start.velocities.push_back(value.velocity);
  }
  return test;
}

EnsemblePrediction predict_test(const EeaDefinition& definition, const PassEnsemble& ensemble, const Test& test,
                                const std::vector<double>& times, const Work& work, double start) {
  const std::size_t count = ensemble.models.size();
  const Work shared{std::clamp(work.threads, 1, static_cast<int>(count)), work.stop};
  const TestPredictor predictor(*definition.compiled, times, shared, &definition.model, 1, start);
  std::vector<TestPrediction> predicted(count);
  std::vector<std::string> reasons(count);
  std::vector<std::uint8_t> carried_out(count);  // not bool: written by several threads
  parallel_for(count, predictor.workers(), [&](std::size_t i, int worker) {
    std::uint64_t steps = 0;
    carried_out[i] = predictor.predict(ensemble.models[i], test, worker, predicted[i], steps, reasons[i]) ? 1 : 0;
  });
  EnsemblePrediction prediction;
  prediction.times = Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
  prediction.channels = definition.compiled->channels();
  std::vector<TimeSeries::Samples> samples;
  for (std::size_t i = 0; i < count; ++i)
    if (carried_out[i])
      samples.push_back(std::move(predicted[i].sensors.samples));
    else
      prediction.lost.push_back({ensemble.numbers[i], reasons[i]});
  prediction.models = samples.size();
  if (!samples.empty()) prediction.band = band_of(samples, ensemble.noise);
  return prediction;
}

std::vector<double> noise_of_readings(const EeaDefinition& definition, const ModelProposal& best,
                                      const std::vector<ScoredTrial>& fitted, std::uint64_t& steps, const Stop& stop) {
  ReadingNoise noise(definition.compiled->channels().size());
  for (const ScoredTrial& scored : fitted) {
    const TestPredictor predictor(*definition.compiled, sampled_at(scored), {1, stop}, &definition.model, 1,
                                  scored.trial.measured.times(0));
    TestPrediction predicted;
    std::string reason;
    if (predictor.predict(best, as_carried_out(scored), 0, predicted, steps, reason))
      noise.add(scored.trial, match_channels(scored.trial, definition.compiled->channels()), predicted.sensors);
  }
  return noise.deviations();
}

HeldOutTrial held_against(const EeaDefinition& definition, const PassEnsemble& ensemble, int number,
                          const ScoredTrial& observed, const Stop& stop) {
  const std::vector<Channel>& channels = definition.compiled->channels();
  HeldOutTrial held_out{number, ensemble.pass, std::vector<std::vector<double>>(channels.size())};
  const EnsemblePrediction prediction = predict_test(definition, ensemble, as_carried_out(observed),
                                                     sampled_at(observed), {1, stop}, observed.trial.measured.times(0));
  if (prediction.models > 0)
    held_out.ratios = band_ratios(prediction.band, observed.trial, match_channels(observed.trial, channels));
  return held_out;
}

}  // namespace lacuna

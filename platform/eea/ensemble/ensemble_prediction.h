#pragma once

#include "eea/ensemble/band_support.h"
#include "eea/definition/eea_definition.h"
#include "foundation/work.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lacuna {

/// The models that a pass hands on, best first, which differ and explain the same trials.
struct PassEnsemble {
  int pass = 0;
  std::vector<std::uint64_t> numbers;  ///< of the models within their run
  std::vector<ModelProposal> models;
  std::size_t copies = 0;     ///< number of copies that were left out: two equal models are one prediction
  std::size_t refuted = 0;    ///< number of models left out because they explain those trials much worse than the best
  std::vector<double> noise;  ///< standard deviation of a reading, one per channel; not finite where it is not known
};

/// Adds a model unless a simulation cannot distinguish it from one already here.
void add_unless_copy(PassEnsemble& ensemble, std::uint64_t number, ModelProposal model, const Phenotypes& phenotypes);

/// A model that cannot carry a test out.
struct LostModel {
  std::uint64_t number = 0;
  std::string reason;
};

/// The prediction of a test by an ensemble.
struct EnsemblePrediction {
  Eigen::VectorXd times;          ///< s
  std::vector<Channel> channels;  ///< of the model's sensors
  EnsembleBand band;              ///< of size zero where no model could carry the test out
  std::size_t models = 0;         ///< models that carried the test out
  std::vector<LostModel> lost;
};

/// Sample times of a trial, s.
std::vector<double> sampled_at(const ScoredTrial& scored);

/// A trial's test with the initial state that the trial states.
Test as_carried_out(const ScoredTrial& observed);

/// `times`: when sensors are read, s; the test begins at `start`. Each model is driven by the test's controller, which
/// responds to that model, or by its commands.
EnsemblePrediction predict_test(const EeaDefinition& definition, const PassEnsemble& ensemble, const Test& test,
                                const std::vector<double>& times, const Work& work, double start = 0.0);

/// The noise of a reading, one per channel of the model's (`ReadingNoise`): as the trials declare it that the ensemble
/// was fitted to, else from the residual of the best model on them. Adds the steps taken to `steps`.
std::vector<double> noise_of_readings(const EeaDefinition& definition, const ModelProposal& best,
                                      const std::vector<ScoredTrial>& fitted, std::uint64_t& steps,
                                      const Stop& stop = {});

/// A whole trial that the ensemble was not fitted to; without ratios where no model can carry it out.
HeldOutTrial held_against(const EeaDefinition& definition, const PassEnsemble& ensemble, int number,
                          const ScoredTrial& observed, const Stop& stop = {});

}  // namespace lacuna

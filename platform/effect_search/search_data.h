#pragma once

#include "prediction/descent.h"
#include "prediction/prediction_lengths.h"
#include "search/ground.h"

#include <memory>
#include <string>

namespace lacuna {

/// A stamp that is written once a command has been sent leaves half an interval open. Later than recorded is a delay,
/// which is to be named.
inline constexpr TimingRange kCommandsMayAct = {-0.5, 0.0};

/// Whether a model has effects or free values of sensors, so that readings tell its starts only through them.
bool changes_readings(const ModelDefinition& definition);

/// What all models of a search have in common: recordings, starts, lengths of prediction, noise of readings.
class SearchData {
 public:
  /// Throws `NothingPredictable` where the model cannot be simulated from the starts that the readings tell.
  explicit SearchData(const MissingTask& task);

  const MissingTask& task() const { return task_; }
  const Contender& plain() const { return plain_; }  ///< the model as it is
  const SmoothedStarts& starts() const { return *starts_; }
  const PredictionLadder& ladder() const { return ladder_; }      ///< of all lengths
  const PredictionLadder& deciding() const { return deciding_; }  ///< of the shortest
  bool timing() const { return timing_; }  ///< when commands act is fitted, as a last value beside the model's

  ModelBench bench_for(const Contender& model) const {
    return {model.definition, *model.model, task_.trials, timing_, task_.threads, kCommandsMayAct};
  }

 private:
  void build_ladders();
  void choose_substeps();

  const MissingTask task_;
  bool timing_ = false;
  Contender plain_, reader_;
  std::vector<ChannelNoise> noise_;
  std::unique_ptr<ModelBench> readings_;
  std::unique_ptr<StartStates> states_;
  std::unique_ptr<SmoothedStarts> starts_;
  PredictionLadder ladder_, deciding_;
};

}  // namespace lacuna

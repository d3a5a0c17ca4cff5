#pragma once

#include "config/experiment.h"
#include "diagnosis/candidates/contender.h"
#include "diagnosis/refit/timing.h"
#include "horizons/linear_ladder.h"
#include "loading/plugin_catalog.h"
#include "search/unfinished_search.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// There is no horizon at which predictions can be judged; the sentence says why, and what to do.
class NothingPredictable : public Error {
 public:
  using Error::Error;
};

/// What is searched for a model's missing effects. Everything referred to must live as long as the search.
struct MissingTask {
  const Experiment& experiment;
  const PluginCatalog& catalog;
  const std::vector<Trial>& trials;     ///< held-out ones are looked at once the answer stands
  std::vector<double> values;           ///< of the model's free values, to begin with
  std::vector<std::string> among = {};  ///< effects to try; empty: all
  int threads = 1;
  const KeptFits* known = nullptr;                    ///< of an earlier search for the same; null: none
  std::function<void(const KeptFits&)> keep = {};     ///< gets all fits after each
  std::function<void(const std::string&)> note = {};  ///< gets a line for every look and fit
};

/// One model of a search: its parts, put together for predictions by some threads.
class ModelBench {
 public:
  ModelBench(const ModelDefinition& definition, const CompiledModel& model, const std::vector<Trial>& trials,
             bool timing, int threads, const TimingRange& timing_range = {});

  const ModelDefinition& definition() const { return definition_; }
  const TrialPredictor& predictor() const { return predictor_; }
  const ParameterSpace& space() const { return space_; }

 private:
  const ModelDefinition& definition_;
  TrialPredictor predictor_;
  ParameterSpace space_;
};

/// What all models of a search have in common: starts, lengths, floors, weights and integration steps.
class Ground {
 public:
  /// Fits the model as it is. Throws `NothingPredictable`.
  explicit Ground(const MissingTask& task);

  const MissingTask& task() const { return task_; }
  const Contender& plain() const { return plain_; }  ///< the model as it is
  const HorizonFit& fit() const { return fit_; }     ///< of it
  const Ladder& ladder() const { return ladder_; }
  int coordinates() const { return states_->coordinates(); }  ///< of the robot
  double block() const { return block_; }                     ///< s, of time that is drawn together
  const SmoothedStarts& starts() const { return *starts_; }
  const std::vector<ChannelNoise>& noise() const { return noise_; }  ///< of readings
  bool timing() const { return timing_; }  ///< when commands act is fitted, as a last value beside the model's

  /// Another model of the same robot, on the task's trials. `model` must outlive it.
  ModelBench bench_for(const Contender& model) const {
    return {model.definition, *model.model, task_.trials, timing_, task_.threads};
  }
  /// The ladder's segments for another model.
  Ladder ladder_for(const ModelBench& bench, bool held_out = false) const;

 private:
  void choose_substeps();
  LadderTask task_of(const ModelBench& bench, const std::vector<double>& values, bool held_out) const;

  const MissingTask task_;
  bool timing_ = false;
  Contender plain_;
  std::vector<ChannelNoise> noise_;
  Contender reader_;  ///< by whose channels readings are known
  std::unique_ptr<ModelBench> readings_, bench_;
  std::unique_ptr<StartStates> states_;
  std::unique_ptr<SmoothedStarts> starts_;
  Ladder ladder_;
  HorizonFit fit_;
  double block_ = 0.0;
};

}  // namespace lacuna

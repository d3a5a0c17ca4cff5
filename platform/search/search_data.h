#pragma once

#include "config/schema/experiment.h"
#include "candidates/augmented_model.h"
#include "candidates/data_scales.h"
#include "candidates/timing.h"
#include "loading/plugin_catalog.h"
#include "prediction/acceleration_steps.h"
#include "prediction/descent.h"
#include "prediction/prediction_lengths.h"
#include "search/kept_fits.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// No prediction can be evaluated; the message says why and what to do.
class NothingPredictable : public Error {
 public:
  using Error::Error;
};

/// The task of a search. Everything that it refers to must live as long as the search.
struct EffectSearchTask {
  const Experiment& experiment;
  const PluginCatalog& catalog;
  const std::vector<Trial>& trials;                   ///< held-out trials are read only after the answer is chosen
  std::vector<double> values;                         ///< start values of the model's free values
  std::vector<std::string> among = {};                ///< effects to try; empty: all
  Work work = {};                                     ///< its progress is not reported: see `note`
  const KeptFits* known = nullptr;                    ///< fits of an earlier search for the same task; null: none
  std::function<void(const KeptFits&)> keep = {};     ///< receives all fits after each new one
  std::function<void(const std::string&)> note = {};  ///< receives a line for every step and fit
};

/// One candidate model, ready for predictions by several threads.
class ModelContext {
 public:
  ModelContext(const ModelDefinition& definition, const CompiledModel& model, const std::vector<Trial>& trials,
               bool timing, const Work& work, const TimingRange& timing_range = {});

  const TrialPredictor& predictor() const { return predictor_; }
  const ParameterSpace& space() const { return space_; }

 private:
  TrialPredictor predictor_;
  ParameterSpace space_;
};

/// Range of the timestamp offset. A time stamp that is written after a command was sent leaves half an interval open. A
/// later action than that is a delay, which is an effect.
inline constexpr TimingRange kCommandsMayAct = {-0.5, 0.0};

/// Whether a model has effects or free values of sensors, which change the initial states that readings give.
bool changes_readings(const ModelDefinition& definition);

/// Data shared by all models of a search: recordings, initial states, prediction lengths, noise of readings.
class SearchData {
 public:
  /// Throws `NothingPredictable` where the model cannot be simulated from the initial states of the recordings.
  explicit SearchData(const EffectSearchTask& task);

  const EffectSearchTask& task() const { return task_; }
  const AugmentedModel& plain() const { return plain_; }  ///< the model as it is
  const SmoothedStarts& starts() const { return *starts_; }
  const PredictionLadder& ladder() const { return ladder_; }      ///< of all lengths
  const PredictionLadder& deciding() const { return deciding_; }  ///< of the shortest
  const AccelerationSteps& acceleration_steps() const { return acceleration_steps_; }
  /// The same lengths over what is held out; no stretches where nothing is.
  PredictionLadder held_out() const;
  /// See `data_scales`.
  const std::map<std::string, double>& scales() const { return scales_; }
  /// Limits values of added effects to what the readings resolve.
  void bound(AugmentedModel& model) const { bound_by_resolution(model.placed, scales_, model.definition.free); }
  void bound(std::vector<Hypothesis>& hypotheses) const;
  double readings() const;  ///< that are fitted
  /// Whether there are readings enough for so many values: eight for each.
  bool tells(double values) const;
  /// Whether the timestamp offset of commands is fitted as a last value beside the model's.
  bool timing() const { return timing_; }

  ModelContext bench_for(const AugmentedModel& model) const {
    return {model.definition, *model.model, task_.trials, timing_, task_.work, kCommandsMayAct};
  }

 private:
  LadderSource source(const ModelContext& context) const;
  void build_ladders();
  void choose_substeps();

  const EffectSearchTask task_;
  const std::map<std::string, double> scales_;
  bool timing_ = false;
  AugmentedModel plain_, reader_;
  std::vector<ChannelNoise> noise_;
  std::unique_ptr<ModelContext> readings_;
  std::unique_ptr<StartStates> states_;
  std::unique_ptr<SmoothedStarts> starts_;
  PredictionLadder ladder_, deciding_;
  AccelerationSteps acceleration_steps_;
};

}  // namespace lacuna

#pragma once

#include "config/schema/experiment.h"
#include "candidates/contender.h"
#include "candidates/data_scales.h"
#include "candidates/timing.h"
#include "loading/plugin_catalog.h"
#include "prediction/descent.h"
#include "prediction/prediction_lengths.h"
#include "search/kept_fits.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lacuna {

/// No prediction can be judged; the sentence says why, and what to do.
class NothingPredictable : public Error {
 public:
  using Error::Error;
};

/// What is searched for a model's missing effects. Everything referred to must live as long as the search.
struct EffectSearchTask {
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

  const TrialPredictor& predictor() const { return predictor_; }
  const ParameterSpace& space() const { return space_; }

 private:
  TrialPredictor predictor_;
  ParameterSpace space_;
};

/// A stamp that is written once a command has been sent leaves half an interval open. Later than recorded is a delay,
/// which is to be named.
inline constexpr TimingRange kCommandsMayAct = {-0.5, 0.0};

/// Whether a model has effects or free values of sensors, so that readings tell its starts only through them.
bool changes_readings(const ModelDefinition& definition);

/// What all models of a search have in common: recordings, starts, lengths of prediction, noise of readings.
class SearchData {
 public:
  /// Throws `NothingPredictable` where the model cannot be simulated from the starts that the readings tell.
  explicit SearchData(const EffectSearchTask& task);

  const EffectSearchTask& task() const { return task_; }
  const Contender& plain() const { return plain_; }  ///< the model as it is
  const SmoothedStarts& starts() const { return *starts_; }
  const PredictionLadder& ladder() const { return ladder_; }      ///< of all lengths
  const PredictionLadder& deciding() const { return deciding_; }  ///< of the shortest
  /// The same lengths over what is held out; no stretches where nothing is.
  PredictionLadder held_out() const;
  /// See `data_scales`.
  const std::map<std::string, double>& scales() const { return scales_; }
  /// Keeps values of added effects within what the readings resolve.
  void bound(Contender& model) const { bound_by_resolution(model.added, scales_, model.definition.free); }
  void bound(std::vector<Hypothesis>& hypotheses) const;
  double readings() const;  ///< that are fitted
  /// Whether there are readings enough for so many values: eight for each.
  bool tells(double values) const;
  bool timing() const { return timing_; }  ///< when commands act is fitted, as a last value beside the model's

  ModelBench bench_for(const Contender& model) const {
    return {model.definition, *model.model, task_.trials, timing_, task_.threads, kCommandsMayAct};
  }

 private:
  LadderSource source(const ModelBench& bench) const;
  void build_ladders();
  void choose_substeps();

  const EffectSearchTask task_;
  const std::map<std::string, double> scales_;
  bool timing_ = false;
  Contender plain_, reader_;
  std::vector<ChannelNoise> noise_;
  std::unique_ptr<ModelBench> readings_;
  std::unique_ptr<StartStates> states_;
  std::unique_ptr<SmoothedStarts> starts_;
  PredictionLadder ladder_, deciding_;
};

}  // namespace lacuna

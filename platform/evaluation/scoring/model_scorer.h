#pragma once

#include <lacuna/fitness_metric.h>
#include "foundation/score_kind.h"
#include "evaluation/scoring/candidate_simulator.h"
#include "evaluation/model/component_choice.h"
#include "evaluation/scoring/lag_profile.h"
#include "evaluation/scoring/scored_trial.h"
#include "foundation/work.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// The result of a model's evaluation.
struct ModelScore {
  double total = 0.0;  ///< over all trials together; smaller is better
  /// Of each trial that was begun; the last one of an abandoned or invalid evaluation is a bound.
  std::vector<double> trials;
  ScoreKind kind = ScoreKind::full;
  std::string reason;
  std::uint64_t steps = 0;  ///< integration steps
  /// The model's free values with the fitted delays; empty where none are fitted.
  std::vector<double> values = {};
};

/// Compares models with trials by a metric. Deterministic: a score depends only on the arguments of `score`. The
/// compiled model, and the definition where models may have their own robot or lack effects, must outlive it.
class ModelScorer {
 public:
  /// Makes a workspace for each thread of `work`. `profiled`: free values that are delays of sensors and not part
  /// of a candidate, but fitted for each (lag_profile.h), which needs a definition. Throws `Error` where a trial
  /// measures a channel that the model does not have.
  ModelScorer(const CompiledModel& model, std::vector<ScoredTrial> trials, Chosen<FitnessMetric> metric,
              const Work& work, const ModelDefinition* definition = nullptr,
              const std::vector<std::size_t>& profiled = {});
  ModelScorer(const ModelScorer&) = delete;
  ModelScorer& operator=(const ModelScorer&) = delete;
  ~ModelScorer();

  std::size_t trials() const { return trials_.size(); }
  int workers() const { return static_cast<int>(simulators_.size()); }

  /// Simulates the trials in their order until the total is certain to exceed `bar`. Without a limit to the end.
  void score(const ModelProposal& candidate, std::optional<double> bar, int worker, ModelScore& result) const;

 private:
  struct Desk;
  struct Tally;
  void score_trials(const ModelProposal& candidate, double bar, Desk& simulator, ModelScore& result) const;
  void score_trial(std::size_t trial, double bar, Desk& simulator, ModelScore& result) const;
  void score_with_lags(const ModelProposal& candidate, double bar, Desk& simulator, ModelScore& result) const;
  void end_trial(std::size_t trial, const Tally& tally, ModelScore& result) const;
  std::string why_not_finite(const Desk& simulator, double score) const;
  bool read_trials(const ModelProposal& candidate, Desk& simulator, ModelScore& result) const;

  std::vector<ScoredTrial> trials_;
  std::vector<std::vector<Eigen::Index>> maps_;  ///< per trial: measured channel → model channel
  Chosen<FitnessMetric> metric_;
  LagProfile lags_;
  std::vector<std::unique_ptr<Desk>> simulators_;
};

}  // namespace lacuna

#pragma once

#include "eea/definition/eea_state.h"
#include "evaluation/scoring/model_scorer.h"

#include <lacuna/test_fitness.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// A model to evaluate and its genome. Both outlive the call.
struct CandidateModel {
  const Genome* genome = nullptr;
  const ModelProposal* model = nullptr;
};

/// The result of evaluating a test.
struct JudgedTest {
  double fitness = kNotKnown;  ///< larger is better
  std::string reason;          ///< why it has none
  std::uint64_t steps = 0;
};

/// The simulated behaviour of a model in a test.
struct PredictedTrial {
  bool valid = false;  ///< false: it cannot carry the test out
  TestPrediction prediction;
  std::uint64_t steps = 0;
};

/// Simulates the models of a replicate: in this process (local_evaluations.h) or in others (isolation/), with the same
/// digits.
class Evaluations {
 public:
  virtual ~Evaluations() = default;

  /// From now on `score` compares models with those trials of the state that count in its pass.
  virtual void begin_estimation(const EeaState& state) = 0;
  /// One score per candidate; see `ModelScorer`.
  virtual std::vector<ModelScore> score(std::span<const CandidateModel> candidates, std::optional<double> bar) = 0;

  /// From now on `judge` uses the best models of the state's last estimation phase. Returns the steps taken to evaluate
  /// the trials.
  virtual std::uint64_t begin_exploration(const EeaState& state) = 0;
  /// One judgement per test. A test that the encoding, a model or the fitness refuses has a reason and no fitness.
  virtual std::vector<JudgedTest> judge(std::span<const Genome> tests) = 0;

  /// Compares a model with one trial, as in the scores of a pass.
  virtual ModelScore score_on(const KnownModel& model, const TargetTrial& trial, int pass) = 0;
  /// Simulates a model in the test of a trial.
  virtual PredictedTrial predict_trial(const KnownModel& model, const TargetTrial& trial) = 0;
  /// Compares models with all channels of the state's trials that count; their `values` include the delays that are not
  /// genes.
  virtual std::vector<ModelScore> find_delays(std::span<const KnownModel* const> models, const EeaState& state) = 0;
};

}  // namespace lacuna

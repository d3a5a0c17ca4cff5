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

/// A model to be evaluated: what a genome stands for. Both outlive the call.
struct CandidateModel {
  const Genome* genome = nullptr;
  const ModelProposal* model = nullptr;
};

/// What was found out about a test.
struct JudgedTest {
  double fitness = kNotKnown;  ///< larger is better
  std::string reason;          ///< why it has none
  std::uint64_t steps = 0;
};

/// What a model would do in a test.
struct ForetoldTrial {
  bool valid = false;  ///< else it cannot carry the test out
  TestPrediction prediction;
  std::uint64_t steps = 0;
};

/// Where the models of a replicate are simulated: in this process (local_evaluations.h) or in others (isolation/).
/// Either way gives the same digits.
class Evaluations {
 public:
  virtual ~Evaluations() = default;

  /// From now on `score` holds models against those trials of the state that count in its pass.
  virtual void begin_estimation(const EeaState& state) = 0;
  /// One score a candidate; see `ModelScorer`.
  virtual std::vector<ModelScore> score(std::span<const CandidateModel> candidates, std::optional<double> bar) = 0;

  /// From now on `judge` asks the best models of the state's last estimation phase. The steps that it took to find out
  /// what the trials say.
  virtual std::uint64_t begin_exploration(const EeaState& state) = 0;
  /// One judgement a test. A test that the encoding, a model or the fitness refuses has a reason and no fitness.
  virtual std::vector<JudgedTest> judge(std::span<const Genome> tests) = 0;

  /// A model held against one trial as those of a pass are.
  virtual ModelScore score_on(const KnownModel& model, const TargetTrial& trial, int pass) = 0;
  /// What a model would do in the test of a trial.
  virtual ForetoldTrial foretell(const KnownModel& model, const TargetTrial& trial) = 0;
  /// Models held against all that the trials of the state measured which count: their `values` have the delays that are
  /// no genes.
  virtual std::vector<ModelScore> find_delays(std::span<const KnownModel* const> models, const EeaState& state) = 0;
};

}  // namespace lacuna

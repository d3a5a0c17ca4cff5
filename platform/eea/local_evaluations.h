#pragma once

#include "eea/definition/eea_definition.h"
#include "eea/definition/evaluations.h"
#include "foundation/work.h"

#include <memory>

namespace lacuna {

/// Simulates models in this process.
class LocalEvaluations : public Evaluations {
 public:
  /// The definition must outlive it.
  LocalEvaluations(const EeaDefinition& definition, const Work& work);
  ~LocalEvaluations() override;

  void begin_estimation(const EeaState& state) override;
  std::vector<ModelScore> score(std::span<const CandidateModel> candidates, std::optional<double> bar) override;
  std::uint64_t begin_exploration(const EeaState& state) override;
  std::vector<JudgedTest> judge(std::span<const Genome> tests) override;
  ModelScore score_on(const KnownModel& model, const TargetTrial& trial, int pass) override;
  PredictedTrial predict_trial(const KnownModel& model, const TargetTrial& trial) override;
  std::vector<ModelScore> find_delays(std::span<const KnownModel* const> models, const EeaState& state) override;

 private:
  struct Panel;

  const EeaDefinition& definition_;
  Work work_;
  std::unique_ptr<ModelScorer> scorer_;  ///< of the current estimation phase
  std::unique_ptr<Panel> panel_;         ///< of the current exploration phase
};

}  // namespace lacuna

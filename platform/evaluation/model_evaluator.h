#pragma once

#include "evaluation/model_definition.h"
#include "evaluation/model_scorer.h"
#include "evaluation/phenotypes.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace lacuna {

struct EvaluationOptions {
  bool abandon = true;  ///< end an evaluation that cannot get under the bar
  bool reuse = true;    ///< simulate identical phenotypes once
};

struct EvaluatedModel {
  ModelScore score;
  bool reused = false;  ///< an identical model was scored before; its score counts
};

/// Scores generations of models, in parallel, with the same results for any number of threads. Remembers
/// phenotypes.
class ModelEvaluator {
 public:
  /// The scorer must outlive it; its trials are the same for all that is remembered.
  ModelEvaluator(const ModelScorer& scorer, const ModelDefinition& definition, EvaluationOptions options);

  /// One score for each model. Nothing that is above `bar` is known but that.
  std::vector<EvaluatedModel> evaluate(const std::vector<ModelProposal>& models, std::optional<double> bar);
  /// As if it had been evaluated, for a run that goes on.
  void remember(const ModelProposal& model, const ModelScore& score);

 private:
  const ModelScore* recall(const std::string& phenotype, std::optional<double> bar) const;

  const ModelScorer& scorer_;
  EvaluationOptions options_;
  Phenotypes phenotypes_;
  std::unordered_map<std::string, ModelScore> memory_;
};

}  // namespace lacuna

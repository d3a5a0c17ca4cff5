#pragma once

#include "evaluation/model/model_definition.h"
#include "evaluation/scoring/model_scorer.h"
#include "evaluation/scoring/phenotypes.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace lacuna {

struct EvaluationOptions {
  bool abandon = true;  ///< end an evaluation that cannot get below the limit
  bool reuse = true;    ///< simulate identical phenotypes once
};

struct EvaluatedModel {
  ModelScore score;
  bool reused = false;  ///< an identical model was scored before; its score counts
};

/// Scores the models with these indices, in this order.
using ScoreModels =
    std::function<std::vector<ModelScore>(std::span<const std::size_t> indices, std::optional<double> bar)>;

/// Scores generations of models; remembers the scores of phenotypes and does not simulate them again.
class ModelEvaluator {
 public:
  ModelEvaluator(const ModelDefinition& definition, EvaluationOptions options);

  /// One score per model. A score above `bar` may be only a bound. `score` is called at most once, for those that must
  /// be simulated; all remembered scores must be for the same trials.
  std::vector<EvaluatedModel> evaluate(const std::vector<ModelProposal>& models, std::optional<double> bar,
                                       const ScoreModels& score);
  /// Remembers a score without an evaluation, for a run that is resumed.
  void remember(const ModelProposal& model, const ModelScore& score);

 private:
  const ModelScore* recall(const std::string& phenotype, std::optional<double> bar) const;

  EvaluationOptions options_;
  Phenotypes phenotypes_;
  std::unordered_map<std::string, ModelScore> memory_;
};

}  // namespace lacuna

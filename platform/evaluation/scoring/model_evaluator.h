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
  bool abandon = true;  ///< end an evaluation that cannot get under the bar
  bool reuse = true;    ///< simulate identical phenotypes once
};

struct EvaluatedModel {
  ModelScore score;
  bool reused = false;  ///< an identical model was scored before; its score counts
};

/// Scores the models with these indices, in their order.
using ScoreModels =
    std::function<std::vector<ModelScore>(std::span<const std::size_t> indices, std::optional<double> bar)>;

/// Scores generations of models, and remembers phenotypes, which are not simulated again.
class ModelEvaluator {
 public:
  ModelEvaluator(const ModelDefinition& definition, EvaluationOptions options);

  /// One score for each model. Nothing that is above `bar` is known but that. `score` is asked once at most, for those
  /// that are to be simulated; the trials behind it are the same for all that is remembered.
  std::vector<EvaluatedModel> evaluate(const std::vector<ModelProposal>& models, std::optional<double> bar,
                                       const ScoreModels& score);
  /// As if it had been evaluated, for a run that goes on.
  void remember(const ModelProposal& model, const ModelScore& score);

 private:
  const ModelScore* recall(const std::string& phenotype, std::optional<double> bar) const;

  EvaluationOptions options_;
  Phenotypes phenotypes_;
  std::unordered_map<std::string, ModelScore> memory_;
};

}  // namespace lacuna

#include "evaluation/scoring/model_evaluator.h"

#include <utility>

namespace lacuna {

ModelEvaluator::ModelEvaluator(const ModelDefinition& definition, EvaluationOptions options)
    : options_(options), phenotypes_(definition) {}

const ModelScore* ModelEvaluator::recall(const std::string& phenotype, std::optional<double> bar) const {
  const auto found = memory_.find(phenotype);
  if (found == memory_.end()) return nullptr;
  const bool too_little_known = found->second.kind == ScoreKind::abandoned && !(bar && found->second.total > *bar);
  return too_little_known ? nullptr : &found->second;
}

std::vector<EvaluatedModel> ModelEvaluator::evaluate(const std::vector<ModelProposal>& models,
                                                     std::optional<double> bar, const ScoreModels& score) {
  if (!options_.abandon) bar = std::nullopt;
  std::vector<EvaluatedModel> evaluated(models.size());
  std::vector<std::string> phenotypes;
  std::vector<std::size_t> fresh;                           // indices to simulate
  std::unordered_map<std::string, std::size_t> first_with;  // in this generation
  for (std::size_t i = 0; i < models.size(); ++i) {
    phenotypes.push_back(phenotypes_.of(models[i]));
    evaluated[i].reused =
        options_.reuse && (recall(phenotypes[i], bar) != nullptr || !first_with.emplace(phenotypes[i], i).second);
    if (!evaluated[i].reused) fresh.push_back(i);
  }
  if (!fresh.empty()) {
    std::vector<ModelScore> scores = score(fresh, bar);
    for (std::size_t task = 0; task < fresh.size(); ++task) evaluated[fresh[task]].score = std::move(scores[task]);
  }
  if (!options_.reuse) return evaluated;
  for (const std::size_t i : fresh) memory_.insert_or_assign(phenotypes[i], evaluated[i].score);
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!evaluated[i].reused) continue;
    evaluated[i].score = memory_.at(phenotypes[i]);
    evaluated[i].score.steps = 0;
  }
  return evaluated;
}

void ModelEvaluator::remember(const ModelProposal& model, const ModelScore& score) {
  if (options_.reuse) memory_.insert_or_assign(phenotypes_.of(model), score);
}

}  // namespace lacuna

#include "evaluation/model_evaluator.h"

#include "evaluation/proposed_model.h"
#include "evaluation/robot_key.h"
#include "foundation/address.h"
#include "foundation/parallel.h"

#include <cmath>

namespace lacuna {

ModelEvaluator::ModelEvaluator(const ModelScorer& scorer, const ModelDefinition& definition, EvaluationOptions options)
    : scorer_(scorer), options_(options), effects_(model_effects(definition)), step_(definition.engine.step) {
  const bool rounds = definition.engine.delay_rounding == DelayRounding::step;
  for (const FreeValue& value : definition.free)
    whole_steps_.push_back(rounds &&
                           (matches("sensor.*.delay", value.address) || matches("actuator.*.delay", value.address)));
}

ModelEvaluator::Phenotype ModelEvaluator::phenotype_of(const ModelProposal& model) const {
  std::vector<double> key;
  key.reserve(model.values.size() + 1 + model.without.size());
  key = model.values;
  for (std::size_t i = 0; i < key.size(); ++i)
    if (whole_steps_[i]) key[i] = std::round(key[i] / step_);
  key.push_back(static_cast<double>(model.without.size()));
  for (const std::size_t effect : model.without) {
    for (const std::size_t value : effects_[effect].values) key[value] = 0.0;
    key.push_back(static_cast<double>(effect));
  }
  Phenotype phenotype(reinterpret_cast<const char*>(key.data()), key.size() * sizeof(double));
  if (model.robot) append_key(*model.robot, phenotype);
  return phenotype;
}

const ModelScore* ModelEvaluator::recall(const Phenotype& phenotype, std::optional<double> bar) const {
  const auto found = memory_.find(phenotype);
  if (found == memory_.end()) return nullptr;
  const bool too_little_known = found->second.kind == ScoreKind::abandoned && !(bar && found->second.total > *bar);
  return too_little_known ? nullptr : &found->second;
}

std::vector<EvaluatedModel> ModelEvaluator::evaluate(const std::vector<ModelProposal>& models,
                                                     std::optional<double> bar) {
  if (!options_.abandon) bar = std::nullopt;
  std::vector<EvaluatedModel> evaluated(models.size());
  std::vector<Phenotype> phenotypes;
  std::vector<std::size_t> fresh;                         // indices to simulate
  std::unordered_map<Phenotype, std::size_t> first_with;  // in this generation
  for (std::size_t i = 0; i < models.size(); ++i) {
    phenotypes.push_back(phenotype_of(models[i]));
    evaluated[i].reused =
        options_.reuse && (recall(phenotypes[i], bar) != nullptr || !first_with.emplace(phenotypes[i], i).second);
    if (!evaluated[i].reused) fresh.push_back(i);
  }
  parallel_for(fresh.size(), scorer_.workers(), [&](std::size_t task, int worker) {
    scorer_.score(models[fresh[task]], bar, worker, evaluated[fresh[task]].score);
  });
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
  if (options_.reuse) memory_.insert_or_assign(phenotype_of(model), score);
}

}  // namespace lacuna

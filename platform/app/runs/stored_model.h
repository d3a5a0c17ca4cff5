#pragma once

#include "eea/definition/eea_definition.h"
#include "evaluation/scoring/model_scorer.h"
#include "storage/eea/eea_store.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// A model of a stored run and the trials that it was scored on: those of its pass and of the passes before.
struct StoredModel {
  const EeaDefinition& definition;
  std::uint64_t number;
  ModelRow row;
  ModelProposal model;
  std::vector<ScoredTrial> trials;
  std::vector<int> numbers;  ///< of the trials
  Stop stop = {};            ///< of the work that simulates it
};

/// Throws `BadInput` where the run has no such model. `definition` must live as long.
StoredModel stored_model(const EeaStore& store, const EeaDefinition& definition, std::uint64_t number,
                         const Stop& stop = {});

/// Simulates it on all its trials, to their ends.
ModelScore score_again(const StoredModel& model);

/// Whether the score is the stored one: the same bits, or, of a model that was abandoned, not below what was known.
bool agrees(const ModelRow& stored, const ModelScore& score);

}  // namespace lacuna

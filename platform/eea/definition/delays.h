#pragma once

#include "eea/definition/eea_definition.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// The delays of sensors that the experiment profiles, of a model whose genome does not say them: those with which it
/// comes nearest to all that the trials measured, from their start to their end. A search may score less than that.
class Delays {
 public:
  /// `trials`: `EeaDefinition::observed`. The definition must outlive it.
  Delays(const EeaDefinition& definition, std::vector<ScoredTrial> trials)
      : scorer_(*definition.compiled, std::move(trials), definition.metric, 1, &definition.model, definition.profiled) {
  }

  /// Writes them into the model's values and returns the steps that it took. A model that cannot be simulated stays as
  /// it is.
  std::uint64_t find(ModelProposal& model) const;

 private:
  ModelScorer scorer_;
};

}  // namespace lacuna

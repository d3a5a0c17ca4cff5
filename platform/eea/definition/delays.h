#pragma once

#include "eea/definition/eea_definition.h"

#include <cstdint>
#include <vector>

namespace lacuna {

/// Finds the delays of sensors that the experiment profiles, for a model whose genome does not contain them: those with
/// the smallest error on all readings of the trials, over their whole length. A search may score a part of that only.
class Delays {
 public:
  /// `trials`: `EeaDefinition::observed`. The definition must outlive it.
  Delays(const EeaDefinition& definition, std::vector<ScoredTrial> trials, const Stop& stop = {})
      : scorer_(*definition.compiled, std::move(trials), definition.metric, {1, stop}, &definition.model,
                definition.profiled) {}

  /// Writes the delays into the model's values and returns the number of steps. A model that cannot be simulated stays
  /// unchanged.
  std::uint64_t find(ModelProposal& model) const;

 private:
  ModelScorer scorer_;
};

}  // namespace lacuna

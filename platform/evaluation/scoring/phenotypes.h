#pragma once

#include "evaluation/model/model_definition.h"

#include <lacuna/model_encoding.h>

#include <string>
#include <vector>

namespace lacuna {

/// Whether only whole integration steps of a free value matter: a delay that the engine rounds.
bool counts_in_steps(const FreeValue& value, const EngineSettings& engine);

/// Identifies models that no simulation can distinguish: equal robots, effects and their values, after rounding where
/// delays are rounded to whole steps.
class Phenotypes {
 public:
  explicit Phenotypes(const ModelDefinition& definition);
  /// Bytes that are equal for two proposals if no simulation can distinguish them.
  std::string of(const ModelProposal& model) const;

 private:
  std::vector<ModelEffect> effects_;
  std::vector<bool> whole_steps_;  ///< per value
  double step_;                    ///< s
};

}  // namespace lacuna

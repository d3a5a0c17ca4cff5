#pragma once

#include "evaluation/model/model_definition.h"

#include <lacuna/model_encoding.h>

#include <string>
#include <vector>

namespace lacuna {

/// Whether only whole integration steps of a free value count: a delay that the engine rounds.
bool counts_in_steps(const FreeValue& value, const EngineSettings& engine);

/// Tells models apart by what a simulation can tell of them: their robots, their effects and the values of these, after
/// rounding where delays are rounded to whole steps.
class Phenotypes {
 public:
  explicit Phenotypes(const ModelDefinition& definition);
  /// Bytes that two proposals share if no simulation tells them apart.
  std::string of(const ModelProposal& model) const;

 private:
  std::vector<ModelEffect> effects_;
  std::vector<bool> whole_steps_;  ///< per value
  double step_;                    ///< s
};

}  // namespace lacuna

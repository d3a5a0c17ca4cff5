#include "eea/definition/delays.h"

#include <utility>

namespace lacuna {

std::uint64_t Delays::find(ModelProposal& model) const {
  ModelScore score;
  scorer_.score(model, std::nullopt, 0, score);
  if (!score.values.empty()) model.values = std::move(score.values);
  return score.steps;
}

}  // namespace lacuna

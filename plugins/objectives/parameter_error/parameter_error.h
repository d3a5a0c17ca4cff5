#pragma once

#include <lacuna/objective_metric.h>

namespace lacuna {

/// How far a model's free parameters are from the hidden ones: |value − truth| for each by its address, and the mean
/// for each group of at least two elements' parameters, by the address with `*` for the element. Where effects are
/// optional also `effects`, how many of these are on and not in the target, or off and in it.
class ParameterError : public ObjectiveMetric {
 public:
  std::string summary() const override;
  /// Parameters whose truth is NaN are left out, and so are those of effects that the model does without, groups whose
  /// members have different units, and in the count optional effects without a free parameter, of which the truth
  /// does not tell. Throws `Error` where model or truth do not fit the space.
  std::vector<ObjectiveScore> score(const ModelSpace& space, const ModelProposal& model, const HiddenTruth& truth,
                                    std::span<const double> parameters) const override;
};

}  // namespace lacuna

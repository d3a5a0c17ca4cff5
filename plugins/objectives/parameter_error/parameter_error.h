#pragma once

#include <lacuna/objective_metric.h>

namespace lacuna {

/// How far a model's free parameters are from the hidden ones: |value − truth| for each by its address, and the mean
/// for each group of at least two elements' parameters, by the address with `*` for the element.
class ParameterError : public ObjectiveMetric {
 public:
  std::string summary() const override;
  /// Parameters whose truth is NaN are left out, and so are groups whose members have different units. Throws `Error`
  /// where model or truth do not fit the space.
  std::vector<ObjectiveScore> score(const ModelSpace& space, const ModelProposal& model, const HiddenTruth& truth,
                                    std::span<const double> parameters) const override;
};

}  // namespace lacuna

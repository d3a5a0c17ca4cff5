#pragma once

#include <lacuna/objective_metric.h>

namespace lacuna {

/// How far the parts of a model lie from those of the target (the origins of their frames, which sensors of place
/// read), in the pose in which both start (Eq. 3 of the seed), and whether they hang together in the same way.
class PartDistance : public ObjectiveMetric {
 public:
  std::string summary() const override;
  /// `body.<name>.position` of each part, m; their mean `body.*.position`, which is e_o; `topology_wrong`, 0 or 1.
  /// Parts are matched by index. Throws `Error` where model and target have different numbers of parts.
  std::vector<ObjectiveScore> score(const ModelSpace& space, const ModelProposal& model, const HiddenTruth& truth,
                                    std::span<const double> parameters) const override;
};

}  // namespace lacuna

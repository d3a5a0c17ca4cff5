#pragma once

#include <lacuna/model_encoding.h>
#include <lacuna/parameter.h>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// One figure about how far a model is from the hidden truth.
struct ObjectiveScore {
  std::string name;  ///< "body.*.mass", or what the metric calls it
  std::string unit;  ///< SI
  double value = 0.0;
};

/// What a simulated target hides.
struct HiddenTruth {
  std::span<const double> values;  ///< for each of `ModelSpace::free`, NaN where the target has no such parameter
  const RobotSpec& robot;          ///< the target's, before any effect
};

/// Holds a model against the hidden truth (Eq. 3 of the seed). Nothing else ever sees the truth. Const and shared by
/// threads.
class ObjectiveMetric {
 public:
  virtual ~ObjectiveMetric() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` where model or truth do not fit the space, or where the metric has nothing to say about them.
  virtual std::vector<ObjectiveScore> score(const ModelSpace& space, const ModelProposal& model,
                                            const HiddenTruth& truth, std::span<const double> parameters) const = 0;
};

}  // namespace lacuna

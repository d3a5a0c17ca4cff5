#pragma once

#include <lacuna/model_encoding.h>
#include <lacuna/parameter.h>

#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// One number for the error of a model against the hidden truth.
struct ObjectiveScore {
  std::string name;  ///< "body.*.mass", or a name from the metric
  std::string unit;  ///< SI
  double value = 0.0;
};

/// The hidden values of a simulated target.
struct HiddenTruth {
  std::span<const double> values;  ///< for each of `ModelSpace::free`, NaN where the target has no such parameter
  const RobotSpec& robot;          ///< of the target, before any effect
};

/// Compares a model with the hidden truth (Eq. 3 of the seed). Only this metric ever gets the truth. Const and shared
/// by threads.
class ObjectiveMetric {
 public:
  virtual ~ObjectiveMetric() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  virtual ParameterDeclarations parameters() const { return {}; }
  /// Throws `Error` where model or truth do not match the space, or where the metric cannot compare them.
  virtual std::vector<ObjectiveScore> score(const ModelSpace& space, const ModelProposal& model,
                                            const HiddenTruth& truth, std::span<const double> parameters) const = 0;
};

}  // namespace lacuna

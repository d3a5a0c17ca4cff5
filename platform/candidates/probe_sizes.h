#pragma once

#include "candidates/hypothesis.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Values of an effect at which it would do about as much as a model leaves unexplained.
struct SizedProbe {
  std::vector<double> own;           ///< in the order of its declaration
  std::optional<std::size_t> sized;  ///< the one of them that was sized from its neutral value
  bool one_sided = false;            ///< a negative size has no meaning
};

/// Simulates a hypothesis with these values of its own: by segment, residuals over what the model leaves of their kind.
/// False where it cannot be simulated.
using OwnResiduals = std::function<bool(const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals)>;

/// What a size is looked for, as changes of the prediction over what the model leaves.
struct WantedChange {
  double enough;  ///< at the least
  double aimed_at;
  bool may_jump;  ///< where all sizes change too much, one of them is taken: a foot leaves the ground at the smallest
                  ///< tilt
};

/// Probes of a hypothesis; a parameter that changes nothing by itself (it shapes the effect) is tried at a few values
/// that `scales` suggest. Empty: nothing that the effect does here can be seen.
std::vector<SizedProbe> size_probes(const Hypothesis& hypothesis, const OwnResiduals& simulate,
                                    const WantedChange& wanted, const std::map<std::string, double>& scales);

}  // namespace lacuna

#pragma once

#include "candidates/hypothesis.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Values of an effect at which it changes the predictions by about as much as the residual.
struct SizedProbe {
  std::vector<double> own;           ///< in the order of its declaration
  std::optional<std::size_t> sized;  ///< the parameter that was sized, from its neutral value
  bool one_sided = false;            ///< a negative size has no meaning
};

/// Simulates a hypothesis with these values of its effect: by segment, change of the prediction over the residual of
/// its kind. False where it cannot be simulated.
using OwnResiduals = std::function<bool(const std::vector<double>& own, std::vector<Eigen::VectorXd>& residuals)>;

/// The change that a size should reach, as change of the prediction over the residual.
struct WantedChange {
  double enough;  ///< at the least
  double aimed_at;
  bool may_jump;  ///< where all sizes change too much, one is taken anyway: a foot leaves the ground at the smallest
                  ///< tilt
};

/// Probes of a hypothesis. A parameter that changes nothing by itself (it shapes the effect) is tried at a few values
/// that `scales` suggest. Empty: the effect changes no prediction here.
std::vector<SizedProbe> size_probes(const Hypothesis& hypothesis, const OwnResiduals& simulate,
                                    const WantedChange& wanted, const std::map<std::string, double>& scales);

}  // namespace lacuna

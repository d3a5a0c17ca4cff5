#pragma once

#include "diagnosis/candidates/hypothesis.h"
#include "diagnosis/noise/base_solution.h"

#include <map>
#include <string>
#include <vector>

namespace lacuna {

/// An effect at a finite size: many have no gradient at zero (backlash, stiction), so what it would do to the readings
/// is found by simulating it about as large as it must be to explain the residual.
struct Probe {
  std::vector<double> own;  ///< values of the hypothesis's own parameters
  bool one_sided = false;   ///< a negative size has no meaning
  /// By segment, bins × 1: what is added to the prediction, in multiples of the sensor noise.
  std::vector<Eigen::VectorXd> response;
};

/// Probes of a hypothesis around a base solution; a parameter that changes nothing by itself (it shapes the effect) is
/// tried at a few values that `scales` suggest. Empty: nothing that the effect does here can be seen; `failure` says
/// why the last simulation that failed did. Single-threaded.
std::vector<Probe> find_probes(const Hypothesis& hypothesis, const BaseSolution& base, const RowBins& bins,
                               const std::map<std::string, double>& scales, std::string& failure);

}  // namespace lacuna

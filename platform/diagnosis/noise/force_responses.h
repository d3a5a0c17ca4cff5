#pragma once

#include "diagnosis/noise/row_bins.h"
#include "evaluation/model_definition.h"

#include <string>
#include <vector>

namespace lacuna {

/// What a unit force on one joint, during one short interval of a segment, does to the segment's readings: the way of
/// an unmodelled force, random or not, into the residual. Found by simulating pulses.
struct ForceResponses {
  std::vector<std::string> joints;  ///< names of the hinges and sliders, in spec order
  std::vector<std::string> units;   ///< N*m or N
  double width = 0.0;               ///< of a pulse, s
  /// By segment, then joint: bins × pulses, change of the *prediction* in units of the problem's scales per N·m or N.
  std::vector<std::vector<Eigen::MatrixXd>> of;
  std::vector<Eigen::VectorXd> times;  ///< by segment: the middle of each pulse, s

  bool empty() const { return joints.empty(); }
};

/// Pulses around the base's solution `point`, each as large as changes the prediction by half of `residual` (RMS, in
/// units of the scales). Empty for robots that float or have more coordinates than `kMostDisturbed`, whose unmodelled
/// forces are not told apart from slow sensor noise.
ForceResponses force_responses(const ModelDefinition& definition, const ShootingProblem& problem, const RowBins& bins,
                               const FitPoint& point, const std::vector<double>& values, double residual, int threads);

inline constexpr std::size_t kMostDisturbed = 6;

}  // namespace lacuna

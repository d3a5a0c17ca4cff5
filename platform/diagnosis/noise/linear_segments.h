#pragma once

#include "diagnosis/noise/row_bins.h"

#include <vector>

namespace lacuna {

/// What a fitted model leaves in one segment and how that would change, to first order; bins × columns, in units of the
/// problem's scales. Residual = measured − predicted, hence the derivatives' sign.
struct LinearSegment {
  Eigen::VectorXd residual;
  Eigen::MatrixXd values;  ///< by the shared values' coordinates
  Eigen::MatrixXd state;   ///< by the start's unknowns, each in units of its prior deviation
};

/// The responses of a segment to its start, bins × unknowns, so that no direction reaches further than a hundred
/// thousand units: one of which that little is known beforehand is told by the measurements alone, and a covariance
/// with larger ones beside the noise's has no factor in double precision. Where a simulation jumps, differences are
/// larger.
Eigen::MatrixXd bounded_responses(const Eigen::MatrixXd& state);

/// Central differences at `point`, whose residuals are known.
std::vector<LinearSegment> linear_segments(ShootingProblem& problem, const RowBins& bins, const FitPoint& point,
                                           const std::vector<Eigen::VectorXd>& residuals);

/// RMS of all residuals.
double rms(const std::vector<LinearSegment>& segments);

}  // namespace lacuna

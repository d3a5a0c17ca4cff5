#pragma once

#include "diagnosis/row_bins.h"

#include <vector>

namespace lacuna {

/// What a fitted model leaves in one segment and how that would change, to first order; bins × columns, in units of the
/// problem's scales. Residual = measured − predicted, hence the derivatives' sign.
struct LinearSegment {
  Eigen::VectorXd residual;
  Eigen::MatrixXd values;  ///< by the shared values' coordinates
  Eigen::MatrixXd state;   ///< by the start's unknowns, each in units of its prior deviation
};

/// Central differences at `point`, whose residuals are known.
std::vector<LinearSegment> linear_segments(ShootingProblem& problem, const RowBins& bins, const FitPoint& point,
                                           const std::vector<Eigen::VectorXd>& residuals);

/// RMS of all residuals.
double rms(const std::vector<LinearSegment>& segments);

}  // namespace lacuna

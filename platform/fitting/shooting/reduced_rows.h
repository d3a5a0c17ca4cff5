#pragma once

#include "fitting/shooting/shooting_problem.h"

#include <vector>

namespace lacuna {

/// One segment's rows at the end of a fit, after projecting off the part that the initial state explains.
struct ReducedRows {
  Eigen::MatrixXd sensitivity;  ///< rows × values
  Eigen::VectorXd curvature;    ///< half the loss's second derivative, per row
  Eigen::VectorXd score;        ///< weight × residual
};

/// A segment each; rows in the order of the residuals, priors last.
std::vector<ReducedRows> reduce(const SegmentedProblem& problem, const std::vector<Eigen::VectorXd>& residuals,
                                const std::vector<SegmentJacobian>& jacobians, const RobustLoss& loss);

/// Σ sensitivityᵀ · curvature · sensitivity.
Eigen::MatrixXd information(const std::vector<ReducedRows>& rows);

}  // namespace lacuna

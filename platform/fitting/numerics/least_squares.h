#pragma once

#include "fitting/numerics/robust_loss.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace lacuna {

/// A point of a fit: values shared by all segments and the unknown initial state of each.
struct FitPoint {
  Eigen::VectorXd values;
  std::vector<Eigen::VectorXd> states;
};

/// Derivatives of one segment's residuals.
struct SegmentJacobian {
  Eigen::MatrixXd values;  ///< rows × shared values
  Eigen::MatrixXd state;   ///< rows × this segment's own unknowns
};

/// A least-squares problem whose unknowns are a few shared values and, for each segment, an initial state on which no
/// other segment depends. Residuals are whitened: standard deviation 1 for a right model.
class SegmentedProblem {
 public:
  virtual ~SegmentedProblem() = default;

  virtual const Eigen::VectorXd& lower() const = 0;  ///< bounds of the shared values
  virtual const Eigen::VectorXd& upper() const = 0;
  /// Rows of segment `k` that the robust loss applies to; the rows after them (priors) count squared.
  virtual Eigen::Index robust_rows(std::size_t k) const = 0;
  /// Fills one vector per segment. False if the point cannot be evaluated.
  virtual bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) = 0;
  /// Fills the derivatives at a point with known residuals.
  virtual void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                         std::vector<SegmentJacobian>& jacobians) = 0;
};

struct LeastSquaresOptions {
  RobustLoss loss;
  int max_iterations = 50;                      ///< linearisations
  double tolerance = 1e-7;                      ///< relative decrease of the cost that ends the search
  std::function<void(int iteration)> progress;  ///< called before each iteration; may throw
  bool secants = false;                         ///< derivatives are updated by the steps between two linearisations
  std::function<void(const FitPoint& point)> reached = {};  ///< called with each better point
};

struct LeastSquaresResult {
  FitPoint point;
  std::vector<Eigen::VectorXd> residuals;
  std::vector<SegmentJacobian> jacobians;  ///< at `point`, or less than the tolerance before it; else empty
  double cost = 0.0;                       ///< Σ loss
  int iterations = 0;
  bool valid = false;  ///< the starting point could be evaluated
  bool converged = false;
};

/// Σ loss over all rows.
double total_cost(const SegmentedProblem& problem, const std::vector<Eigen::VectorXd>& residuals,
                  const RobustLoss& loss);

/// Levenberg–Marquardt with Marquardt's scaling; segment states are eliminated by the Schur complement, bounds are kept
/// by an active set and projection, points that cannot be evaluated count as steps too long. With secants, derivatives
/// are updated after each step and computed anew only where a step disappoints or no gain is left: fewer evaluations
/// where derivatives are expensive. Serial and in a fixed order: the same digits whatever the problem does inside its
/// calls.
///
/// Literature: K. Madsen, H. B. Nielsen and O. Tingleff, "Methods for non-linear least squares problems", 2004
/// (damping, secant version); C. G. Broyden, "A class of methods for solving nonlinear simultaneous equations", 1965.
LeastSquaresResult minimize(SegmentedProblem& problem, const FitPoint& start, const LeastSquaresOptions& options);

}  // namespace lacuna

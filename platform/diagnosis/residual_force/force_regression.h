#pragma once

#include "diagnosis/refit/folds.h"
#include "diagnosis/refit/refit.h"

#include <cstddef>
#include <vector>

namespace lacuna {

/// Forces beside the values of a refitted model, to first order in both, fitted under the loss of the refit and judged
/// on left-out folds as a refit is: without any force, `held_out` is the refit's own.
class ForceRegression {
 public:
  using Columns = std::vector<Eigen::Index>;

  /// `factors`: of the noise, by segment; `columns`: by segment, bins × forces, change of the prediction by each force
  /// at size 1. `base` and `folds` must outlive the regression.
  ForceRegression(const Refit& base, const std::vector<Eigen::MatrixXd>& factors,
                  const std::vector<Eigen::MatrixXd>& columns, const Folds& folds);

  Eigen::Index count() const { return count_; }

  /// Takes the weights of the rows from the fit of these forces; before, they are those of the refit. Returns whether
  /// any has changed. `ridge` is put on the forces' information.
  bool settle(const Columns& forces, double ridge = 0.0);

  /// All under the weights at hand. Deviance by block, predicted from the other folds.
  Eigen::VectorXd held_out(const Columns& forces, double ridge = 0.0) const;
  Eigen::VectorXd sizes(const Columns& forces, double ridge = 0.0) const;
  Eigen::MatrixXd covariance(const Columns& forces, double ridge = 0.0) const;

  /// Share of a force's power, but for what the starts take up, that the values cannot take up.
  double seen(Eigen::Index force) const { return seen_(force); }
  /// Share of that which `forces` do not span.
  double share_beside(Eigen::Index force, const Columns& forces) const;

 private:
  void build();
  void leave_to_values();
  /// Columns of the values and of these forces.
  Columns with_values(const Columns& forces) const;
  Eigen::MatrixXd information(const Eigen::MatrixXd& gram, const Columns& all, double ridge) const;
  Eigen::VectorXd solution(const NormalEquations& normal, const Columns& all, double ridge) const;
  Eigen::VectorXd residual(std::size_t k, const Columns& all, const Eigen::VectorXd& sizes) const;
  double power_beside(Eigen::Index column, const Columns& others) const;

  const Folds* folds_;
  std::vector<RobustSegment> segments_;  ///< values: those inside their bounds, then forces
  Eigen::Index values_ = 0, count_ = 0;
  std::vector<Eigen::VectorXd> weights_;
  Normals normals_;
  Eigen::VectorXd seen_;
};

}  // namespace lacuna

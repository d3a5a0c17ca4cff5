#include "fitting/shooting/held_values.h"

namespace lacuna {
namespace {

/// A problem of which only some values are left.
class HeldProblem : public SegmentedProblem {
 public:
  HeldProblem(ShootingProblem& problem, const Eigen::VectorXd& values, const std::vector<Eigen::Index>& free)
      : problem_(problem), values_(values), free_(free), lower_(problem.lower()(free)), upper_(problem.upper()(free)) {}

  const Eigen::VectorXd& lower() const override { return lower_; }
  const Eigen::VectorXd& upper() const override { return upper_; }
  Eigen::Index robust_rows(std::size_t k) const override { return problem_.robust_rows(k); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override {
    return problem_.residuals(whole(point), residuals);
  }
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override {
    problem_.linearize(whole(point), residuals, jacobians);
    for (SegmentJacobian& jacobian : jacobians) jacobian.values = jacobian.values(Eigen::all, free_).eval();
  }

  FitPoint whole(const FitPoint& point) const {
    FitPoint all{values_, point.states};
    all.values(free_) = point.values;
    return all;
  }

 private:
  ShootingProblem& problem_;
  const Eigen::VectorXd& values_;
  const std::vector<Eigen::Index>& free_;
  const Eigen::VectorXd lower_, upper_;
};

}  // namespace

Eigen::VectorXd fit_beside_held(ShootingProblem& problem, const Eigen::VectorXd& values,
                                const std::vector<Eigen::Index>& free, const LeastSquaresOptions& options) {
  HeldProblem held(problem, values, free);
  const LeastSquaresResult found = minimize(held, {values(free), problem.start(values).states}, options);
  return found.valid ? held.whole(found.point).values : values;
}

}  // namespace lacuna

#pragma once

#include "fitting/shooting/shooting_problem.h"

namespace lacuna {

/// A problem with held values: only the initial states are unknown. `problem` must outlive it.
class StatesProblem : public SegmentedProblem {
 public:
  StatesProblem(ShootingProblem& problem, Eigen::VectorXd values) : problem_(problem), values_(std::move(values)) {}

  const Eigen::VectorXd& lower() const override { return none_; }
  const Eigen::VectorXd& upper() const override { return none_; }
  Eigen::Index robust_rows(std::size_t k) const override { return problem_.robust_rows(k); }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override {
    return problem_.residuals({values_, point.states}, residuals);
  }
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override {
    problem_.linearize_states({values_, point.states}, residuals, jacobians);
  }

 private:
  ShootingProblem& problem_;
  const Eigen::VectorXd values_, none_;
};

}  // namespace lacuna

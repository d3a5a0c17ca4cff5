#include "fitting/numerics/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

/// One segment, residuals and derivatives as formulas.
class Formulas : public SegmentedProblem {
 public:
  using Function = std::function<bool(const Eigen::VectorXd&, Eigen::VectorXd&)>;
  Formulas(Function function, Eigen::VectorXd lower, Eigen::VectorXd upper)
      : function_(std::move(function)), lower_(std::move(lower)), upper_(std::move(upper)) {}

  const Eigen::VectorXd& lower() const override { return lower_; }
  const Eigen::VectorXd& upper() const override { return upper_; }
  Eigen::Index robust_rows(std::size_t) const override { return rows_; }
  bool residuals(const FitPoint& point, std::vector<Eigen::VectorXd>& residuals) override {
    residuals.resize(1);
    const bool valid = function_(point.values, residuals[0]);
    rows_ = residuals[0].size();
    return valid;
  }
  void linearize(const FitPoint& point, const std::vector<Eigen::VectorXd>& residuals,
                 std::vector<SegmentJacobian>& jacobians) override {
    ++linearisations;
    jacobians.resize(1);
    jacobians[0].state.resize(residuals[0].size(), 0);
    jacobians[0].values.resize(residuals[0].size(), point.values.size());
    for (Eigen::Index j = 0; j < point.values.size(); ++j) {
      Eigen::VectorXd ahead = point.values, behind = point.values, r_ahead, r_behind;
      ahead(j) += 1e-6;
      behind(j) -= 1e-6;
      function_(ahead, r_ahead);
      function_(behind, r_behind);
      jacobians[0].values.col(j) = (r_ahead - r_behind) / 2e-6;
    }
  }
  int linearisations = 0;

 private:
  Function function_;
  Eigen::VectorXd lower_, upper_;
  Eigen::Index rows_ = 0;
};

const Eigen::VectorXd kFar = Eigen::VectorXd::Constant(2, 1e3);

bool rosenbrock(const Eigen::VectorXd& x, Eigen::VectorXd& r) {
  r = Eigen::Vector2d(1.0 - x(0), 10.0 * (x(1) - x(0) * x(0)));
  return true;
}

LeastSquaresResult search(SegmentedProblem& problem, const Eigen::VectorXd& start,
                          const LeastSquaresOptions& options = {}) {
  return minimize(problem, {start, {Eigen::VectorXd()}}, options);
}

TEST(Minimize, FindsRosenbrocksMinimum) {
  Formulas problem(rosenbrock, -kFar, kFar);
  LeastSquaresOptions options;
  options.max_iterations = 200;
  const LeastSquaresResult result = search(problem, Eigen::Vector2d(-1.2, 1.0), options);
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(result.point.values(0), 1.0, 1e-6);
  EXPECT_NEAR(result.point.values(1), 1.0, 1e-6);
}

/// A decay to 40 readings, from far off.
bool decay(const Eigen::VectorXd& x, Eigen::VectorXd& r) {
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(40, 0.0, 4.0);
  r = (2.0 * (-0.7 * t).exp() + 0.01 * (5.0 * t).sin() - x(0) * (-x(1) * t).exp()).matrix();
  return true;
}

TEST(Minimize, BySecantsComesToTheSameMinimumWithFewerDerivatives) {
  Formulas exactly(decay, -kFar, kFar), by_secants(decay, -kFar, kFar);
  LeastSquaresOptions options;
  options.tolerance = 1e-10;
  const LeastSquaresResult one = search(exactly, Eigen::Vector2d(1.0, 3.0), options);
  options.secants = true;
  const LeastSquaresResult other = search(by_secants, Eigen::Vector2d(1.0, 3.0), options);
  EXPECT_TRUE(other.converged);
  EXPECT_TRUE(other.point.values.isApprox(one.point.values, 1e-5));
  EXPECT_LT(by_secants.linearisations, exactly.linearisations);
}

TEST(Minimize, HandsOutTheDerivativesWhereItEnds) {
  for (const bool secants : {false, true}) {
    Formulas problem(decay, -kFar, kFar);
    const LeastSquaresResult result = search(problem, Eigen::Vector2d(1.0, 3.0), {{}, 50, 1e-10, {}, secants});
    std::vector<SegmentJacobian> there;
    problem.linearize(result.point, result.residuals, there);
    ASSERT_EQ(result.jacobians.size(), 1u);
    EXPECT_TRUE(result.jacobians[0].values.isApprox(there[0].values, 1e-4));
  }
}

TEST(Minimize, StopsAtABoundAtTheConstrainedMinimum) {
  // With x ≤ 0.5 the best is x = 0.5, y = x².
  Formulas problem(rosenbrock, -kFar, Eigen::Vector2d(0.5, 1e3));
  const LeastSquaresResult result = search(problem, Eigen::Vector2d(-1.2, 1.0), {{}, 200, 1e-9, {}});
  EXPECT_EQ(result.point.values(0), 0.5);
  EXPECT_NEAR(result.point.values(1), 0.25, 1e-5);
}

TEST(Minimize, AtABoundGoesOnWithWhatIsTiedToTheBoundValue) {
  // A straight valley y = x, whose end x = 10 lies beyond x ≤ 1; a long step cut at the bound alone leads up its wall.
  Formulas problem(
      [](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
        r = Eigen::Vector2d(x(0) - 10.0, 100.0 * (x(1) - x(0)));
        return true;
      },
      -kFar, Eigen::Vector2d(1.0, 1e3));
  const LeastSquaresResult result = search(problem, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(result.point.values(0), 1.0);
  EXPECT_NEAR(result.point.values(1), 1.0, 1e-6);
  EXPECT_TRUE(result.converged);
}

TEST(Minimize, LeavesABoundThatPullsInwards) {
  Formulas problem(rosenbrock, Eigen::Vector2d(0.0, 0.0), kFar);
  const LeastSquaresResult result = search(problem, Eigen::Vector2d(0.0, 0.0), {{}, 200, 1e-9, {}});
  EXPECT_NEAR(result.point.values(0), 1.0, 1e-6);
}

TEST(Minimize, TakesPointsThatCannotBeEvaluatedForStepsTooLong) {
  // √x has no value below zero; the first full step from 9 towards √x = 0.1 leads there.
  Formulas problem(
      [](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
        r = Eigen::VectorXd::Constant(1, std::sqrt(x(0)) - 0.1);
        return x(0) >= 0.0;
      },
      Eigen::VectorXd::Constant(1, -1e3), Eigen::VectorXd::Constant(1, 1e3));
  const LeastSquaresResult result = search(problem, Eigen::VectorXd::Constant(1, 9.0));
  EXPECT_NEAR(result.point.values(0), 0.01, 1e-6);
}

TEST(Minimize, SaysWhenTheStartCannotBeEvaluated) {
  Formulas problem([](const Eigen::VectorXd&, Eigen::VectorXd&) { return false; }, -kFar, kFar);
  EXPECT_FALSE(search(problem, Eigen::Vector2d(0.0, 0.0)).valid);
}

TEST(Minimize, WithHubersLossALocationIsPulledByAnOutlierByAtMostItsThreshold) {
  // Eleven readings, one off by 1000: Σ of the ten (x − 0) equals the threshold 3 of the outlier.
  Formulas problem(
      [](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
        r = Eigen::VectorXd::Constant(11, x(0));
        r(10) -= 1000.0;
        return true;
      },
      Eigen::VectorXd::Constant(1, -1e4), Eigen::VectorXd::Constant(1, 1e4));
  const LeastSquaresResult result = search(problem, Eigen::VectorXd::Constant(1, 50.0), {{3.0}, 100, 1e-12, {}});
  EXPECT_NEAR(result.point.values(0), 0.3, 1e-4);
}

TEST(Minimize, AValueThatNothingDependsOnStaysWhereItIs) {
  Formulas problem(
      [](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
        r = Eigen::VectorXd::Constant(3, x(0) - 2.0);
        return true;
      },
      -kFar, kFar);
  const LeastSquaresResult result = search(problem, Eigen::Vector2d(0.0, 7.0));
  EXPECT_NEAR(result.point.values(0), 2.0, 1e-8);
  EXPECT_EQ(result.point.values(1), 7.0);
}

}  // namespace
}  // namespace lacuna

#include "fitting/shooting/states_problem.h"

#include "fitting/made_problem.h"

#include <gtest/gtest.h>

namespace lacuna::states_problem_test {
namespace {

using namespace lacuna::analytic;

/// Each second of a spring whose damping is held at twice its size.
class StatesProblemTest : public testing::Test {
 protected:
  MadeProblem made_ = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  const Eigen::VectorXd held_ = made_.at({1.0});
  StatesProblem states_{made_.problem, held_};
  const FitPoint start_ = {Eigen::VectorXd(), made_.problem.start(held_).states};
};

TEST_F(StatesProblemTest, HasTheResidualsAndStateDerivativesOfTheHeldValues) {
  std::vector<Eigen::VectorXd> residuals;
  ASSERT_TRUE(states_.residuals(start_, residuals));
  EXPECT_EQ(residuals, made_.residuals_at({1.0}));
  EXPECT_EQ(states_.robust_rows(3), made_.problem.robust_rows(3));
  std::vector<SegmentJacobian> jacobians;
  states_.linearize(start_, residuals, jacobians);
  EXPECT_EQ(jacobians[3].values.cols(), 0);
  EXPECT_EQ(jacobians[3].state.cols(), 2);
}

TEST_F(StatesProblemTest, HasNoValueToMove) {
  EXPECT_EQ(states_.lower().size(), 0);
  EXPECT_EQ(states_.upper().size(), 0);
  LeastSquaresOptions options;
  std::vector<Eigen::VectorXd> before;
  states_.residuals(start_, before);
  const LeastSquaresResult found = minimize(states_, start_, options);
  ASSERT_TRUE(found.valid);
  EXPECT_EQ(found.point.values.size(), 0);
  EXPECT_LT(found.cost, 0.5 * total_cost(states_, before, options.loss)) << "the states take what they can";
}

}  // namespace
}  // namespace lacuna::states_problem_test

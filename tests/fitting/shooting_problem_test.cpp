#include "fitting/shooting/shooting_problem.h"

#include "fitting/made_problem.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna::shooting_problem_test {
namespace {

using namespace lacuna::analytic;

constexpr double kSigma = 0.02;     // of a reading
constexpr double kRounding = 1e-9;  // relative
constexpr double kLinear = 1e-5;    // relative error of a difference of a linear formula

double line(std::span<const double> p, double t) { return p[0] + p[1] * t; }
double decay(std::span<const double> p, double t) { return p[0] > 5.0 ? std::nan("") : std::exp(-p[0] * t); }

std::vector<FreeValue> line_values() { return {free_value("a", 1.0, -10.0, 10.0), free_value("b", 1.0, -10.0, 10.0)}; }
MadeProblem line_problem(int workers = 1) {
  return formula_problem(line, line_values(), {formula_trial(line, {1.0, 2.0}, 5.0, 20.0, kSigma, 1)}, 1.0, workers);
}
MadeProblem decay_problem() {
  return formula_problem(decay, {free_value("rate", 0.5, 0.0, 10.0)},
                         {formula_trial(decay, {0.5}, 5.0, 20.0, kSigma, 1)});
}

TEST(ShootingProblem, HasMeasuredMinusPredictedOverTheScaleThenThePriors) {
  MadeProblem made = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  const std::vector<Eigen::VectorXd> residuals = made.residuals_at({0.3});
  ASSERT_EQ(residuals.size(), 5U);
  const Segment& segment = made.problem.segments()[2];
  Prediction prediction;
  made.predictor.predict(segment.stretch, std::vector{0.3}, segment.start, 0, prediction);
  ASSERT_EQ(residuals[2].size(), made.problem.robust_rows(2) + 2) << "position and velocity of its start";
  for (Eigen::Index i = 0; i < made.problem.robust_rows(2); ++i) {
    const Eigen::Index row = segment.rows[static_cast<std::size_t>(i)];
    const double measured = made.predictor.trials()[0].measured.samples(segment.stretch.first + row, 0);
    EXPECT_NEAR(residuals[2](i), (measured - prediction.samples(row, 0)) / kNoise, kRounding) << i;
  }
  EXPECT_EQ(residuals[2].tail(2), Eigen::Vector2d(0.0, 0.0)) << "at the guess";
}

TEST(ShootingProblem, HoldsAStateToItsPriorDeviation) {
  MadeProblem made = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  FitPoint point = made.problem.start(made.at({0.5}));
  point.states[1] += made.problem.segments()[1].deviation;
  std::vector<Eigen::VectorXd> residuals;
  ASSERT_TRUE(made.problem.residuals(point, residuals));
  EXPECT_LT((residuals[1].tail(2) - Eigen::Vector2d(1.0, 1.0)).norm(), kRounding);
}

TEST(ShootingProblem, ScalesReadingsButNotPriors) {
  MadeProblem made = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  FitPoint point = made.problem.start(made.at({0.3}));
  point.states[1] += made.problem.segments()[1].deviation;
  std::vector<Eigen::VectorXd> fine, coarse;
  made.problem.residuals(point, fine);
  made.problem.set_scales({4.0 * kNoise});
  made.problem.residuals(point, coarse);
  const Eigen::Index rows = made.problem.robust_rows(1);
  EXPECT_LT((4.0 * coarse[1].head(rows) - fine[1].head(rows)).norm(), kRounding * fine[1].norm());
  EXPECT_EQ(coarse[1].tail(2), fine[1].tail(2));
}

TEST(ShootingProblem, KnowsTheTrialTheTimeAndTheChannelOfARow) {
  const MadeProblem made = line_problem();
  EXPECT_EQ(made.problem.samples(), 101U);
  const ResidualPlace place = made.problem.place(2, 5);
  EXPECT_EQ(place.trial, 0U);
  EXPECT_NEAR(place.time, 2.25, kRounding);
  EXPECT_EQ(place.channel, 0U);
}

TEST(ShootingProblem, DifferentiatesALineExactly) {
  MadeProblem made = line_problem();
  const std::vector<Eigen::VectorXd> residuals = made.residuals_at({0.0, 0.0});
  std::vector<SegmentJacobian> jacobians;
  made.problem.linearize(made.problem.start(made.at({0.0, 0.0})), residuals, jacobians);
  for (std::size_t k = 0; k < jacobians.size(); ++k)
    for (Eigen::Index row = 0; row < jacobians[k].values.rows(); ++row) {
      EXPECT_NEAR(jacobians[k].values(row, 0), -1.0 / kSigma, kLinear / kSigma);
      EXPECT_NEAR(jacobians[k].values(row, 1), -made.problem.place(k, row).time / kSigma, 5.0 * kLinear / kSigma);
    }
}

/// Central differences leave the third derivative, others the second.
TEST(ShootingProblem, DifferentiatesMoreFinelyWithTwiceTheSimulations) {
  MadeProblem made = decay_problem();
  const double rate = 0.5;
  const std::vector<Eigen::VectorXd> residuals = made.residuals_at({rate});
  const Eigen::ArrayXd t = regular_times(101, 20.0).array();
  const Eigen::VectorXd exact = (t * (-rate * t).exp() / kSigma).matrix();
  std::vector<SegmentJacobian> once, finely;
  made.problem.linearize(made.problem.start(made.at({rate})), residuals, once);
  made.problem.linearize_finely(made.problem.start(made.at({rate})), residuals, finely);
  const double coarse = (once[0].values.col(0) - exact).norm(), fine = (finely[0].values.col(0) - exact).norm();
  EXPECT_LT(coarse, 0.1 * exact.norm());
  EXPECT_LT(fine, 0.1 * coarse);
}

TEST(ShootingProblem, DifferentiatesByStatesAlone) {
  MadeProblem made = spring_problem({spring_trial(kNoise, 1)}, 1.0);
  const std::vector<Eigen::VectorXd> residuals = made.residuals_at({0.5});
  const FitPoint point = made.problem.start(made.at({0.5}));
  std::vector<SegmentJacobian> all, states;
  made.problem.linearize(point, residuals, all);
  made.problem.linearize_states(point, residuals, states);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].values.cols(), 1);
    EXPECT_EQ(states[k].values.cols(), 0);
    EXPECT_TRUE(states[k].state.isApprox(all[k].state, 1e-6)) << k;
  }
}

TEST(ShootingProblem, GivesTheSameDigitsWithAnyNumberOfThreads) {
  MadeProblem one = line_problem(1), many = line_problem(3);
  const std::vector<Eigen::VectorXd> residuals = one.residuals_at({0.3, 0.7});
  EXPECT_EQ(residuals, many.residuals_at({0.3, 0.7}));
  std::vector<SegmentJacobian> by_one, by_many;
  one.problem.linearize(one.problem.start(one.at({0.3, 0.7})), residuals, by_one);
  many.problem.linearize(many.problem.start(many.at({0.3, 0.7})), residuals, by_many);
  for (std::size_t k = 0; k < by_one.size(); ++k) EXPECT_EQ(by_one[k].values, by_many[k].values);
}

TEST(ShootingProblem, CountsItsSimulationsAndSaysWhyOneFailed) {
  MadeProblem made = decay_problem();
  std::vector<Eigen::VectorXd> residuals;
  EXPECT_TRUE(made.problem.residuals(made.problem.start(made.at({1.0})), residuals));
  EXPECT_FALSE(made.problem.residuals(made.problem.start(made.at({6.0})), residuals));
  EXPECT_EQ(made.problem.simulations(), 2U);
  EXPECT_EQ(made.problem.invalid_simulations(), 1U);
  EXPECT_THAT(made.problem.last_reason(), testing::HasSubstr("the formula has no value here"));
  ShootingProblem copy(made.problem, made.predictor);
  EXPECT_EQ(copy.simulations(), 0U);
  copy.count_in(made.problem);
  copy.count_in(made.problem);
  EXPECT_EQ(copy.simulations(), 4U);
  EXPECT_EQ(copy.invalid_simulations(), 2U);
}

TEST(ResidualScales, AreRobustWhereTheLossIs) {
  MadeProblem made = line_problem();
  std::vector<Eigen::VectorXd> residuals;
  for (const Segment& segment : made.problem.segments())
    residuals.emplace_back(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(segment.rows.size()), -2.0));
  residuals[0].head(5).setConstant(100.0);
  EXPECT_DOUBLE_EQ(residual_scales(made.problem, residuals, RobustLoss{3.0})[0], 1.4826 * 2.0 * kSigma);
  EXPECT_NEAR(residual_scales(made.problem, residuals, {})[0], kSigma * std::sqrt((5 * 1e4 + 96 * 4.0) / 101.0), 1e-9);
}

TEST(ResidualScales, AreNeverBelowTheNoise) {
  MadeProblem made = line_problem();
  std::vector<Eigen::VectorXd> residuals;
  for (const Segment& segment : made.problem.segments())
    residuals.emplace_back(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(segment.rows.size()), 0.01));
  EXPECT_EQ(residual_scales(made.problem, residuals, RobustLoss{3.0})[0], kSigma);
  EXPECT_EQ(residual_scales(made.problem, {}, RobustLoss{3.0})[0], kSigma) << "without readings";
}

}  // namespace
}  // namespace lacuna::shooting_problem_test

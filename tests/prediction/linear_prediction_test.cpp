#include "prediction/linear_prediction.h"

#include "prediction/one_joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kPull = 0.8;  // rad/s²

FreeValue pull(Scale scale = Scale::linear) { return analytic::free_value("a", 0.5, 0.1, 5.0, scale); }

/// Predictions of a parabola, whose derivatives are known: ½ t² by the acceleration, 1 and t by the start.
class LinearPredictionTest : public testing::Test {
 protected:
  explicit LinearPredictionTest(const FreeValue& value = pull(), int threads = 1)
      : rig_(constant_acceleration, {value}, {kPull}, {4.0}, threads),
        ladder_(rig_.ladder({0.5, 1.0})),
        predictions_(rig_.predictions(ladder_)) {}

  PredictionPoint smoothed(double a) const { return predictions_.at_smoothed_starts(rig_.at({a})); }
  PredictionPoint at_truth() const {
    PredictionPoint point = smoothed(kPull);
    for (std::size_t k = 0; k < ladder_.stretches.size(); ++k) {
      const StartState start = parabola_at(kPull, 0.01 * static_cast<double>(ladder_.stretches[k].stretch.first));
      point.starts[k] = Eigen::Vector2d(start.positions[0], start.velocities[0]);
    }
    return point;
  }
  /// s since the start of the stretch.
  Eigen::VectorXd times(std::size_t k) const {
    const std::vector<Eigen::Index>& rows = ladder_.stretches[k].rows;
    Eigen::VectorXd times(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
      times(static_cast<Eigen::Index>(i)) = 0.01 * static_cast<double>(rows[i]);
    return times;
  }
  double noise() const { return ladder_.noise[0].deviation; }

  OneJointRig rig_;
  PredictionLadder ladder_;
  LadderPredictions predictions_;
};

TEST_F(LinearPredictionTest, ResidualsAtTheTruthAreTheNoiseOfTheReadings) {
  std::vector<Eigen::VectorXd> residuals;
  ASSERT_TRUE(predictions_.residuals(at_truth(), residuals));
  double squares = 0.0, count = 0.0;
  for (const Eigen::VectorXd& one : residuals) squares += one.squaredNorm(), count += static_cast<double>(one.size());
  EXPECT_NEAR(std::sqrt(squares / count), kRigNoise / noise(), 0.1);
}

TEST_F(LinearPredictionTest, HasTheDerivativesOfAParabola) {
  const std::optional<LinearPrediction> linear = predictions_.linearise(smoothed(kPull));
  ASSERT_TRUE(linear);
  for (std::size_t k = 0; k < ladder_.stretches.size(); ++k) {
    const Eigen::VectorXd t = times(k);
    EXPECT_TRUE(linear->stretches[k].values.col(0).isApprox(0.5 * t.cwiseAbs2() / noise(), 1e-4)) << k;
    ASSERT_EQ(linear->stretches[k].start.cols(), 2);
    EXPECT_TRUE(linear->stretches[k].start.col(0).isApproxToConstant(1.0 / noise(), 1e-6)) << k;
    EXPECT_TRUE(linear->stretches[k].start.col(1).isApprox(t / noise(), 1e-6)) << k;
  }
}

class LogarithmicValue : public LinearPredictionTest {
 protected:
  LogarithmicValue() : LinearPredictionTest(pull(Scale::logarithmic)) {}
};

/// dq/d ln a = a · ½ t², by steps of up to a tenth of the logarithm.
TEST_F(LogarithmicValue, IsDifferentiatedByItsCoordinate) {
  const std::optional<LinearPrediction> linear = predictions_.linearise(smoothed(2.0));
  ASSERT_TRUE(linear);
  EXPECT_TRUE(linear->stretches[0].values.col(0).isApprox(2.0 * 0.5 * times(0).cwiseAbs2() / noise(), 0.06));
}

class FixedValue : public LinearPredictionTest {
 protected:
  FixedValue() : LinearPredictionTest(analytic::free_value("a", kPull, kPull, kPull)) {}
};

TEST_F(FixedValue, HasNoDerivative) {
  const std::optional<LinearPrediction> linear = predictions_.linearise(smoothed(kPull));
  ASSERT_TRUE(linear);
  EXPECT_TRUE(linear->stretches[0].values.isZero());
}

/// Of a linear model the residual at the smoothed start does not depend on where it was linearised.
TEST_F(LinearPredictionTest, ExtrapolatesResidualsToTheSmoothedStart) {
  PredictionPoint moved = smoothed(kPull);
  for (Eigen::VectorXd& start : moved.starts) start += Eigen::Vector2d(0.01, -0.03);
  const auto here = predictions_.linearise(smoothed(kPull)), there = predictions_.linearise(moved);
  for (std::size_t k = 0; k < ladder_.stretches.size(); ++k)
    EXPECT_LT((here->stretches[k].residual - there->stretches[k].residual).cwiseAbs().maxCoeff(), 1e-5) << k;
}

TEST_F(LinearPredictionTest, KeepsTheDerivativesThatStay) {
  std::vector<Eigen::VectorXd> residuals;
  const PredictionPoint point = smoothed(kPull);
  ASSERT_TRUE(predictions_.residuals(point, residuals));
  LinearPrediction linear = *predictions_.linearise(point);
  for (LinearStretch& stretch : linear.stretches) stretch.values.setConstant(7.0);
  predictions_.linearise_values(point, residuals, linear, {true});
  EXPECT_TRUE(linear.stretches[0].values.isConstant(7.0));
  predictions_.linearise_values(point, residuals, linear, {false});
  EXPECT_FALSE(linear.stretches[0].values.isConstant(7.0));
}

TEST_F(LinearPredictionTest, ResidualsAtAPointLeaveTheDerivativesByStarts) {
  std::vector<LinearStretch> stretches = predictions_.linearise(smoothed(kPull))->stretches;
  const Eigen::VectorXd before = stretches[0].residual;
  const Eigen::MatrixXd by_start = stretches[0].start;
  ASSERT_TRUE(predictions_.residuals_at(smoothed(2.0), stretches));
  EXPECT_EQ(stretches[0].start, by_start);
  EXPECT_EQ(stretches[0].values.cols(), 0);
  EXPECT_TRUE((before - stretches[0].residual).isApprox(0.5 * (2.0 - kPull) * times(0).cwiseAbs2() / noise(), 1e-6));
}

/// An acceleration of 1 more than the model's, once the values have moved by it, moves no start.
TEST_F(LinearPredictionTest, StartsFollowWhatAStepOfTheValuesLeaves) {
  LinearPrediction linear = *predictions_.linearise(smoothed(kPull));
  for (LinearStretch& stretch : linear.stretches) stretch.residual = stretch.values.col(0);
  const std::vector<Eigen::VectorXd> stay = moved_starts(ladder_, linear, Eigen::VectorXd::Ones(1));
  const std::vector<Eigen::VectorXd> move = moved_starts(ladder_, linear, Eigen::VectorXd::Zero(1));
  const PredictionPoint smoothed_point = smoothed(kPull);
  EXPECT_LT((stay[1] - smoothed_point.starts[1]).norm(), 1e-9);
  EXPECT_GT((move[1] - smoothed_point.starts[1]).norm(), 1e-3);
}

TEST_F(LinearPredictionTest, SpendsNoSimulationsOnStepsThatItTakesOver) {
  const PredictionLadder other = rig_.ladder({2.0});
  LadderPredictions own = rig_.predictions(other), taking = rig_.predictions(other);
  predictions_.linearise(smoothed(kPull));
  taking.take_steps_of(predictions_);
  const auto chosen = own.linearise(own.at_smoothed_starts(rig_.at({kPull})));
  const auto taken = taking.linearise(taking.at_smoothed_starts(rig_.at({kPull})));
  EXPECT_LT(taking.simulations(), own.simulations());
  EXPECT_TRUE(taken->stretches[0].values.isApprox(chosen->stretches[0].values, 1e-4));
}

TEST(LadderPredictionsTest, DoNotDependOnTheNumberOfThreads) {
  const auto values_by = [](int threads) {
    const OneJointRig rig(damped_spring, {analytic::free_value("b", 0.1, 0.0, 10.0)}, {0.5}, {4.0}, threads);
    const PredictionLadder ladder = rig.ladder({0.5});
    LadderPredictions predictions = rig.predictions(ladder);
    return predictions.linearise(predictions.at_smoothed_starts(rig.at({0.1})))->stretches[3].values;
  };
  EXPECT_EQ(values_by(1), values_by(2));
}

TEST(LadderPredictionsTest, SayWhyAPointCannotBeSimulated) {
  const OneJointRig rig(
      [](std::span<const double> values, double, double, double) { return values[0] > 1.0 ? std::nan("") : 0.0; },
      {analytic::free_value("b", 0.0, 0.0, 2.0)}, {0.0});
  const PredictionLadder ladder = rig.ladder({0.5});
  LadderPredictions predictions = rig.predictions(ladder);
  EXPECT_TRUE(predictions.linearise(predictions.at_smoothed_starts(rig.at({0.5}))));
  EXPECT_FALSE(predictions.linearise(predictions.at_smoothed_starts(rig.at({1.5}))));
  EXPECT_EQ(predictions.failure(), "the joint's position is not finite");
}

}  // namespace
}  // namespace lacuna

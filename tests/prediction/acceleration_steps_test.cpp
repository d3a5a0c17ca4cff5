#include "prediction/acceleration_steps.h"

#include "prediction/descent.h"
#include "prediction/one_joint_rig.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double kStiff = 40.0;  // 1/s: the joint's speed follows its command within 25 ms

EngineSettings engine_of_the_readings() {
  EngineSettings engine;
  engine.step = 1.0 / kRigRate;
  return engine;
}

FreeValue damping() { return analytic::free_value("b", 0.0, 0.0, 1000.0); }

PredictionFit fit_steps(const OneJointRig& rig, const AccelerationSteps& steps, double from, int most) {
  const TrialPredictor predictor(rig.model, steps.trials, {1});
  LadderPredictions predictions(steps.ladder, predictor, rig.space, rig.starts);
  return descend(predictions, predictions.at_smoothed_starts(rig.at({from})), most);
}

TEST(AccelerationSteps, AreASixteenthOfTheReadingsInterval) {
  const OneJointRig rig(damped_spring, {damping()}, {0.5});
  const AccelerationSteps steps = acceleration_steps(rig.source(), engine_of_the_readings(), 50);
  EXPECT_EQ(steps.engine.substeps, 16);
  ASSERT_EQ(steps.ladder.stretches.size(), 45U) << "401 samples, every ninth";
  const Eigen::VectorXd& times = steps.trials.front().measured.times;
  EXPECT_NEAR(times(3) - times(2), 0.01 / 16.0, 1e-12);
  EXPECT_NEAR(times(2), 0.09, 1e-12);
}

TEST(AccelerationSteps, KeepStepsThatAreShorterStill) {
  const OneJointRig rig(damped_spring, {damping()}, {0.5});
  EngineSettings engine = engine_of_the_readings();
  engine.substeps = 64;
  EXPECT_EQ(acceleration_steps(rig.source(), engine, 50).engine.substeps, 64);
}

/// A parabola has one acceleration, which the smoother finds.
TEST(AccelerationSteps, ReadWhatTheSmoothedAccelerationMakes) {
  const OneJointRig rig(constant_acceleration, {analytic::free_value("a", 0.0, -10.0, 10.0)}, {2.0});
  const AccelerationSteps steps = acceleration_steps(rig.source(), engine_of_the_readings(), 50);
  const PredictionFit fit = fit_steps(rig, steps, 0.0, 3);
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.point.values(0), 2.0, 0.1);
}

/// The force of a damper is linear in its damping at a given speed, so one step leads from nothing to its value; in
/// predictions of ten samples the joint would run far away without it.
TEST(AccelerationSteps, LeadFromNothingToAStiffDampingAtOnce) {
  const OneJointRig rig(damped_spring, {damping()}, {kStiff});
  const AccelerationSteps steps = acceleration_steps(rig.source(), engine_of_the_readings(), 200);
  const PredictionFit fit = fit_steps(rig, steps, 0.0, 2);
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.point.values(0), kStiff, 0.2 * kStiff);
}

}  // namespace
}  // namespace lacuna

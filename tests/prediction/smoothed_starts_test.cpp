#include "prediction/smoothed_starts.h"

#include "prediction/one_joint_rig.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kPull = 0.8;  // rad/s²

/// A parabola of 4 s, so that the state is known at any time.
OneJointRig parabola() { return {constant_acceleration, {analytic::free_value("a", 0.0, -5.0, 5.0)}, {kPull}}; }

TEST(SmoothedStarts, AreTheStateToWithinTheirDeviations) {
  const OneJointRig rig = parabola();
  for (const Eigen::Index sample : {50, 200, 350}) {
    const StartEstimate start = rig.starts.at(0, sample);
    ASSERT_TRUE(start.valid);
    const StartState truth = parabola_at(kPull, 0.01 * static_cast<double>(sample));
    EXPECT_NEAR(start.start.positions[0], truth.positions[0], 4.0 * start.deviation(0)) << sample;
    EXPECT_NEAR(start.start.velocities[0], truth.velocities[0], 4.0 * start.deviation(1)) << sample;
    EXPECT_LT(start.deviation(0), kRigNoise) << "many readings tell more than one";
  }
}

TEST(SmoothedStarts, KnowHowPositionAndVelocityErrTogether) {
  const StartEstimate start = parabola().starts.at(0, 0);
  const Eigen::MatrixXd covariance = start.axes * start.axes.transpose();
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), start.deviation(0), 1e-12);
  EXPECT_NEAR(std::sqrt(covariance(1, 1)), start.deviation(1), 1e-12);
  EXPECT_LT(covariance(0, 1), 0.0) << "at the beginning a higher position goes with a lower velocity";
}

TEST(SmoothedStarts, KnowTheNoiseOfTheReadings) {
  EXPECT_NEAR(parabola().starts.reading_noise(0, 0), kRigNoise, 0.15 * kRigNoise);
}

TEST(SmoothedStarts, MoveAlongTheMotionByTheDelayOfTheReading) {
  const OneJointRig rig = parabola();
  StartState start = {{10.0}, {20.0}};  // any: what is added counts
  rig.starts.move_later(0, 200, {0.255}, start);
  const StartState before = parabola_at(kPull, 2.0), after = parabola_at(kPull, 2.255);
  EXPECT_NEAR(start.positions[0] - 10.0, after.positions[0] - before.positions[0], 2e-3);
  EXPECT_NEAR(start.velocities[0] - 20.0, after.velocities[0] - before.velocities[0], 0.05);
}

TEST(SmoothedStarts, MoveNoFurtherThanTheRecording) {
  const OneJointRig rig = parabola();
  StartState start = {{0.0}, {0.0}};
  rig.starts.move_later(0, 390, {5.0}, start);
  const StartState before = parabola_at(kPull, 3.9), after = parabola_at(kPull, 4.0);
  EXPECT_NEAR(start.positions[0], after.positions[0] - before.positions[0], 4e-3);
}

TEST(SmoothedStarts, AreAsGivenAtTheFirstSample) {
  const OneJointRig rig = parabola();
  std::vector<Trial> trials = rig.trials;
  trials[0].initial = {{InitialKnowledge::given, 1.0, 2.0}};
  const TrialPredictor predictor(rig.model, trials, {1});
  const StartStates states(rig.definition.structure.robot, predictor, rig.noise);
  const SmoothedStarts starts(states, predictor.trials());
  EXPECT_EQ(starts.at(0, 0).start.positions[0], 1.0);
  EXPECT_EQ(starts.at(0, 0).start.velocities[0], 2.0);
  EXPECT_EQ(starts.at(0, 0).deviation(0), 0.0);
  EXPECT_NEAR(starts.at(0, 100).start.positions[0], parabola_at(kPull, 1.0).positions[0], 5e-3);
}

/// A sensor that reads in other units and from another zero.
TEST(SmoothedStarts, AreCoordinatesAndNotReadings) {
  const OneJointRig rig = parabola();
  RobotSpec robot = rig.definition.structure.robot;
  robot.sensors[0].scale = -2.0;
  robot.sensors[0].offset = 5.0;
  std::vector<Trial> trials = rig.trials;
  trials[0].measured.samples = (-2.0 * trials[0].measured.samples.array() + 5.0).matrix();
  const TrialPredictor predictor(rig.model, trials, {1});
  const StartStates states(robot, predictor, rig.noise);
  const SmoothedStarts starts(states, predictor.trials());
  EXPECT_NEAR(starts.at(0, 200).start.positions[0], parabola_at(kPull, 2.0).positions[0], 5e-3);
  EXPECT_NEAR(starts.reading_noise(0, 0), 2.0 * kRigNoise, 0.3 * kRigNoise);
}

TEST(SmoothedStarts, RefuseFewerThanFiveReadings) {
  const OneJointRig rig = parabola();
  std::vector<Trial> trials = rig.trials;
  trials[0].measured.samples.bottomRows(trials[0].measured.samples.rows() - 4).setConstant(std::nan(""));
  const TrialPredictor predictor(rig.model, trials, {1});
  const StartStates states(rig.definition.structure.robot, predictor, rig.noise);
  EXPECT_THROW(SmoothedStarts(states, predictor.trials()), Error);
}

}  // namespace
}  // namespace lacuna

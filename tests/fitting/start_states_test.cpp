#include "fitting/starts/start_states.h"

#include "fitting/analytic_models.h"
#include "fitting/starts/start_fit.h"
#include "fitting/numerics/local_polynomial.h"
#include "fitting/starts/segments.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;

double fall(std::span<const double>, double, double, double) { return -9.81; }

/// A free fall from 0.3 with −0.2/s, 200 Hz.
Trial falling(double noise, Eigen::Index samples = 401) {
  return record(OneJointModel(fall), {}, regular_times(samples, 200.0), {}, {{0.3}, {-0.2}}, noise, 5);
}

struct Fixture {
  explicit Fixture(Trial trial, const RobotSpec& robot = one_joint_robot())
      : model(fall),
        predictor(model, {std::move(trial)}, {1}),
        noise({{"angle", "rad", 1e-3, ""}}),
        states(robot, predictor, noise) {}
  OneJointModel model;
  TrialPredictor predictor;
  std::vector<ChannelNoise> noise;
  StartStates states;
};

TEST(LocalPolynomial, IsExactOnAParabola) {
  const Trial trial = falling(0.0);
  const LocalPolynomial at = fit_local_polynomial(trial.measured, 0, {0, 401}, 200, 2, 0.05, 1e-3);
  EXPECT_NEAR(at.value, 0.3 - 0.2 - 0.5 * 9.81, 1e-9);
  EXPECT_NEAR(at.slope, -0.2 - 9.81, 1e-7);
}

TEST(LocalPolynomial, StepsOverMaskedSamplesAndKnowsWhenThereAreNone) {
  Trial trial = falling(0.0);
  trial.measured.samples.middleRows(180, 50).setConstant(std::nan(""));
  EXPECT_NEAR(fit_local_polynomial(trial.measured, 0, {0, 401}, 200, 2, 0.05, 1e-3).slope, -10.01, 1e-7);
  EXPECT_EQ(fit_local_polynomial(trial.measured, 0, {185, 220}, 200, 2, 0.05, 1e-3).points, 0);
}

TEST(LocalPolynomial, AnEncoderThatStaysOnItsStepIsOneReading) {
  Trial trial = falling(0.0);
  trial.measured.samples.setConstant(0.7);
  const LocalPolynomial at = fit_local_polynomial(trial.measured, 0, {0, 401}, 0, 1, 0.05, 1e-3);
  EXPECT_NEAR(at.value_deviation, 1e-3, 0.15e-3);
  EXPECT_EQ(repetition(trial.measured, 0, {0, 11}), std::sqrt(11.0 / 4.0));
  EXPECT_EQ(repetition(falling(0.0).measured, 0, {0, 11}), 1.0);
}

TEST(StartStates, ReadsPositionAndVelocityThroughScaleAndOffset) {
  RobotSpec robot = one_joint_robot();
  robot.sensors[0].scale = -2.0;
  robot.sensors[0].offset = 0.5;
  Trial trial = falling(0.0);
  trial.measured.samples = (-2.0 * trial.measured.samples).array() + 0.5;
  const Fixture f(trial, robot);
  const StartEstimate estimate = f.states.from_samples(f.predictor.whole(0), 0);
  EXPECT_NEAR(estimate.start.positions[0], 0.3, 1e-9);
  EXPECT_NEAR(estimate.start.velocities[0], -0.2, 1e-6);
}

TEST(StartStates, KnowsWhatCannotBeReconstructed) {
  RobotSpec robot = one_joint_robot();
  robot.sensors[0].kind = SensorKind::joint_velocity;
  const Fixture f(falling(0.0), robot);
  EXPECT_FALSE(f.states.reconstructible(0));
  EXPECT_EQ(f.states.unmeasured(0).front(), "joint.hinge");
  RobotSpec floating = one_joint_robot();
  floating.bodies.resize(2);
  EXPECT_FALSE(Fixture(falling(0.0), floating).states.reconstructible(0));
}

/// Delayed readings of the past, without which a simulation from the middle of a trial reads its first value again.
TEST(StartStates, ModelsWithAMemoryOfTheirOwnStartAtTheBeginningOnly) {
  const auto obstacle = [](const RobotSpec& robot) {
    const std::unique_ptr<CompiledModel> model = compile({robot, {}, {}}, {});
    const TrialPredictor predictor(*model, {falling(0.0)}, {1});
    return StartStates(robot, predictor, {{"angle", "rad", 1e-3, ""}}).obstacle(0);
  };
  RobotSpec robot = one_joint_robot();
  EXPECT_EQ(obstacle(robot), "");
  robot.sensors[0].delay = 0.02;
  EXPECT_EQ(obstacle(robot), "a sensor's readings are delayed");
  robot = one_joint_robot();
  robot.actuators[0].transmission.stiffness = 100.0;
  EXPECT_EQ(obstacle(robot), "the rotor of actuator.motor moves independently of the joint");
}

TEST(FitHead, FindsTheStartWithinItsStatedUncertainty) {
  const Fixture f(falling(1e-3));
  const StartEstimate estimate = fit_head(f.predictor, f.states, f.predictor.whole(0), {}, 0);
  ASSERT_TRUE(estimate.valid);
  EXPECT_NEAR(estimate.start.positions[0], 0.3, 3.0 * estimate.deviation(0));
  EXPECT_NEAR(estimate.start.velocities[0], -0.2, 3.0 * estimate.deviation(1));
  // Of a line through N = 11 samples of T = 50 ms, as regression has it; the noise found may pass for a larger one.
  EXPECT_NEAR(estimate.deviation(0), 1e-3 * std::sqrt(2.0 * 21.0 / (11.0 * 12.0)), 0.3e-3);
  EXPECT_NEAR(estimate.deviation(1), 1e-3 / 5e-3 * std::sqrt(12.0 / (11.0 * 120.0)), 6e-3);
  EXPECT_EQ(head_end(f.predictor, f.predictor.whole(0)), 11);
}

TEST(FitHead, LeavesGivenStartsAlone) {
  Trial trial = falling(1e-3);
  trial.initial = {{InitialKnowledge::given, 0.31, -0.25}};
  const Fixture f(trial);
  const StartEstimate estimate = fit_head(f.predictor, f.states, f.predictor.whole(0), {}, 0);
  EXPECT_EQ(estimate.start.positions[0], 0.31);
  EXPECT_EQ(estimate.start.velocities[0], -0.25);
  EXPECT_EQ(first_scored(f.predictor, f.predictor.whole(0), estimate), 0);
}

/// The first scored sample of 200 Hz samples, by a model whose drive may be late.
Eigen::Index first_scored_of(const Trial& trial, double delay) {
  RobotSpec robot = one_joint_robot();
  robot.actuators[0].delay = delay;
  const std::unique_ptr<CompiledModel> model = compile({robot, {}, {}}, {});
  const TrialPredictor predictor(*model, {trial}, {1});
  const StartStates states(robot, predictor, {{"angle", "rad", 1e-3, ""}});
  return first_scored(predictor, predictor.whole(0), fit_head(predictor, states, predictor.whole(0), {}, 0));
}

TEST(FirstScored, OfAModelWithAMemoryIsAfterWhatNobodyKnows) {
  Trial trial = falling(1e-3);
  trial.commands.series = {
      {{"motor", "N*m"}}, trial.measured.times, TimeSeries::Samples::Constant(trial.measured.times.size(), 1, 0.1)};
  EXPECT_EQ(first_scored_of(trial, 0.02), 11) << "a test of its own begins with its first command";
  trial.commands.before = {std::nan("")};
  EXPECT_EQ(first_scored_of(trial, 0.02), 21) << "0.1 s of commands fill the delay";
  EXPECT_EQ(first_scored_of(trial, 0.0), 11) << "without a memory it does not matter";
  trial.commands.before = {0.0};
  EXPECT_EQ(first_scored_of(trial, 0.02), 11) << "stated";
  trial.commands.before = {std::nan("")};
  trial.initial = {{InitialKnowledge::free, 0.3, -0.2}};
  EXPECT_EQ(first_scored_of(trial, 0.02), 21);
  trial.initial = {{InitialKnowledge::given, 0.3, 0.0}};
  EXPECT_EQ(first_scored_of(trial, 0.02), 0) << "what held it at rest is known";
}

TEST(Cut, MakesEqualStretchesThatCoverTheTrial) {
  const Trial trial = falling(0.0);
  const std::vector<Stretch> stretches = cut(trial, 0, 0.5);
  ASSERT_EQ(stretches.size(), 4u);
  EXPECT_EQ(stretches.front().first, 0);
  EXPECT_EQ(stretches.back().last, 401);
  for (std::size_t i = 1; i < stretches.size(); ++i) EXPECT_EQ(stretches[i].first, stretches[i - 1].last);
  EXPECT_EQ(cut(trial, 0, 100.0).size(), 1u);
  EXPECT_EQ(cut(falling(0.0, 1), 0, 0.1).size(), 1u);
}

TEST(Thinned, KeepsSegmentsFromAllOverTheTrial) {
  const Fixture f(falling(1e-3));
  const std::vector<Segment> all = make_segments(f.predictor, f.states, 0.1, {});
  ASSERT_EQ(all.size(), 20u);
  const std::vector<Segment> kept = thinned(all, 5);
  ASSERT_EQ(kept.size(), 5u);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].stretch, all[4 * i].stretch);
  EXPECT_EQ(thinned(all, 100).size(), 20u);
}

TEST(SameStarts, AreThoseThatDifferByLessThanATenthOfTheirDeviations) {
  const Fixture f(falling(1e-3));
  const std::vector<Segment> all = make_segments(f.predictor, f.states, 0.5, {});
  std::vector<Segment> other = all;
  EXPECT_TRUE(same_starts(all, other));
  other[2].start.velocities[0] += 0.05 * other[2].deviation(1);
  EXPECT_TRUE(same_starts(all, other));
  other[2].start.velocities[0] += 0.1 * other[2].deviation(1);
  EXPECT_FALSE(same_starts(all, other));
  EXPECT_FALSE(same_starts(all, {all[0], all[1]}));
}

TEST(MakeSegments, LeavesOutWhatTellsNothing) {
  Trial trial = falling(1e-3);
  trial.measured.samples.middleRows(100, 100).setConstant(std::nan(""));
  const Fixture f(trial);
  EXPECT_EQ(make_segments(f.predictor, f.states, 0.5, {}).size(), 3u);
}

TEST(Segments, InnerOnesAreSimulatedFromBeforeWhatCounts) {
  const Fixture at(falling(1e-3));
  const std::vector<Segment> segments = make_segments(at.predictor, at.states, 0.5, {}, 0.1);
  ASSERT_EQ(segments.size(), 4u);
  EXPECT_EQ(segments[0].run_in, 0);
  for (std::size_t k = 1; k < segments.size(); ++k) {
    EXPECT_EQ(segments[k].run_in, 20);
    EXPECT_EQ(segments[k].rows.front(), 20);
    EXPECT_EQ(segments[k].first_counted(), segments[k - 1].stretch.last);
    const double time = at.predictor.trials()[0].measured.times(segments[k].stretch.first);
    EXPECT_NEAR(segments[k].start.positions[0], 0.3 - 0.2 * time - 0.5 * 9.81 * time * time, 5e-3);
  }
}

}  // namespace
}  // namespace lacuna

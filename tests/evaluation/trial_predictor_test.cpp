#include "evaluation/prediction/trial_predictor.h"

#include "fitting/analytic_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;
using testing::HasSubstr;

/// q'' = u / mass.
double pushed(std::span<const double> values, double, double, double u) { return u / values[0]; }

Trial pushed_trial() {
  return record(OneJointModel(pushed), {2.0}, regular_times(201, 100.0), two_sines(2.0, 1.0), {{0.1}, {0.3}}, 0.0, 1);
}

TEST(TrialPredictor, AWholeTrialFromItsStartIsTheRecording) {
  const OneJointModel model(pushed);
  const TrialPredictor predictor(model, {pushed_trial()}, {1});
  Prediction prediction;
  TimeSeries::Samples residuals;
  predictor.predict(predictor.whole(0), std::vector{2.0}, {{0.1}, {0.3}}, 0, prediction);
  predictor.residuals(predictor.whole(0), prediction, residuals);
  EXPECT_TRUE(prediction.valid);
  EXPECT_EQ(residuals.cwiseAbs().maxCoeff(), 0.0);
}

TEST(TrialPredictor, AStretchReplaysTheCommandsOfItsOwnTime) {
  // Velocity in the middle from the positions around it, so a wrong clock would show at once.
  const OneJointModel model(pushed);
  const Trial trial = pushed_trial();
  const TrialPredictor predictor(model, {trial}, {1});
  SimulationOptions options;
  const Stretch stretch{0, 80, 140};
  const auto& q = trial.measured.samples;
  // Under a held force the parabola through three samples is exact.
  const double force = trial.commands.series.samples(80, 0);
  const double velocity = (q(81, 0) - q(80, 0)) / 0.01 - 0.5 * (force / 2.0) * 0.01;
  Prediction prediction;
  predictor.predict(stretch, std::vector{2.0}, {{q(80, 0)}, {velocity}}, 0, prediction);
  EXPECT_LT((prediction.samples - q.middleRows(80, 60)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(TrialPredictor, CommandsActLaterWhereTheirTimingIsFitted) {
  const OneJointModel model(pushed);
  const Trial trial = pushed_trial();
  Trial late = trial;
  late.commands.series.times.array() += 0.3 * command_interval(trial);
  const TrialPredictor timed(model, {trial, late}, {1}, Timing::fitted), recorded(model, {trial, late}, {1});
  Prediction by_timing, by_times, as_recorded;
  timed.predict(timed.whole(0), std::vector{2.0, 0.3}, {{0.1}, {0.3}}, 0, by_timing);
  recorded.predict(recorded.whole(1), std::vector{2.0}, {{0.1}, {0.3}}, 0, by_times);
  timed.predict(timed.whole(0), std::vector{2.0, 0.0}, {{0.1}, {0.3}}, 0, as_recorded);
  EXPECT_EQ(by_timing.samples, by_times.samples);
  EXPECT_EQ(as_recorded.samples, trial.measured.samples);
}

TEST(TrialPredictor, TimedCommandsAreThoseOfTheirTrial) {
  const OneJointModel model(pushed);
  Trial back = pushed_trial();
  back.commands.series.samples = -back.commands.series.samples;
  const TrialPredictor both(model, {pushed_trial(), back}, {1}, Timing::fitted),
      alone(model, {back}, {1}, Timing::fitted);
  Prediction before, after, expected;
  both.predict(both.whole(0), std::vector{2.0, 0.3}, {{0.1}, {0.3}}, 0, before);
  both.predict(both.whole(1), std::vector{2.0, 0.3}, {{0.1}, {0.3}}, 0, after);
  alone.predict(alone.whole(0), std::vector{2.0, 0.3}, {{0.1}, {0.3}}, 0, expected);
  EXPECT_EQ(after.samples, expected.samples);
  EXPECT_NE(after.samples, before.samples);
}

TEST(CommandInterval, IsTheMeanOneOfATrial) { EXPECT_NEAR(command_interval(pushed_trial()), 0.01, 1e-12); }

TEST(CommandInterval, OfRareRowsIsTenOfTheReadings) {
  Trial steps = pushed_trial();
  CommandSeries& commands = steps.commands;
  commands.series.times = Eigen::Vector2d(0.0, 1.5);
  commands.series.samples = commands.series.samples.topRows(2).eval();
  EXPECT_NEAR(command_interval(steps), 0.1, 1e-12);
}

TEST(TrialPredictor, OneSampleIsTheStart) {
  const OneJointModel model(pushed);
  const TrialPredictor predictor(model, {pushed_trial()}, {1});
  Prediction prediction;
  predictor.predict({0, 50, 51}, std::vector{2.0}, {{0.7}, {0.0}}, 0, prediction);
  EXPECT_EQ(prediction.samples(0, 0), 0.7);
}

TEST(TrialPredictor, AFailedSimulationIsInvalidWithAReasonAndTheNextOneIsNot) {
  const OneJointModel model(pushed);
  const TrialPredictor predictor(model, {pushed_trial()}, {1});
  Prediction prediction;
  predictor.predict(predictor.whole(0), std::vector{0.0}, {{0.1}, {0.3}}, 0, prediction);
  EXPECT_FALSE(prediction.valid);
  EXPECT_THAT(prediction.reason, HasSubstr("not finite"));
  predictor.predict(predictor.whole(0), std::vector{2.0}, {{0.1}, {0.3}}, 0, prediction);
  EXPECT_TRUE(prediction.valid);
}

TEST(TrialPredictor, RefusesChannelsThatTheModelDoesNotHave) {
  const OneJointModel model(pushed);
  Trial trial = pushed_trial();
  trial.measured.channels[0].name = "angel";
  try {
    const TrialPredictor predictor(model, {trial}, {1});
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"angle\"?"));
  }
  trial.measured.channels[0] = {"angle", "m"};
  EXPECT_THROW(TrialPredictor(model, {trial}, {1}), Error);
}

TEST(TrialPredictor, ResidualsAreMissingWhereNothingWasMeasured) {
  const OneJointModel model(pushed);
  Trial trial = pushed_trial();
  trial.measured.samples(7, 0) = std::nan("");
  const TrialPredictor predictor(model, {trial}, {1});
  Prediction prediction;
  TimeSeries::Samples residuals;
  predictor.predict(predictor.whole(0), std::vector{2.0}, {{0.1}, {0.3}}, 0, prediction);
  predictor.residuals(predictor.whole(0), prediction, residuals);
  EXPECT_TRUE(std::isnan(residuals(7, 0)));
  EXPECT_EQ(residuals(8, 0), 0.0);
}

}  // namespace
}  // namespace lacuna

#include "fitting/integration_bias.h"

#include "evaluation/prediction/trial_predictor.h"
#include "fitting/sprung_flywheel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna::integration_bias_test {
namespace {

using namespace lacuna::flywheel;

constexpr double kFrequency = 6.0;  // rad/s

/// Of a flywheel whose spring is fitted to one recording of `all`.
IntegrationBias bias_of(const ModelDefinition& definition, const std::vector<Trial>& trials, std::size_t all = 1) {
  return {definition, {}, trials, all, {definition.free[0].start}, 16, {1}};
}

/// The engine is of second order: half the step, a quarter of the error.
TEST(IntegrationBias, FallsWithTheSquareOfTheStep) {
  const ModelDefinition definition = with_free_spring(kFrequency);
  const std::vector<Trial> trials = {recorded(sprung(kFrequency))};
  const IntegrationBias bias = bias_of(definition, trials);
  ASSERT_EQ(bias.values().size(), 1U);
  EXPECT_NEAR(bias.values()[0], kFrequency * kFrequency, 0.01 * kFrequency * kFrequency) << "near the end of a fit";
  const std::optional<ValueShift> once = bias.with(1), twice = bias.with(2);
  ASSERT_TRUE(once && twice);
  EXPECT_EQ(once->address, "joint.joint.stiffness");
  EXPECT_GT(once->share, 0.3);
  EXPECT_NEAR(once->share / twice->share, 4.0, 0.2);
}

/// Of the spring, where the errors of readings are independent: theirs over the length of the readings' derivative.
double textbook_error(const ModelDefinition& definition, const Trial& trial) {
  constexpr double kSlight = 0.01;  // N·m/rad
  const std::unique_ptr<CompiledModel> model = compiled(definition, 64);
  const TrialPredictor predictor(*model, {trial}, {1});
  const auto readings = [&](double stiffness) {
    Prediction prediction;
    predictor.predict(predictor.whole(0), std::vector{stiffness}, {{kStart}, {0.0}}, 0, prediction);
    return Eigen::VectorXd(prediction.samples.col(0));
  };
  const double truth = kFrequency * kFrequency;
  return kDeviation * 2.0 * kSlight / (readings(truth + kSlight) - readings(truth - kSlight)).norm();
}

/// The difference between fits with these steps and with much shorter ones, over half an interval, which is never
/// narrower than that of independent errors.
TEST(IntegrationBias, IsTheDifferenceBetweenFitsOverHalfAnInterval) {
  const ModelDefinition definition = with_free_spring(kFrequency);
  const std::vector<Trial> trials = {recorded(sprung(kFrequency))};
  const FittedValue coarse = fitted_spring(definition, trials, 1), exact = fitted_spring(definition, trials, 64);
  const double quantile = (exact.upper_95 - exact.value) / exact.standard_error;
  const double half = quantile * std::max(exact.standard_error, textbook_error(definition, trials[0]));
  const double share = std::abs(coarse.value - exact.value) / half;
  EXPECT_NEAR(bias_of(definition, trials).with(1)->share, share, 0.05 * share);
}

/// Four times as many recordings halve the interval, and so double the share of it.
TEST(IntegrationBias, CountsTheRecordingsThatTheFitWillHave) {
  const ModelDefinition definition = with_free_spring(kFrequency);
  const std::vector<Trial> trials = {recorded(sprung(kFrequency))};
  const double one = bias_of(definition, trials).with(1)->share,
               of_four = bias_of(definition, trials, 4).with(1)->share;
  EXPECT_NEAR(of_four, 2.0 * one, 1e-9 * one);
}

TEST(IntegrationBias, IsNothingOfAModelThatCannotBeSimulated) {
  ModelDefinition definition = with_free_spring(kFrequency);
  const std::vector<Trial> trials = {recorded(sprung(kFrequency))};
  definition.structure.robot.joints[0].force = 1e12;
  const IntegrationBias bias = bias_of(definition, trials);
  EXPECT_TRUE(bias.values().empty());
  EXPECT_FALSE(bias.with(1));
}

}  // namespace
}  // namespace lacuna::integration_bias_test

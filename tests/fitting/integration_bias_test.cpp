#include "fitting/integration_bias.h"

#include "fitting/sprung_flywheel.h"

#include <gtest/gtest.h>

namespace lacuna::integration_bias_test {
namespace {

using namespace lacuna::flywheel;

constexpr double kFrequency = 6.0;  // rad/s

/// Of a flywheel whose spring is fitted to one recording of `all`.
IntegrationBias bias_of(const ModelDefinition& definition, const std::vector<Trial>& trials, std::size_t all = 1) {
  return {definition, {}, trials, all, {definition.free[0].start}, 16, 1};
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

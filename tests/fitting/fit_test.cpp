#include "fitting/fit.h"

#include "fitting/analytic_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kGravity = 9.81;
constexpr double kLength = 0.5;

/// m l² q'' = gain · u − b q' − c tanh(q'/0.01) − m g l sin q; values: mass, b, c.
double pendulum(std::span<const double> values, double q, double v, double command) {
  const double torque = command - values[1] * v - values[2] * std::tanh(v / 0.01);
  return (torque - values[0] * kGravity * kLength * std::sin(q)) / (values[0] * kLength * kLength);
}

const std::vector<double> kTruth = {0.8, 0.05, 0.1};

Trial pendulum_trial(double duration, double noise, std::uint64_t seed) {
  const OneJointModel model(pendulum);
  return record(model, kTruth, regular_times(static_cast<Eigen::Index>(200 * duration) + 1, 200.0),
                two_sines(duration, 1.5), {{0.3}, {0.0}}, noise, seed);
}

ModelDefinition pendulum_definition() {
  return define({free_value("body.arm.mass", 0.5, 0.1, 10.0), free_value("joint.hinge.damping", 0.0, 0.0, 1e4),
                 free_value("joint.hinge.dry_friction", 0.0, 0.0, 1e4)},
                one_joint_robot());
}

FitResult fit_pendulum(const std::vector<Trial>& trials, FitSection options = {}, int threads = 2) {
  const OneJointModel model(pendulum);
  const ModelDefinition definition = pendulum_definition();
  return fit({definition, model, trials, options, 1, threads});
}

TEST(Fit, RecoversMassAndFrictionOfAPendulumByMultipleShooting) {
  const FitResult result = fit_pendulum({pendulum_trial(8.0, 1e-3, 3)});
  for (std::size_t i = 0; i < kTruth.size(); ++i) {
    EXPECT_NEAR(result.values[i].value, kTruth[i], 0.02 * kTruth[i]) << result.values[i].address;
    EXPECT_LT(result.values[i].lower_95, kTruth[i]) << result.values[i].address;
    EXPECT_GT(result.values[i].upper_95, kTruth[i]) << result.values[i].address;
  }
  ASSERT_EQ(result.stages.size(), 3u);
  EXPECT_EQ(result.stages[0].segments, 80);
  EXPECT_EQ(result.stages[2].name, "free run");
  EXPECT_NEAR(result.stages[2].residual, 1.0, 0.05);
  EXPECT_TRUE(result.cannot_tell.empty()) << result.cannot_tell.front();
}

TEST(Fit, GivesTheSameDigitsForAnyNumberOfThreads) {
  const std::vector<Trial> trials = {pendulum_trial(3.0, 1e-3, 3), pendulum_trial(2.0, 1e-3, 4)};
  const FitResult one = fit_pendulum(trials, {}, 1);
  const FitResult two = fit_pendulum(trials, {}, 2);
  EXPECT_EQ(one.parameters(), two.parameters());
  EXPECT_EQ(one.simulations, two.simulations);
  for (std::size_t i = 0; i < one.values.size(); ++i)
    EXPECT_EQ(one.values[i].standard_error, two.values[i].standard_error);
}

}  // namespace
}  // namespace lacuna

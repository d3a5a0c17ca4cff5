#include "fitting/fit.h"

#include "fitting/analytic_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;
using testing::ElementsAre;
using testing::IsEmpty;

/// Fits a slider to a recording of itself with the values given; starts are 10 % off.
FitResult fit_slider(const OneJointModel::Acceleration& acceleration, std::vector<FreeValue> free,
                     const std::vector<double>& truth) {
  const OneJointModel model(acceleration);
  const ModelDefinition definition = define(std::move(free), one_joint_robot());
  const std::vector<Trial> trials = {
      record(model, truth, regular_times(801, 200.0), two_sines(4.0, 5.0), {{0.0}, {0.0}}, 1e-3, 7)};
  return fit({definition, model, trials, {}, 1, {2}});
}

TEST(Identifiability, MassAndGainOfAFreeSliderAreKnownByTheirRatioOnly) {
  const FitResult result = fit_slider(
      [](std::span<const double> p, double, double, double u) { return p[1] * u / p[0]; },
      {free_value("body.arm.mass", 2.2, 0.1, 10.0), free_value("actuator.motor.gain", 0.9, 0.1, 10.0)}, {2.0, 1.0});
  EXPECT_THAT(result.cannot_tell,
              ElementsAre("the data cannot tell body.arm.mass from actuator.motor.gain (only their ratio)"));
  EXPECT_NEAR(result.values[0].value / result.values[1].value, 2.0, 0.02);
  EXPECT_FALSE(result.values[0].identified);
  EXPECT_TRUE(std::isinf(result.values[0].standard_error));
  EXPECT_EQ(result.values[0].upper_95, 10.0);
}

TEST(Identifiability, GainAndScaleOfASensorAreKnownByTheirProductOnly) {
  // Position = scale · (gain u integrated twice); the sensor's scale is a part of the reading here.
  const FitResult result = fit_slider(
      [](std::span<const double> p, double, double, double u) { return p[0] * p[1] * u; },
      {free_value("actuator.motor.gain", 1.1, 0.1, 10.0), free_value("body.arm.lever", 0.9, 0.1, 10.0)}, {1.0, 1.0});
  EXPECT_THAT(result.cannot_tell,
              ElementsAre("the data cannot tell actuator.motor.gain from body.arm.lever (only their product)"));
}

TEST(Identifiability, TwoFrictionsOfOneJointAreKnownByTheirSumOnly) {
  FreeValue one = free_value("effect.one.damping", 0.3, 0.0, 10.0);
  FreeValue two = free_value("effect.two.damping", 0.3, 0.0, 10.0);
  one.unit = two.unit = "N*m*s/rad";
  const OneJointModel::Acceleration damped = [](std::span<const double> p, double, double v, double u) {
    return u - (p[0] + p[1]) * v;
  };
  const auto sum = ElementsAre("the data cannot tell effect.one.damping from effect.two.damping (only their sum)");
  const FitResult equal = fit_slider(damped, {one, two}, {0.4, 0.4});
  EXPECT_NEAR(equal.values[0].value + equal.values[1].value, 0.8, 0.02);
  EXPECT_THAT(equal.cannot_tell, sum);
  one.start = 0.1;
  EXPECT_THAT(fit_slider(damped, {one, two}, {0.4, 0.4}).cannot_tell, sum);
}

TEST(Identifiability, NamesAValueThatNothingShows) {
  const FitResult result = fit_slider(
      [](std::span<const double> p, double, double, double u) { return u / p[0]; },
      {free_value("body.arm.mass", 2.2, 0.1, 10.0), free_value("contact.friction", 0.5, 0.0, 2.0)}, {2.0, 0.5});
  EXPECT_THAT(result.cannot_tell,
              ElementsAre("the data do not determine contact.friction: any value within its bounds fits"));
  EXPECT_TRUE(result.values[0].identified);
  EXPECT_NEAR(result.values[0].value, 2.0, 0.02);
  EXPECT_TRUE(std::isfinite(result.values[0].standard_error));
}

TEST(Identifiability, GravityTellsMassFromGain) {
  const FitResult result = fit_slider(
      [](std::span<const double> p, double q, double, double u) { return p[1] * u / p[0] - 9.81 * std::sin(q); },
      {free_value("body.arm.mass", 2.2, 0.1, 10.0), free_value("joint.hinge.damping", 0.5, 0.0, 10.0)}, {2.0, 1.0});
  EXPECT_THAT(result.cannot_tell, testing::SizeIs(1));  // still their ratio: gravity does not weigh the force
  const FitResult told = fit_slider(
      [](std::span<const double> p, double q, double, double u) { return (p[1] * u - 9.81 * std::sin(q)) / p[0]; },
      {free_value("body.arm.mass", 2.2, 0.1, 10.0), free_value("actuator.motor.gain", 0.9, 0.1, 10.0)}, {2.0, 1.0});
  EXPECT_THAT(told.cannot_tell, IsEmpty());
  EXPECT_NEAR(told.values[0].value, 2.0, 0.05);
}

}  // namespace
}  // namespace lacuna

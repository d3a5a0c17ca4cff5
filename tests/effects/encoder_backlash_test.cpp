#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna::encoder_backlash_test {
namespace {

constexpr double kMass = 1.5, kGap = 0.02, kForce = 0.4, kTime = 0.03;

const PhysicalEffect& effect() { return built_catalog().get<PhysicalEffect>("encoder_backlash"); }

SimulationRun with_play(double step) {
  SimulationRun run(one_joint(JointKind::slider, kMass), step);
  run.place(effect(), ElementKind::sensor, {0}, {kGap, kForce, kTime});
  return run;
}

/// What the reading has more than the joint's position.
double lead(const SimulationRun& run, double time) {
  SimulationRun without = run;
  without.structure.effects.clear();
  return run.last("position", time) - without.last("position", time);
}

TEST(EncoderBacklash, LeadsToTheSideToWhichTheMotorPushes) {
  SimulationRun run = with_play(1e-3);
  EXPECT_EQ(lead(run.command("motor", 0.0), 0.5), 0.0);
  EXPECT_NEAR(lead(run.command("motor", 5.0), 0.5), 0.5 * kGap, 1e-6 * kGap);
  EXPECT_NEAR(lead(run.command("motor", -5.0), 0.5), -0.5 * kGap, 1e-6 * kGap);
}

TEST(EncoderBacklash, CrossesTheGapExponentiallyWhereTheForceTurnsRound) {
  const double full = std::tanh(0.3 / kForce);
  SimulationRun run = with_play(1e-3);
  run.command("motor", {0.0, 0.1}, {0.3, -0.3}, Hold::zero_order);
  const double before = full * (1.0 - std::exp(-0.1 / kTime));
  for (const double passed : {0.01, 0.05})
    EXPECT_NEAR(lead(run, 0.1 + passed), 0.5 * kGap * (-full + (before + full) * std::exp(-passed / kTime)), kRounding);
}

/// A force that falls evenly through zero.
TEST(EncoderBacklash, IsOfSecondOrder) {
  constexpr double kEnd = 0.3;
  const Derivative crossing = [](const ReferenceState& x, ReferenceState& dx, double time) {
    dx = {(std::tanh((1.0 - 5.0 * time) / kForce) - x[0]) / kTime};
  };
  const double expected = 0.5 * kGap * integrate_smooth(crossing, {0.0}, {0.0, kEnd}).back()[0];
  const auto error = [&](double step) {
    return lead(with_play(step).command("motor", {0.0, 0.4}, {1.0, -1.0}, Hold::first_order), kEnd) - expected;
  };
  EXPECT_LT(std::abs(error(4e-3)), 1e-4 * kGap * 10.0);
  EXPECT_NEAR(error(4e-3) / error(2e-3), 4.0, 0.4);
}

TEST(EncoderBacklash, RefusesSensorsThatAreNoEncodersOfADrivenJoint) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  const std::vector<double> values = {kGap, kForce, kTime};
  const auto on = [&](int sensor) {
    const std::vector<int> elements = {sensor};
    effect().amend(robot, {values, elements, ElementKind::sensor, 1e-3});
  };
  EXPECT_THAT([&] { on(1); }, testing::ThrowsMessage<Error>(testing::HasSubstr("sensor.velocity reads no joint pos")));
  robot.actuators.clear();
  EXPECT_THAT([&] { on(0); }, testing::ThrowsMessage<Error>(testing::HasSubstr("which has no actuator")));
}

}  // namespace
}  // namespace lacuna::encoder_backlash_test

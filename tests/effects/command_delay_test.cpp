#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::command_delay_test {
namespace {

constexpr double kMass = 2.0, kSpring = 60.0, kStep = 1e-3;
constexpr double kPeriod = 0.02;  // s, of the commands

/// A mass on a spring, pushed by a held command that changes every 20 ms.
struct HeldCommands {
  std::vector<double> times, values;
  HeldCommands() {
    for (int i = 0; i < 40; ++i) {
      times.push_back(i * kPeriod);
      values.push_back(4.0 * std::sin(0.9 * i) + (i % 7 == 0 ? 5.0 : 0.0));
    }
  }
  double delayed(double time, double delay) const {
    const double index = std::floor((time - delay) / kPeriod);
    return values[index < 0.0 ? 0 : std::min(values.size() - 1, static_cast<std::size_t>(index))];
  }
};

SimulationRun oscillator(const HeldCommands& commands, double step) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.joints[0].stiffness = kSpring;
  SimulationRun run(robot, step);
  run.command("motor", commands.times, commands.values, Hold::zero_order);
  return run;
}

/// Integrated from change to change of the delayed command, between which it is constant.
double reference_position(const HeldCommands& commands, double delay, double end) {
  std::vector<double> breaks{0.0};
  for (const double time : commands.times)
    if (time + delay > 0.0 && time + delay < end) breaks.push_back(time + delay);
  breaks.push_back(end);
  ReferenceState state{0.0, 0.0};
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double force = commands.delayed((breaks[i - 1] + breaks[i]) / 2, delay);
    const Derivative motion = [force](const ReferenceState& x, ReferenceState& dx, double) {
      dx = {x[1], (force - kSpring * x[0]) / kMass};
    };
    state = integrate_smooth(motion, state, {breaks[i - 1], breaks[i]}).back();
  }
  return state[0];
}

TEST(CommandDelay, OfTwoAndAHalfStepsAgreesWithAnIndependentIntegration) {
  constexpr double kEnd = 0.7, kDelay = 2.5 * kStep;
  const HeldCommands commands;
  const double expected = reference_position(commands, kDelay, kEnd);
  // The delay stays while the step is halved: 2.5, 5 and 10 steps.
  const auto error = [&](double step) {
    SimulationRun run = oscillator(commands, step);
    run.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {kDelay});
    return run.last("position", kEnd) - expected;
  };
  constexpr double kPositionError = 3e-3;  // m of 0.1
  expect_convergence(error, kStep, kPositionError);
}

TEST(CommandDelay, MovesTheMotionByTheDelayExactly) {
  // Without a spring the impulse counts, which the mean over the step keeps exactly.
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  SimulationRun run(robot, kStep);
  run.command("motor", {0.0, 0.1, 0.3}, {0.0, 6.0, -2.0}, Hold::zero_order);
  run.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {2.5 * kStep});
  const double expected = (6.0 * 0.2 - 2.0 * (0.2 - 2.5 * kStep)) / kMass;
  EXPECT_NEAR(run.last("velocity", 0.5), expected, kRounding);
}

TEST(CommandDelay, IsTheSameAsTheActuatorsOwnDelay) {
  const HeldCommands commands;
  SimulationRun by_effect = oscillator(commands, kStep), by_spec = oscillator(commands, kStep);
  by_effect.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {2.5 * kStep});
  by_spec.structure.robot.actuators[0].delay = 2.5 * kStep;
  EXPECT_NEAR(by_effect.last("position", 0.7), by_spec.last("position", 0.7), kRounding);
}

TEST(CommandDelay, OfZeroChangesNothing) {
  const HeldCommands commands;
  SimulationRun with = oscillator(commands, kStep);
  with.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {0.0});
  EXPECT_EQ(with.last("position", 0.7), oscillator(commands, kStep).last("position", 0.7));
}

TEST(CommandDelay, TakesItsDelayFromAFreeParameter) {
  const HeldCommands commands;
  SimulationRun given = oscillator(commands, kStep), free = oscillator(commands, kStep);
  given.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {2.5 * kStep});
  free.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {0.0});
  free.structure.parameters = {{"effect.e0.delay", 0.0, 0.02}};
  free.parameters = {2.5 * kStep};
  EXPECT_EQ(free.last("position", 0.7), given.last("position", 0.7));
}

TEST(CommandDelay, ContinuesBitIdenticallyAfterARestore) {
  const HeldCommands commands;
  SimulationRun run = oscillator(commands, kStep);
  run.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {2.5 * kStep});
  // The middle lies 2 ms after a change of the command, which is then still under way.
  expect_same_bits_after_restore(run, {0.0, 0.1, 0.242, 0.243, 0.244, 0.5, 0.7}, 2);
}

}  // namespace
}  // namespace lacuna::command_delay_test

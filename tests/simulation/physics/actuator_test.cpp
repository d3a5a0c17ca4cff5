#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna::actuator_test {
namespace {

constexpr double kMass = 2.0;  // kg
constexpr double kStep = 1e-3;

RobotSpec driven(ActuatorKind kind, double kp, double ki, double kd) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.actuators[0].kind = kind;
  robot.actuators[0].kp = kp;
  robot.actuators[0].ki = ki;
  robot.actuators[0].kd = kd;
  return robot;
}

/// The velocity that a constant command gives to the free mass within a second, times the mass.
double impulse_of_constant_command(const RobotSpec& robot, double command) {
  return kMass * SimulationRun(robot, kStep).command("motor", command).last("velocity", 1.0);
}

TEST(ForceActuator, AppliesTheCommandWithGainAndThenOffset) {
  RobotSpec robot = driven(ActuatorKind::force, 0, 0, 0);
  EXPECT_NEAR(impulse_of_constant_command(robot, 3.0), 3.0, kRounding);
  robot.actuators[0].gain = 2.0;
  robot.actuators[0].offset = -0.5;
  EXPECT_NEAR(impulse_of_constant_command(robot, 3.0), 5.5, kRounding);
  EXPECT_NEAR(impulse_of_constant_command(robot, -3.0), -6.5, kRounding);
}

TEST(ForceActuator, KeepsToItsLimits) {
  RobotSpec robot = driven(ActuatorKind::force, 0, 0, 0);
  robot.actuators[0].force_limit = 4.0;
  EXPECT_NEAR(impulse_of_constant_command(robot, 5.0), 4.0, kRounding);
  EXPECT_NEAR(impulse_of_constant_command(robot, -5.0), -4.0, kRounding);
  robot.actuators[0].command_lower = -1.0;
  robot.actuators[0].command_upper = 2.5;
  EXPECT_NEAR(impulse_of_constant_command(robot, 5.0), 2.5, kRounding);
  EXPECT_NEAR(impulse_of_constant_command(robot, -5.0), -1.0, kRounding);
}

TEST(ForceActuator, DelayedHeldCommandHasItsExactImpulse) {
  for (const double steps : {0.0, 1.0, 2.0, 2.5, 7.3}) {
    RobotSpec robot = driven(ActuatorKind::force, 0, 0, 0);
    robot.actuators[0].delay = steps * kStep;
    SimulationRun run(robot, kStep);
    run.command("motor", {0.0, 0.1, 0.3}, {0.0, 6.0, -2.0}, Hold::zero_order);
    const double expected = (6.0 * 0.2 - 2.0 * (0.2 - steps * kStep)) / kMass;
    EXPECT_NEAR(run.last("velocity", 0.5), expected, kRounding) << steps << " steps";
  }
}

TEST(ForceActuator, CommandSampledBetweenStepsHasItsExactImpulse) {
  SimulationRun run(driven(ActuatorKind::force, 0, 0, 0), kStep);
  run.command("motor", {0.0, 0.10037, 0.30081}, {0.0, 6.0, 0.0}, Hold::zero_order);
  EXPECT_NEAR(run.last("velocity", 0.5), 6.0 * (0.30081 - 0.10037) / kMass, kRounding);
}

TEST(ForceActuator, FirstOrderHoldHasItsExactImpulse) {
  RobotSpec robot = driven(ActuatorKind::force, 0, 0, 0);
  robot.actuators[0].delay = 2.5 * kStep;
  SimulationRun run(robot, kStep);
  run.command("motor", {0.0, 0.1003, 0.3}, {0.0, 6.0, 0.0}, Hold::first_order);
  EXPECT_NEAR(run.last("velocity", 0.5), 0.5 * 6.0 * 0.3 / kMass, kRounding);
}

TEST(ForceActuator, DelayBeforeTheStartReadsTheFirstCommand) {
  RobotSpec robot = driven(ActuatorKind::force, 0, 0, 0);
  robot.actuators[0].delay = 0.05;
  SimulationRun run(robot, kStep);
  run.command("motor", {0.0, 0.1}, {6.0, 0.0}, Hold::zero_order);
  EXPECT_NEAR(run.last("velocity", 0.5), 6.0 * 0.15 / kMass, kRounding);
}

TEST(ForceActuator, DelayRoundedToStepsActsInWholeSteps) {
  RobotSpec robot = driven(ActuatorKind::force, 0, 0, 0);
  robot.actuators[0].delay = 2.4 * kStep;
  SimulationRun run(robot, kStep);
  run.engine.delay_rounding = DelayRounding::step;
  run.command("motor", {0.0, 0.1}, {0.0, 6.0}, Hold::zero_order);
  EXPECT_NEAR(run.last("velocity", 0.5), 6.0 * (0.4 - 2.0 * kStep) / kMass, kRounding);
}

TEST(VelocityServo, ApproachesTheCommandExponentially) {
  constexpr double kGain = 8.0, kEnd = 0.5;
  const double expected = 1.5 * (1.0 - std::exp(-kGain / kMass * kEnd));
  const auto error = [&](double step) {
    SimulationRun run(driven(ActuatorKind::velocity_servo, 0, 0, kGain), step);
    return run.command("motor", 1.5).last("velocity", kEnd) - expected;
  };
  expect_convergence(error, kStep, 5e-3);
}

TEST(VelocityServo, AcceleratesAtItsForceLimit) {
  RobotSpec robot = driven(ActuatorKind::velocity_servo, 0, 0, 1e4);
  robot.actuators[0].force_limit = 3.0;
  SimulationRun run(robot, kStep);
  run.command("motor", -2.0);
  EXPECT_NEAR(run.last("velocity", 0.5), -3.0 / kMass * 0.5, 1e-6);
  EXPECT_NEAR(run.last("velocity", 2.0), -2.0, 1e-6);
}

/// A servo's equation of motion, integrated apart: (q, v, ∫(c − q)dt); c(t) = slope·t + start.
struct ServoReference {
  double kp = 0.0, ki = 0.0, kd = 0.0;
  double command = 0.0, command_rate = 0.0;
  bool damps_error = false;  ///< kd acts on the error's rate instead of the velocity
  double limit = kInfinity;

  ReferenceState after(double end) const {
    const Derivative motion = [this](const ReferenceState& x, ReferenceState& dx, double t) {
      const double error = command + command_rate * t - x[0];
      const double rate = damps_error ? command_rate - x[1] : -x[1];
      dx = {x[1], std::clamp(kp * error + kd * rate + ki * x[2], -limit, limit) / kMass, error};
    };
    return integrate_in_steps(motion, {0.0, 0.0, 0.0}, {0.0, end}, 1e-4).back();
  }
};

TEST(PositionServo, AgreesWithItsEquationOfMotion) {
  constexpr double kEnd = 0.6;
  const double expected = ServoReference{.kp = 120.0, .kd = 9.0, .command = 0.4}.after(kEnd)[0];
  const auto error = [&](double step) {
    SimulationRun run(driven(ActuatorKind::position_servo, 120.0, 0, 9.0), step);
    return run.command("motor", 0.4).last("position", kEnd) - expected;
  };
  expect_convergence(error, kStep, 5e-3);
}

TEST(PositionServo, KeepsToItsForceLimit) {
  constexpr double kEnd = 0.6, kLimit = 6.0;
  RobotSpec robot = driven(ActuatorKind::position_servo, 120.0, 0, 9.0);
  robot.actuators[0].force_limit = kLimit;
  const double expected = ServoReference{.kp = 120.0, .kd = 9.0, .command = 0.4, .limit = kLimit}.after(kEnd)[0];
  const auto error = [&](double step) {
    return SimulationRun(robot, step).command("motor", 0.4).last("position", kEnd) - expected;
  };
  EXPECT_LE(std::abs(error(kStep)), 5e-3);
  EXPECT_LE(std::abs(error(kStep / 8)), 5e-3 / 6);
}

TEST(PositionServo, IsStableWhenStiff) {
  SimulationRun run(driven(ActuatorKind::position_servo, 1e8, 0, 1e4), kStep);
  EXPECT_NEAR(run.command("motor", 0.4).last("position", 1.0), 0.4, 1e-6);
}

TEST(PositionServo, DrivesAHingeOverSeveralTurns) {
  for (const double target : {20.0, -20.0}) {
    RobotSpec robot = one_joint(JointKind::hinge, 0.1);
    robot.actuators[0].kind = ActuatorKind::position_servo;
    robot.actuators[0].kp = 20.0;
    robot.actuators[0].kd = 3.0;
    EXPECT_NEAR(SimulationRun(robot, kStep).command("motor", target).last("position", 4.0), target, 1e-4);
  }
}

TEST(Pid, AgreesWithItsEquationOfMotion) {
  constexpr double kEnd = 0.8;
  const ServoReference reference{
      .kp = 90.0, .ki = 150.0, .kd = 12.0, .command = 0.0, .command_rate = 0.5, .damps_error = true};
  const double expected = reference.after(kEnd)[0];
  const auto error = [&](double step) {
    SimulationRun run(driven(ActuatorKind::pid, 90.0, 150.0, 12.0), step);
    run.command("motor", {0.0, 1.0}, {0.0, 0.5}, Hold::first_order);
    return run.last("position", kEnd) - expected;
  };
  expect_convergence(error, kStep, 5e-3);
}

TEST(Pid, RemovesTheOffsetThatAConstantLoadLeaves) {
  for (const double ki : {0.0, 200.0}) {
    RobotSpec robot = driven(ActuatorKind::pid, 100.0, ki, 20.0);
    robot.joints[0].force = -10.0;
    const double remaining = SimulationRun(robot, kStep).command("motor", 0.5).last("position", 8.0) - 0.5;
    EXPECT_NEAR(remaining, ki > 0.0 ? 0.0 : -0.1, 1e-4);
  }
}

}  // namespace
}  // namespace lacuna::actuator_test

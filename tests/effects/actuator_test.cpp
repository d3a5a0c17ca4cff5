#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

/// What effects make of commands, on a mass without friction: its velocity is the integral of the force.
namespace lacuna::actuator_test {
namespace {

constexpr double kMass = 2.0;   // kg
constexpr double kStep = 1e-3;  // s

const PhysicalEffect& effect(const std::string& name) { return built_catalog().get<PhysicalEffect>(name); }

SimulationRun mass_with(const std::string& name, std::vector<double> values, double step = kStep) {
  SimulationRun run(one_joint(JointKind::slider, kMass), step);
  run.place(effect(name), ElementKind::actuator, {0}, std::move(values));
  return run;
}

/// kMass times the velocity that a command of `height` from time 0 on leads to at `end`, N·s.
double impulse(SimulationRun run, double height, double end) {
  return kMass * run.command("motor", height).last("velocity", end);
}

TEST(ActuatorLag, FollowsAStepExponentially) {
  constexpr double kTime = 0.07, kEnd = 0.3;
  SimulationRun run = mass_with("actuator_lag", {kTime});
  run.command("motor", {0.0, 0.1}, {0.0, 3.0}, Hold::zero_order);
  const double passed = kEnd - 0.1;
  const double expected = 3.0 * (passed - kTime * (1.0 - std::exp(-passed / kTime)));
  EXPECT_NEAR(kMass * run.last("velocity", kEnd), expected, kRounding);
}

TEST(ActuatorLag, IsExactWhateverTheStep) {
  SimulationRun fine = mass_with("actuator_lag", {0.02}, 1e-4), coarse = mass_with("actuator_lag", {0.02}, 1e-2);
  for (SimulationRun* run : {&fine, &coarse}) run->command("motor", {0.0, 0.1}, {1.0, -2.0}, Hold::zero_order);
  EXPECT_NEAR(fine.last("velocity", 0.3), coarse.last("velocity", 0.3), kRounding);
}

TEST(SlewRateLimit, RampsToTheCommand) {
  SimulationRun run = mass_with("slew_rate_limit", {20.0});  // N/s
  run.command("motor", {0.0, 0.1}, {0.0, 3.0}, Hold::zero_order);
  constexpr double kRamp = 3.0 / 20.0, kEnd = 0.4;
  EXPECT_NEAR(kMass * run.last("velocity", kEnd), 3.0 * (kEnd - 0.1 - 0.5 * kRamp), kRounding);
}

TEST(SlewRateLimit, EndsItsRampWithinAStep) {
  SimulationRun run = mass_with("slew_rate_limit", {20.0}, 0.01);
  run.command("motor", {0.0, 0.1}, {0.0, 0.3}, Hold::zero_order);  // 1.5 steps
  EXPECT_NEAR(kMass * run.last("velocity", 0.2), 0.3 * (0.1 - 0.0075), kRounding);
}

TEST(DeadZone, TakesItsWidthOffTheCommand) {
  EXPECT_NEAR(impulse(mass_with("dead_zone", {0.5}), 2.0, 0.4), 1.5 * 0.4, kRounding);
  EXPECT_NEAR(impulse(mass_with("dead_zone", {0.5}), -2.0, 0.4), -1.5 * 0.4, kRounding);
  EXPECT_EQ(impulse(mass_with("dead_zone", {0.5}), 0.5, 0.4), 0.0);
}

TEST(CommandBend, AddsTheSquareOfTheCommand) {
  EXPECT_NEAR(impulse(mass_with("command_bend", {0.3}), 2.0, 0.4), 3.2 * 0.4, kRounding);
  EXPECT_NEAR(impulse(mass_with("command_bend", {0.3}), -2.0, 0.4), -3.2 * 0.4, kRounding);
  EXPECT_NEAR(impulse(mass_with("command_bend", {-0.1}), 2.0, 0.4), 1.6 * 0.4, kRounding);
}

TEST(CommandBend, NeverGivesLessForMore) {
  EXPECT_NEAR(impulse(mass_with("command_bend", {-0.5}), 1.0, 0.4), 0.5 * 0.4, kRounding);
  EXPECT_NEAR(impulse(mass_with("command_bend", {-0.5}), 3.0, 0.4), 0.5 * 0.4, kRounding);
}

TEST(CommandQuantisation, RoundsTheCommandToWholeSteps) {
  EXPECT_NEAR(impulse(mass_with("command_quantisation", {0.7}), 2.0, 0.4), 2.1 * 0.4, kRounding);
  EXPECT_NEAR(impulse(mass_with("command_quantisation", {0.7}), -2.0, 0.4), -2.1 * 0.4, kRounding);
  EXPECT_NEAR(impulse(mass_with("command_quantisation", {0.7}), 0.4, 0.4), 0.7 * 0.4, kRounding);
  EXPECT_EQ(impulse(mass_with("command_quantisation", {0.7}), 0.3, 0.4), 0.0);
}

/// Behind the actuator's own gain, before every other effect on commands and before the limits, whatever the list's
/// order.
TEST(CommandQuantisation, HasItsPlaceAmongTheStages) {
  SimulationRun run = mass_with("dead_zone", {0.5});
  run.place(effect("command_quantisation"), ElementKind::actuator, {0}, {0.7});
  run.structure.robot.actuators[0].gain = 0.5;
  EXPECT_NEAR(impulse(run, 4.0, 0.4), (2.1 - 0.5) * 0.4, kRounding);
  run.structure.robot.actuators[0].command_upper = 1.5;
  EXPECT_NEAR(impulse(run, 4.0, 0.4), 1.5 * 0.4, kRounding);
}

TEST(TorqueGain, MultipliesTheForce) {
  EXPECT_NEAR(impulse(mass_with("torque_gain", {0.8}), 2.0, 0.4), 1.6 * 0.4, kRounding);
}

TEST(TorqueGain, MultipliesTheGainsOfAServo) {
  const auto servo = [] {
    SimulationRun run(one_joint(JointKind::slider, kMass), kStep);
    ActuatorSpec& motor = run.structure.robot.actuators[0];
    motor.kind = ActuatorKind::position_servo;
    motor.kp = 30.0;
    motor.kd = 2.0;
    run.command("motor", 0.2);
    return run;
  };
  SimulationRun with = servo(), without = servo();
  with.place(effect("torque_gain"), ElementKind::actuator, {0}, {1.5});
  without.structure.robot.actuators[0].kp *= 1.5;
  without.structure.robot.actuators[0].kd *= 1.5;
  EXPECT_DOUBLE_EQ(with.last("position", 0.7), without.last("position", 0.7));
}

TEST(CommandOffset, AddsToTheCommand) {
  EXPECT_NEAR(impulse(mass_with("command_offset", {-0.3}), 2.0, 0.4), 1.7 * 0.4, kRounding);
}

TEST(TorqueSaturation, CutsTheForceOffAtItsLimit) {
  EXPECT_NEAR(impulse(mass_with("torque_saturation", {1.2}), 2.0, 0.4), 1.2 * 0.4, kRounding);
  EXPECT_NEAR(impulse(mass_with("torque_saturation", {1.2}), -0.7, 0.4), -0.7 * 0.4, kRounding);
}

TEST(TorqueSaturation, LeavesALowerLimitOfTheRobot) {
  SimulationRun run = mass_with("torque_saturation", {1.2});
  run.structure.robot.actuators[0].force_limit = 0.5;
  EXPECT_NEAR(impulse(run, 2.0, 0.4), 0.5 * 0.4, kRounding);
}

/// At half the step; what it is of velocities of 1 m/s.
void expect_fourth_of_error(const std::function<double(double step)>& error) {
  EXPECT_LT(std::abs(error(kStep)), 1e-6);
  EXPECT_NEAR(error(kStep) / error(0.5 * kStep), 4.0, 0.4);
}

TEST(TorqueSpeedLine, ApproachesItsNoLoadSpeedExponentially) {
  constexpr double kStall = 3.0, kNoLoad = 1.5, kEnd = 1.0;
  const double expected = kNoLoad * (1.0 - std::exp(-kStall / (kMass * kNoLoad) * kEnd));
  const auto error = [&](double step) {
    return mass_with("torque_speed_line", {kStall, kNoLoad}, step).command("motor", 100.0).last("velocity", kEnd) -
           expected;
  };
  expect_fourth_of_error(error);
}

TEST(TorqueSpeedLine, BrakesHarderThanItDrives) {
  SimulationRun run = mass_with("torque_speed_line", {3.0, 1.5});
  run.command("motor", -100.0).from({0.0}, {1.5});
  EXPECT_NEAR(run.last("velocity", kStep), 1.5 - 6.0 / kMass * kStep, kRounding);
}

TEST(ThermalFade, AgreesWithAnIndependentIntegration) {
  constexpr double kFade = 0.2, kTime = 0.5, kEnd = 1.5;
  const auto motion_under = [](double u) -> Derivative {
    return [u](const ReferenceState& x, ReferenceState& dx, double) {
      dx = {u / (1.0 + x[1]) / kMass, (kFade * u * u - x[1]) / kTime};
    };
  };
  const ReferenceState warm = integrate_in_steps(motion_under(2.0), {0.0, 0.0}, {0.0, 1.0}, 1e-4).back();
  const double expected = integrate_in_steps(motion_under(0.5), warm, {1.0, kEnd}, 1e-4).back()[0];
  const auto error = [&](double step) {
    SimulationRun run = mass_with("thermal_fade", {kFade, kTime}, step);
    return run.command("motor", {0.0, 1.0}, {2.0, 0.5}, Hold::zero_order).last("velocity", kEnd) - expected;
  };
  expect_fourth_of_error(error);
}

TEST(ForceEffects, RefuseServos) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.actuators[0].kind = ActuatorKind::position_servo;
  const std::vector<int> elements = {0};
  const std::vector<double> values = {1.0, 1.0};
  for (const char* name : {"thermal_fade", "torque_speed_line"})
    EXPECT_THAT(([&] {
                  effect(name).amend(robot, {values, elements, ElementKind::actuator, kStep});
                }),
                testing::ThrowsMessage<Error>(testing::HasSubstr("actuator.motor is a servo")));
}

/// A rotor that drives a mass through play; the state is (rotor, mass, their velocities).
TEST(Backlash, AgreesWithAnIndependentIntegration) {
  constexpr double kGap = 0.02, kStiffness = 300.0, kDamping = 2.0, kRotor = 0.4, kEnd = 0.9;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double time) {
    const double push = time < 0.4 ? 1.0 : -1.2;
    const double twist = x[0] - x[1];
    const double stretch = twist > 0.5 * kGap ? twist - 0.5 * kGap : twist < -0.5 * kGap ? twist + 0.5 * kGap : 0.0;
    const double passed_on = stretch == 0.0 ? 0.0 : kStiffness * stretch + kDamping * (x[2] - x[3]);
    dx = {x[2], x[3], (push - passed_on) / kRotor, passed_on / kMass};
  };
  const double expected = integrate_in_steps(motion, {0, 0, 0, 0}, {0.0, 0.4, kEnd}, 1e-5).back()[1];
  const auto error = [&](double step) {
    SimulationRun run(one_joint(JointKind::slider, kMass), step);
    run.structure.robot.actuators[0].transmission.rotor_inertia = kRotor;
    run.place(effect("backlash"), ElementKind::actuator, {0}, {kGap, kStiffness, kDamping});
    return run.command("motor", {0.0, 0.4}, {1.0, -1.2}, Hold::zero_order).last("position", kEnd) - expected;
  };
  EXPECT_LE(std::abs(error(1e-3)), 1e-3);  // m of 0.05
  EXPECT_LE(std::abs(error(1e-4)), 1e-4);
}

}  // namespace
}  // namespace lacuna::actuator_test

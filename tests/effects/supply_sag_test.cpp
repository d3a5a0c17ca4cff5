#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

/// What a sagging supply leaves of the forces of actuators of each kind, on a mass without friction.
namespace lacuna::supply_sag_test {
namespace {

constexpr double kMass = 2.0, kSag = 0.25, kStep = 1e-3;  // kg, 1/N, s

/// Of the motors on a voltage: torque constant, resistance, share of back-EMF, supply, largest duty.
constexpr double kConstant = 0.4, kResistance = 0.5, kBackEmf = 0.9, kSupply = 8.0, kDuty = 0.75;
constexpr double kPerVolt = kConstant / kResistance, kDrag = kBackEmf * kConstant * kPerVolt;

SimulationRun mass_on(ActuatorKind kind, double step = kStep) {
  SimulationRun run(one_joint(JointKind::slider, kMass), step);
  ActuatorSpec& motor = run.structure.robot.actuators[0];
  motor.kind = kind;
  motor.motor = {.torque_constant = kConstant,
                 .resistance = kResistance,
                 .back_emf = kBackEmf,
                 .supply = kSupply,
                 .duty_limit = kDuty,
                 .gain_unit = 1.0};
  run.place(built_catalog().get<PhysicalEffect>("supply_sag"), ElementKind::actuator, {0}, {kSag});
  return run;
}

TEST(SupplySag, TakesMoreOffLargerForces) {
  for (const double force : {0.5, 2.0, -8.0})
    EXPECT_NEAR(mass_on(ActuatorKind::force).command("motor", force).last("velocity", 0.4),
                force / (1.0 + kSag * std::abs(force)) / kMass * 0.4, kRounding);
}

TEST(SupplySag, ActsOnWhatTheLimitLeaves) {
  SimulationRun run = mass_on(ActuatorKind::force);
  run.structure.robot.actuators[0].force_limit = 1.2;
  EXPECT_NEAR(run.command("motor", 2.0).last("velocity", 0.4), 1.2 / (1.0 + kSag * 1.2) / kMass * 0.4, kRounding);
}

/// A supply with the resistance sag·V0·kt, whose current is the motor's: V = V0 − Rs·i and kt·i = F.
TEST(SupplySag, IsAnInternalResistanceOfTheSupply) {
  const double inner = kSag * kSupply * kConstant, duty = kDuty;
  const double current = duty * kSupply / (kResistance + duty * inner);  // at rest, of U = duty·V
  SimulationRun run = mass_on(ActuatorKind::voltage, 1e-5);
  run.command("motor", duty * kSupply);
  EXPECT_NEAR(run.last("velocity", 1e-5), kConstant * current / kMass * 1e-5, 1e-9);
}

void expect_agreement(const SimulationRun& coarse, const SimulationRun& fine, double expected) {
  const double error = coarse.last("position", 1.2) - expected;
  EXPECT_LT(std::abs(error), 1e-4);
  EXPECT_NEAR(error / (fine.last("position", 1.2) - expected), 4.0, 0.5);
}

TEST(SupplySag, OfAVoltageAgreesWithAnIndependentIntegration) {
  constexpr double kVoltage = 4.0;  // against the motion first: then the motor feeds the supply
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    const double at_rest = kPerVolt * kVoltage;
    dx = {x[1], (at_rest - kDrag * x[1]) / (1.0 + kSag * at_rest) / kMass};
  };
  const double expected = integrate_smooth(motion, {0.0, -2.0}, {0.0, 1.2}).back()[0];
  const auto run = [](double step) {
    return mass_on(ActuatorKind::voltage, step).command("motor", kVoltage).from({0.0}, {-2.0});
  };
  expect_agreement(run(4e-3), run(2e-3), expected);
}

/// `limit`: of the force at rest.
double servo_expected(double kp, double kd, double limit, double drag, double goal) {
  const Derivative motion = [=](const ReferenceState& x, ReferenceState& dx, double) {
    const double at_rest = std::clamp(kp * (goal - x[0]) - kd * x[1], -limit, limit);
    dx = {x[1], (at_rest - drag * x[1]) / (1.0 + kSag * std::abs(at_rest)) / kMass};
  };
  return integrate_in_steps(motion, {0.0, -1.0}, {0.0, 1.2}, 1e-5).back()[0];
}

TEST(SupplySag, OfAVoltageServoAgreesWithAnIndependentIntegration) {
  constexpr double kKp = 3.0, kKd = 0.2, kGoal = 0.7;  // duty per m and m/s
  const double per_count = kSupply * kPerVolt;
  const auto run = [&](double step) {
    SimulationRun made = mass_on(ActuatorKind::voltage_servo, step);
    made.structure.robot.actuators[0].kp = kKp;
    made.structure.robot.actuators[0].kd = kKd;
    return made.command("motor", kGoal).from({0.0}, {-1.0});
  };
  const double expected = servo_expected(kKp * per_count, kKd * per_count, kDuty * per_count, kDrag, kGoal);
  for (const double step : {4e-3, 1e-3})  // the end of saturation falls within a step
    EXPECT_NEAR(run(step).last("position", 1.2), expected, 6.0 * step * step);
}

TEST(SupplySag, OfAPositionServoAgreesWithAnIndependentIntegration) {
  constexpr double kKp = 20.0, kKd = 2.0, kGoal = 0.3;
  const auto run = [&](double step) {
    SimulationRun made = mass_on(ActuatorKind::position_servo, step);
    made.structure.robot.actuators[0].kp = kKp;
    made.structure.robot.actuators[0].kd = kKd;
    return made.command("motor", kGoal).from({0.0}, {-1.0});
  };
  const double expected = servo_expected(kKp, kKd, 1e9, 0.0, kGoal);
  expect_agreement(run(4e-3), run(2e-3), expected);
  SimulationRun other = run(1e-4);
  other.engine.engine = "ode";
  EXPECT_NEAR(other.last("position", 1.2), expected, 1e-3);
}

TEST(SupplySag, RefusesAnImposedMotion) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.actuators[0].kind = ActuatorKind::motion;
  const std::vector<int> elements = {0};
  const std::vector<double> values = {0.1};
  EXPECT_THAT(([&] {
                built_catalog()
                    .get<PhysicalEffect>("supply_sag")
                    .amend(robot, {values, elements, ElementKind::actuator, kStep});
              }),
              testing::ThrowsMessage<Error>(testing::HasSubstr("actuator.motor imposes a motion")));
}

}  // namespace
}  // namespace lacuna::supply_sag_test

#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::load_friction_test {
namespace {

constexpr double kMass = 1.5, kSpring = 25.0, kConstant = -1.0, kRatio = 0.3;

/// The motor's force: up, down past zero, and up again.
const std::vector<double> kTimes{0.0, 0.6, 1.4, 2.0};
const std::vector<double> kForces{0.0, 6.0, -4.0, 2.0};

double force_at(double time) {
  for (std::size_t i = 1; i < kTimes.size(); ++i)
    if (time <= kTimes[i])
      return kForces[i - 1] + (kForces[i] - kForces[i - 1]) * (time - kTimes[i - 1]) / (kTimes[i] - kTimes[i - 1]);
  return kForces.back();
}

SimulationRun driven(double step) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.joints[0].stiffness = kSpring;
  robot.joints[0].force = kConstant;
  SimulationRun run(robot, step);
  run.command("motor", kTimes, kForces, Hold::first_order);
  run.place(built_catalog().get<PhysicalEffect>("load_friction"), ElementKind::joint, {0}, {kRatio});
  return run;
}

FrictionSystem reference() {
  return {.inertia = kMass,
          .force = [](double time, double q, double) { return force_at(time) + kConstant - kSpring * q; },
          .friction_max = [](double time, double, double) { return kRatio * std::abs(force_at(time)); }};
}

TEST(LoadFriction, AgreesWithAnIndependentIntegration) {
  const std::vector<double> times = evenly_spaced(2.0, 10);
  const std::vector<CoordinateState> expected = integrate_with_friction(reference(), {}, times, 2e-5);
  const auto largest_error = [&](double step) {
    const Eigen::VectorXd position = column(driven(step).run(times).readings, "position");
    double largest = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i)
      largest = std::max(largest, std::abs(position(static_cast<Eigen::Index>(i)) - expected[i].q));
    return largest;
  };
  constexpr double kPositionError = 3e-3;  // m of 0.3; stops and breaks away several times
  EXPECT_LE(largest_error(1e-3), kPositionError);
  EXPECT_LE(largest_error(1.25e-4), kPositionError / 6);
}

TEST(LoadFriction, HoldsWhatItsOwnLoadCanHold) {
  // 0.4 of the motor's force is friction; a counterforce of 0.7 of it leaves 0.3, which sticks.
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  for (const double load : {2.0, 20.0}) {
    robot.joints[0].force = -0.7 * load;
    SimulationRun run(robot);
    run.command("motor", load)
        .place(built_catalog().get<PhysicalEffect>("load_friction"), ElementKind::joint, {0}, {0.4});
    EXPECT_NEAR(run.last("position", 1.0), 0.0, 1e-7);
    run.structure.effects[0].values = {0.2};
    EXPECT_NEAR(run.last("velocity", 1.0), 0.1 * load / kMass, 1e-5);
  }
}

TEST(LoadFriction, ContinuesBitIdenticallyAfterARestore) {
  SimulationRun run = driven(1e-3);
  run.structure.robot.actuators[0].delay = 0.0123;
  expect_same_bits_after_restore(run, evenly_spaced(2.0, 50), 23);
}

TEST(LoadFriction, OfAServoContinuesBitIdenticallyAfterARestore) {
  SimulationRun run = driven(1e-3);
  run.structure.robot.actuators[0].kind = ActuatorKind::pid;
  run.structure.robot.actuators[0].kp = 60.0;
  run.structure.robot.actuators[0].ki = 80.0;
  run.structure.robot.actuators[0].kd = 6.0;
  run.structure.robot.actuators[0].force_limit = 30.0;
  expect_same_bits_after_restore(run, evenly_spaced(2.0, 50), 23);
}

}  // namespace
}  // namespace lacuna::load_friction_test

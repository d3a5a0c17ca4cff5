#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna::gear_efficiency_test {
namespace {

constexpr double kMass = 1.5, kSpring = 25.0, kConstant = -1.0, kDrive = 0.2, kBackdrive = 0.7;

const PhysicalEffect& effect() { return built_catalog().get<PhysicalEffect>("gear_efficiency"); }

/// The motor's force: up, down past zero, and up again.
const std::vector<double> kTimes{0.0, 0.6, 1.4, 2.0};
const std::vector<double> kForces{0.0, 6.0, -4.0, 2.0};

double force_at(double time) {
  for (std::size_t i = 1; i < kTimes.size(); ++i)
    if (time <= kTimes[i])
      return kForces[i - 1] + (kForces[i] - kForces[i - 1]) * (time - kTimes[i - 1]) / (kTimes[i] - kTimes[i - 1]);
  return kForces.back();
}

SimulationRun driven(double step, double drive, double backdrive) {
  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.joints[0].stiffness = kSpring;
  robot.joints[0].force = kConstant;
  SimulationRun run(robot, step);
  run.command("motor", kTimes, kForces, Hold::first_order);
  run.place(effect(), ElementKind::joint, {0}, {drive, backdrive});
  return run;
}

double force_without_friction(double time, double q) { return force_at(time) + kConstant - kSpring * q; }

/// At rest it is the motion to which the forces push that the motor drives or brakes.
double friction_limit(double time, double q, double v) {
  const double motion = v != 0.0 ? v : force_without_friction(time, q);
  return (force_at(time) * motion > 0.0 ? kDrive : kBackdrive) * std::abs(force_at(time));
}

TEST(GearEfficiency, AgreesWithAnIndependentIntegration) {
  const FrictionSystem system{kMass, [](double time, double q, double) { return force_without_friction(time, q); },
                              friction_limit};
  const std::vector<double> times = evenly_spaced(2.0, 10);
  const std::vector<CoordinateState> expected = integrate_with_friction(system, {}, times, 2e-5);
  const auto largest_error = [&](double step) {
    const Eigen::VectorXd position = column(driven(step, kDrive, kBackdrive).run(times).readings, "position");
    double largest = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i)
      largest = std::max(largest, std::abs(position(static_cast<Eigen::Index>(i)) - expected[i].q));
    return largest;
  };
  constexpr double kPositionError = 1e-4;  // m of 0.3; stops and breaks away several times
  EXPECT_LE(largest_error(1e-3), kPositionError);
  EXPECT_LE(largest_error(2.5e-4), kPositionError / 10.0);
}

TEST(GearEfficiency, WithEqualRatiosIsLoadFriction) {
  SimulationRun load = driven(1e-3, 0.3, 0.3);
  load.structure.effects.clear();
  load.place(built_catalog().get<PhysicalEffect>("load_friction"), ElementKind::joint, {0}, {0.3});
  EXPECT_DOUBLE_EQ(driven(1e-3, 0.3, 0.3).last("position", 2.0), load.last("position", 2.0));
}

/// A motor that pushes up against a weight: it lifts a light one, holds a heavier one, and is driven back by one that
/// is more than 1 + backdrive_ratio times its force.
TEST(GearEfficiency, LiftsHoldsAndIsDrivenBack) {
  constexpr double kPush = 5.0, kEnd = 0.4;
  const auto speed_under = [&](double weight) {
    RobotSpec robot = one_joint(JointKind::slider, kMass);
    robot.joints[0].force = -weight;
    SimulationRun run(robot);
    run.command("motor", kPush).place(effect(), ElementKind::joint, {0}, {kDrive, kBackdrive});
    return run.last("velocity", kEnd);
  };
  constexpr double kError = 1e-6;
  EXPECT_NEAR(speed_under(3.5), (kPush * (1.0 - kDrive) - 3.5) / kMass * kEnd, kError);
  EXPECT_NEAR(speed_under(4.1), 0.0, kError);
  EXPECT_NEAR(speed_under(8.4), 0.0, kError);
  EXPECT_NEAR(speed_under(9.5), (kPush * (1.0 + kBackdrive) - 9.5) / kMass * kEnd, kError);
}

TEST(GearEfficiency, ContinuesBitIdenticallyAfterARestore) {
  SimulationRun run = driven(1e-3, kDrive, kBackdrive);
  run.structure.robot.actuators[0].delay = 0.0123;
  expect_same_bits_after_restore(run, evenly_spaced(2.0, 50), 23);
}

}  // namespace
}  // namespace lacuna::gear_efficiency_test

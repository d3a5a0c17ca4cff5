#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace lacuna::articulated_energy_test {
namespace {

constexpr double kMass = 1.0, kLength = 1.0, kInertia = 0.1;
constexpr int kStepsInPeriod = 100;

SimulationRun articulated(const RobotSpec& robot, double step) {
  SimulationRun run(robot, step);
  run.engine.engine = "articulated";
  return run;
}

/// Of a swing from 90°, by the arithmetic-geometric mean.
double period_from_90_degrees() {
  double a = 1.0, b = std::cos(0.25 * std::numbers::pi);
  while (std::abs(a - b) > 1e-15) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2.0 * std::numbers::pi / (a * std::sqrt(pendulum_rate(kMass, kLength, kInertia)));
}

/// Mean over a period, of the swing's energy at its start.
double mean_energy(const SimulationRun& run, int period, double step) {
  std::vector<double> times{0.0};
  for (int i = 0; i < kStepsInPeriod; ++i) times.push_back((period * kStepsInPeriod + i + 1) * step);
  const SimulationResult result = run.run(times);
  const Eigen::VectorXd q = column(result.readings, "position"), v = column(result.readings, "velocity");
  double sum = 0.0;
  for (Eigen::Index i = 1; i < q.size(); ++i) {
    const double kinetic = 0.5 * (kInertia + kMass * kLength * kLength) * v(i) * v(i);
    sum += kinetic + kMass * kGravity * kLength * (1.0 - std::cos(q(i)));
  }
  return sum / kStepsInPeriod / (kMass * kGravity * kLength);
}

TEST(ArticulatedEnergy, DoesNotDriftInAHundredPeriods) {
  const double step = period_from_90_degrees() / kStepsInPeriod;
  SimulationRun run = articulated(pendulum(kMass, kLength, kInertia), step);
  run.from({0.5 * std::numbers::pi}, {0.0});
  EXPECT_NEAR(mean_energy(run, 99, step), mean_energy(run, 0, step), 1e-6);
}

/// A mass 1 on a spring whose undamped frequency is `angle` over the step.
SimulationRun oscillator(double angle, double step) {
  RobotSpec robot = one_joint(JointKind::slider, 1.0);
  robot.joints[0].stiffness = angle * angle / (step * step);
  SimulationRun run = articulated(robot, step);
  run.from({1.0}, {0.0});
  return run;
}

TEST(ArticulatedEnergy, AResolvedOscillationKeepsItsAmplitude) {
  constexpr double kStep = 0.01;
  for (const double angle : {0.05, 0.2, 0.5}) {
    const int steps = static_cast<int>(1000.0 * 2.0 * std::numbers::pi / angle);  // a thousand periods
    const SimulationResult result = oscillator(angle, kStep).run({0.0, steps * kStep});
    const double q = column(result.readings, "position")(1), v = column(result.readings, "velocity")(1);
    EXPECT_NEAR(std::hypot(q, v * kStep / angle), 1.0, 1e-8) << angle;
  }
}

TEST(ArticulatedEnergy, WhatTheStepDoesNotResolveDecaysAndDoesNotAlternate) {
  constexpr double kStep = 0.01;
  for (const double angle : {3.0, 10.0, 1e3, 1e6}) {
    std::vector<double> times;
    for (int i = 0; i <= 40; ++i) times.push_back(i * kStep);
    const Eigen::VectorXd q = column(oscillator(angle, kStep).run(times).readings, "position");
    EXPECT_LT(std::abs(q(20)), 1e-3) << angle;
    int alternations = 0;
    for (Eigen::Index i = 2; i < q.size(); ++i)
      alternations += q(i) * q(i - 1) < 0.0 && q(i - 1) * q(i - 2) < 0.0 && std::abs(q(i)) > 1e-6 ? 1 : 0;
    EXPECT_EQ(alternations, 0) << angle << ": " << q.transpose();
  }
}

/// Half a swing moves the turning point to -x + 2·friction/stiffness, until the spring no longer overcomes the friction.
double stopping_place(double start, double slack) {
  double place = start;
  while (std::abs(place) > slack) place = -place + std::copysign(2.0 * slack, place);
  return place;
}

TEST(ArticulatedFriction, StopsWhereItShould) {
  constexpr double kStiffness = 100.0, kFriction = 3.7;
  RobotSpec robot = one_joint(JointKind::slider, 1.1);
  robot.joints[0].stiffness = kStiffness;
  robot.joints[0].dry_friction = kFriction;
  const double step = 2.0 * std::numbers::pi / std::sqrt(kStiffness / 1.1) / kStepsInPeriod;
  SimulationRun run = articulated(robot, step);
  run.from({1.0}, {0.0});
  const SimulationResult result = run.run({0.0, 4000 * step});
  EXPECT_NEAR(column(result.readings, "position")(1), stopping_place(1.0, kFriction / kStiffness), 1e-6);
  EXPECT_EQ(column(result.readings, "velocity")(1), 0.0);
}

/// Two sliders that do not move each other and stop in the same step.
TEST(ArticulatedFriction, TwoJointsStopInOneStep) {
  RobotSpec robot = one_joint(JointKind::slider, 1.0);
  RobotSpec other = one_joint(JointKind::slider, 1.0);
  robot.bodies.push_back(other.bodies[0]);
  robot.bodies[1].name = "other";
  robot.joints.push_back(other.joints[0]);
  robot.joints[1].name = "second";
  robot.joints[1].child = "other";
  robot.sensors.push_back(make_sensor("place", SensorKind::joint_position, "second"));
  for (JointSpec& joint : robot.joints) joint.dry_friction = 2.0;
  SimulationRun run = articulated(robot, 0.01);
  run.from({0.0, 0.0}, {1.003, 1.006});  // they stop after 0.5015 and 0.503 s
  const SimulationResult result = run.run({0.0, 1.0});
  EXPECT_NEAR(column(result.readings, "position")(1), 1.003 * 1.003 / 4.0, 1e-6);
  EXPECT_NEAR(column(result.readings, "place")(1), 1.006 * 1.006 / 4.0, 1e-6);
}

}  // namespace
}  // namespace lacuna::articulated_energy_test

#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/sanitizers.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace lacuna::articulated_energy_test {
namespace {

constexpr double kMass = 1.0, kLength = 1.0, kInertia = 0.1;
constexpr int kStepsInPeriod = 100;

SimulationRun with_engine(const std::string& engine, const RobotSpec& robot, double step) {
  SimulationRun run(robot, step);
  run.engine.engine = engine;
  return run;
}

SimulationRun articulated(const RobotSpec& robot, double step) { return with_engine("articulated", robot, step); }

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

/// What a pendulum's energy has changed by after a hundred periods.
double drift_of_pendulum(const std::string& engine) {
  const double step = period_from_90_degrees() / kStepsInPeriod;
  SimulationRun run = with_engine(engine, pendulum(kMass, kLength, kInertia), step);
  run.from({0.5 * std::numbers::pi}, {0.0});
  return mean_energy(run, 99, step) - mean_energy(run, 0, step);
}

TEST(ArticulatedEnergy, DoesNotDriftInAHundredPeriods) {
  EXPECT_LT(std::abs(drift_of_pendulum("articulated")), 1e-6);
  EXPECT_GT(std::abs(drift_of_pendulum("ode")), 1e-3);
}

/// Above that of hanging at rest.
double energy_of_double_pendulum(double q1, double v1, double q2, double v2) {
  const double first = q1, second = q1 + q2, w1 = v1, w2 = v1 + v2;
  const double kinetic = 0.5 * kInertia * (w1 * w1 + w2 * w2) +
                         0.5 * kMass * kLength * kLength * (2.0 * w1 * w1 + w2 * w2 + 2.0 * w1 * w2 * std::cos(q2));
  return kinetic + kMass * kGravity * kLength * (3.0 - 2.0 * std::cos(first) - std::cos(second));
}

/// Slope of the energy over time, by least squares, times a hundred periods of the upper link's small swing, as a share
/// of the energy. The two links swing with two frequencies and no two periods are alike: the energy, which each step
/// keeps to second order only, fluctuates, and the fit over many periods separates what is secular from that.
double drift_of_double_pendulum(const std::string& engine, double angle, int periods) {
  const double period = 2.0 * std::numbers::pi / std::sqrt(pendulum_rate(kMass, kLength, kInertia));
  SimulationRun run = with_engine(engine, double_pendulum(kMass, kLength, kInertia), period / kStepsInPeriod);
  run.from({angle, 0.0}, {0.0, 0.0});
  const TimeSeries motion = run.run(evenly_spaced(periods * period, periods * kStepsInPeriod)).readings;
  const Eigen::VectorXd q1 = column(motion, "q1"), v1 = column(motion, "v1"), q2 = column(motion, "q2"),
                        v2 = column(motion, "v2");
  double moment = 0.0, spread = 0.0;
  for (Eigen::Index i = 0; i < q1.size(); ++i) {
    const double from_middle = static_cast<double>(i) / kStepsInPeriod - 0.5 * periods;
    moment += from_middle * energy_of_double_pendulum(q1(i), v1(i), q2(i), v2(i));
    spread += from_middle * from_middle;
  }
  return 100.0 * moment / spread / energy_of_double_pendulum(angle, 0.0, 0.0, 0.0);
}

TEST(ArticulatedEnergy, OfADoublePendulumDoesNotDrift) {
  if (LACUNA_WATCHED)
    GTEST_SKIP() << "a thousand periods take minutes under a sanitizer, which sees the same steps in the other tests";
  for (const double degrees : {20.0, 45.0, 90.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    EXPECT_LT(std::abs(drift_of_double_pendulum("articulated", angle, 1000)), 1e-6) << degrees;
    EXPECT_GT(std::abs(drift_of_double_pendulum("ode", angle, 100)), 1e-2) << degrees;
  }
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

/// Half a swing moves the turning point to -x + 2·friction/stiffness, until the spring no longer overcomes the
/// friction.
double stopping_place(double start, double slack) {
  double place = start;
  while (std::abs(place) > slack) place = -place + std::copysign(2.0 * slack, place);
  return place;
}

/// How far from where it should, as a share of the travel, a slider on a spring comes to rest.
double error_of_stop(const std::string& engine) {
  constexpr double kStiffness = 100.0, kFriction = 3.7;
  RobotSpec robot = one_joint(JointKind::slider, 1.1);
  robot.joints[0].stiffness = kStiffness;
  robot.joints[0].dry_friction = kFriction;
  const double step = 2.0 * std::numbers::pi / std::sqrt(kStiffness / 1.1) / kStepsInPeriod;
  SimulationRun run = with_engine(engine, robot, step);
  run.from({1.0}, {0.0});
  const SimulationResult result = run.run({0.0, 4000 * step});
  EXPECT_NEAR(column(result.readings, "velocity")(1), 0.0, engine == "ode" ? 1e-9 : 0.0);
  const double place = stopping_place(1.0, kFriction / kStiffness);
  return std::abs(column(result.readings, "position")(1) - place) / std::abs(1.0 - place);
}

TEST(ArticulatedFriction, StopsWhereItShould) {
  EXPECT_LT(error_of_stop("articulated"), 1e-6);
  EXPECT_GT(error_of_stop("ode"), 1e-3);
}

/// The moment at which it rests is nearer to the start of the step than the length of the step is exact.
TEST(ArticulatedFriction, StopsWhatHardlyMoves) {
  RobotSpec robot = one_joint(JointKind::slider, 1.0);
  robot.joints[0].dry_friction = 2.0;
  SimulationRun run = articulated(robot, 0.01);
  run.from({0.0}, {1e-73});
  const SimulationResult result = run.run({0.0, 0.1});
  EXPECT_EQ(column(result.readings, "velocity")(1), 0.0);
  EXPECT_NEAR(column(result.readings, "position")(1), 0.0, 1e-15);
}

/// Two bodies of 1 kg on sliders along one axis with dry friction, the first on the world.
RobotSpec two_sliders(const std::string& parent_of_second, double first_friction, double second_friction) {
  RobotSpec robot = one_joint(JointKind::slider, 1.0);
  const RobotSpec other = one_joint(JointKind::slider, 1.0);
  robot.bodies.push_back(other.bodies[0]);
  robot.bodies[1].name = "other";
  robot.joints.push_back(other.joints[0]);
  robot.joints[1].name = "second";
  robot.joints[1].parent = parent_of_second;
  robot.joints[1].child = "other";
  robot.sensors.push_back(make_sensor("place", SensorKind::joint_position, "second"));
  robot.sensors.push_back(make_sensor("speed", SensorKind::joint_velocity, "second"));
  robot.joints[0].dry_friction = first_friction;
  robot.joints[1].dry_friction = second_friction;
  return robot;
}

/// After a second, in 100 steps.
void expect_rest(const RobotSpec& robot, const std::array<double, 2>& velocities, const std::array<double, 2>& places) {
  SimulationRun run = articulated(robot, 0.01);
  run.from({0.0, 0.0}, {velocities[0], velocities[1]});
  const TimeSeries readings = run.run({0.0, 1.0}).readings;
  EXPECT_NEAR(column(readings, "position")(1), places[0], 1e-6 * places[0]);
  EXPECT_NEAR(column(readings, "place")(1), places[1], 1e-6 * places[1]);
  EXPECT_EQ(column(readings, "velocity")(1), 0.0);
  EXPECT_EQ(column(readings, "speed")(1), 0.0);
}

/// After 0.5015 and 0.503 s.
TEST(ArticulatedFriction, TwoJointsStopInOneStep) {
  expect_rest(two_sliders(kWorld, 2.0, 2.0), {1.003, 1.006}, {1.003 * 1.003 / 4.0, 1.006 * 1.006 / 4.0});
}

TEST(ArticulatedFriction, TwoJointsStopInOneMoment) {
  expect_rest(two_sliders(kWorld, 2.0, 2.0), {1.003, 1.003}, {1.003 * 1.003 / 4.0, 1.003 * 1.003 / 4.0});
}

/// The second slides on the first, with 2 and 1.5 N of friction: while both move, the first slows down by 0.5 m/s², the
/// second, against the first, by 1 m/s², and by 1.5 m/s² once the first stands.
TEST(ArticulatedFriction, AJointStopsInTheStepInWhichItsParentStopped) {
  constexpr double kFirst = 0.502, kSecond = 0.507;  // s, when they stop
  const double speed = kFirst * 1.0 + (kSecond - kFirst) * 1.5, left = (kSecond - kFirst) * 1.5;
  expect_rest(two_sliders("body", 2.0, 1.5), {0.5 * kFirst, speed},
              {0.25 * kFirst * kFirst, 0.5 * (speed + left) * kFirst + 0.5 * left * (kSecond - kFirst)});
}

}  // namespace
}  // namespace lacuna::articulated_energy_test

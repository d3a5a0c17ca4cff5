#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

/// Dry friction laws against an integration that finds each stop, and stays there while the force is below the limit.
namespace lacuna::friction_test {
namespace {

constexpr double kMass = 0.8;  // kg

const PhysicalEffect& effect(const std::string& name) { return built_catalog().get<PhysicalEffect>(name); }

/// A force that turns round twice, and once stays below break-away.
const std::vector<double> kTimes{0.0, 0.3, 0.7, 1.0, 1.4};
const std::vector<double> kForces{3.0, 3.0, -3.5, 0.4, 2.5};

double force_at(double time) {
  for (std::size_t i = 1; i < kTimes.size(); ++i)
    if (time <= kTimes[i])
      return kForces[i - 1] + (kForces[i] - kForces[i - 1]) * (time - kTimes[i - 1]) / (kTimes[i] - kTimes[i - 1]);
  return kForces.back();
}

SimulationRun pushed(const std::string& name, std::vector<double> values, double step) {
  SimulationRun run(one_joint(JointKind::slider, kMass), step);
  run.command("motor", kTimes, kForces, Hold::first_order);
  run.place(effect(name), ElementKind::joint, {0}, std::move(values));
  return run;
}

void expect_agreement(const std::string& name, const std::vector<double>& values,
                      const std::function<double(double q, double v)>& limit) {
  const FrictionSystem system{kMass, [](double time, double, double) { return force_at(time); },
                              [&](double, double q, double v) { return limit(q, v); }};
  for (const double end : {0.5, 0.9, 1.4}) {
    const double expected = integrate_with_friction(system, {}, {0.0, end}, 1e-5).back().q;
    EXPECT_NEAR(pushed(name, values, 1e-3).last("position", end), expected, 1e-3) << end;  // m of 0.4
    EXPECT_NEAR(pushed(name, values, 1e-4).last("position", end), expected, 1e-4) << end;
  }
}

TEST(StribeckFriction, AgreesWithAnIndependentIntegration) {
  expect_agreement("stribeck_friction", {0.6, 0.5, 0.2},
                   [](double, double v) { return 0.6 + 0.5 * std::exp(-(v / 0.2) * (v / 0.2)); });
}

TEST(StribeckFriction, WithoutExcessIsCoulombFriction) {
  const double stribeck = pushed("stribeck_friction", {0.6, 0.0, 0.2}, 1e-3).last("position", 1.4);
  EXPECT_DOUBLE_EQ(stribeck, pushed("coulomb_friction", {0.6}, 1e-3).last("position", 1.4));
}

/// A block on a table, drawn by a spring whose far end moves on evenly. The spring is a position servo without damping.
constexpr double kSpring = 40.0, kDrawing = 0.1;          // N/m, m/s
const std::vector<double> kStickSlip = {0.6, 0.5, 0.05};  // N, N, m/s
constexpr double kAtRest = 1e-9;                          // m/s
constexpr double kDrawnFor = 8.0;                         // s

double stick_slip_limit(double v) { return 0.6 + 0.5 * std::exp(-(v / 0.05) * (v / 0.05)); }

/// How often a velocity goes from rest to motion.
int departures(const std::vector<double>& velocities) {
  int count = 0;
  for (std::size_t i = 1; i < velocities.size(); ++i)
    if (std::abs(velocities[i - 1]) <= kAtRest && std::abs(velocities[i]) > kAtRest) ++count;
  return count;
}

TEST(StribeckFriction, SticksAndSlipsAsOftenAsAnIndependentIntegrationAndWithoutChatter) {
  const FrictionSystem system{kMass, [](double time, double q, double) { return kSpring * (kDrawing * time - q); },
                              [](double, double, double v) { return stick_slip_limit(v); }};
  const std::vector<double> times = evenly_spaced(kDrawnFor, 4000);
  std::vector<double> expected;
  for (const CoordinateState& state : integrate_with_friction(system, {}, times, 5e-5)) expected.push_back(state.v);

  RobotSpec robot = one_joint(JointKind::slider, kMass);
  robot.actuators[0].kind = ActuatorKind::position_servo;
  robot.actuators[0].kp = kSpring;
  SimulationRun run(robot, 1e-4);
  run.command("motor", {0.0, kDrawnFor}, {0.0, kDrawing * kDrawnFor}, Hold::first_order);
  run.place(effect("stribeck_friction"), ElementKind::joint, {0}, kStickSlip);
  const Eigen::VectorXd velocity = column(run.run(times).readings, "velocity");
  const std::vector<double> found(velocity.begin(), velocity.end());

  EXPECT_GE(departures(expected), 4);
  EXPECT_EQ(departures(found), departures(expected));
  EXPECT_GE(*std::min_element(found.begin(), found.end()), -kAtRest) << "it never moves against the pull";
  double farthest = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) farthest = std::max(farthest, std::abs(found[i] - expected[i]));
  EXPECT_LE(farthest, 0.005);  // m/s of 0.2; first order, and a departure may come a step late
}

TEST(PositionFriction, AgreesWithAnIndependentIntegration) {
  expect_agreement("position_friction", {0.6, 0.3, -0.2, 8.0}, [](double q, double) {
    return std::max(0.0, 0.6 + 0.3 * std::sin(8.0 * q) - 0.2 * std::cos(8.0 * q));
  });
}

TEST(DirectionalFriction, BrakesEachDirectionByItsOwn) {
  constexpr double kPositive = 0.5, kNegative = 1.1, kSpeed = 2.0, kStep = 1e-4;
  for (const double sign : {1.0, -1.0}) {
    SimulationRun run(one_joint(JointKind::slider, kMass), kStep);
    run.place(effect("directional_friction"), ElementKind::joint, {0}, {kPositive, kNegative});
    run.from({0.0}, {sign * kSpeed});
    const double friction = sign > 0.0 ? kPositive : kNegative;
    EXPECT_NEAR(run.last("position", 6.0), sign * 0.5 * kMass * kSpeed * kSpeed / friction, kSpeed * kStep);
    EXPECT_NEAR(run.last("velocity", 6.0), 0.0, 1e-9);
  }
}

TEST(DirectionalFriction, HoldsAJointAtRest) {
  SimulationRun run(one_joint(JointKind::slider, kMass), 1e-3);
  run.place(effect("directional_friction"), ElementKind::joint, {0}, {0.5, 1.1});
  EXPECT_NEAR(run.command("motor", 0.45).last("position", 1.0), 0.0, 1e-9);
  EXPECT_NEAR(run.command("motor", -1.05).last("position", 1.0), 0.0, 1e-9);
}

/// Thrown against a constant force, so that it comes back.
TEST(DirectionalViscousFriction, BrakesEachDirectionByItsOwn) {
  constexpr double kPositive = 0.5, kNegative = 1.1, kForce = 3.0, kStart = -2.0, kEnd = 1.5;
  const double there = -kForce / kNegative, back = kForce / kPositive;  // velocities to which it tends, m/s
  const double turn = kMass / kNegative * std::log((kStart + there) / there);
  const double expected = back * (1.0 - std::exp(-kPositive * (kEnd - turn) / kMass));
  const double halfway = -there + (kStart + there) * std::exp(-kNegative * 0.5 * turn / kMass);
  const auto run = [&](double step) {
    SimulationRun made(one_joint(JointKind::slider, kMass), step);
    made.place(effect("directional_viscous_friction"), ElementKind::joint, {0}, {kPositive, kNegative});
    return made.command("motor", kForce).from({0.0}, {kStart});
  };
  EXPECT_NEAR(run(1e-3).last("velocity", 0.5 * turn), halfway, 1e-6);
  EXPECT_NEAR(run(1e-3).last("velocity", kEnd), expected, 1e-6);
  EXPECT_NEAR(run(1e-2).last("velocity", kEnd), expected, 1e-4);
}

TEST(DirectionalViscousFriction, WithEqualCoefficientsIsViscousFriction) {
  EXPECT_NEAR(pushed("directional_viscous_friction", {0.7, 0.7}, 1e-3).last("position", 1.4),
              pushed("viscous_friction", {0.7}, 1e-3).last("position", 1.4), 1e-9);
}

/// Thrown without a force: v = v0/(1 + damping*v0*t/m).
TEST(QuadraticDamping, SlowsAsItsLawSays) {
  constexpr double kDamping = 0.8, kStart = -3.0, kEnd = 1.5;
  const double expected = kStart / (1.0 + kDamping * std::abs(kStart) * kEnd / kMass);
  const auto run = [&](double step) {
    SimulationRun made(one_joint(JointKind::slider, kMass), step);
    made.place(effect("quadratic_damping"), ElementKind::joint, {0}, {kDamping});
    return made.from({0.0}, {kStart}).last("velocity", kEnd);
  };
  EXPECT_NEAR(run(1e-3), expected, 1e-6);
  EXPECT_NEAR(run(1e-2), expected, 1e-4);
}

TEST(Hysteresis, AgreesWithAnIndependentIntegration) {
  constexpr double kForce = 0.7, kDistance = 0.02, kSharpness = 0.8;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double time) {
    const double v = x[1], z = x[2];
    dx = {v, (force_at(time) - kForce * z) / kMass,
          (v - kSharpness * std::abs(v) * z + (kSharpness - 1.0) * v * std::abs(z)) / kDistance};
  };
  for (const double end : {0.5, 0.9, 1.4}) {
    const double expected = integrate_in_steps(motion, {0.0, 0.0, 0.0}, {0.0, end}, 2e-5).back()[0];
    const auto error = [&](double step) {
      return pushed("hysteresis", {kForce, kDistance, kSharpness}, step).last("position", end) - expected;
    };
    EXPECT_LE(std::abs(error(1e-3)), 1.5e-3) << end;  // m of 0.4
    EXPECT_LE(std::abs(error(1e-4)), 1.5e-4) << end;
  }
}

TEST(Hysteresis, SpringsBackAndGoesOverIntoCoulombFriction) {
  SimulationRun run(one_joint(JointKind::slider, kMass), 1e-4);
  run.place(effect("hysteresis"), ElementKind::joint, {0}, {0.5, 1e-4, 0.5});
  EXPECT_NEAR(run.from({0.0}, {2.0}).last("position", 6.0), 0.5 * kMass * 4.0 / 0.5, 5e-3);
}

}  // namespace
}  // namespace lacuna::friction_test

#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

/// Forces on bodies, and gravity.
namespace lacuna::body_test {
namespace {

constexpr double kMass = 0.9, kLength = 0.35, kInertia = 0.03;
constexpr double kStep = 1e-3;  // s

const PhysicalEffect& effect(const std::string& name) { return built_catalog().get<PhysicalEffect>(name); }

SimulationRun mass_with(const std::string& name, std::vector<double> values, double step) {
  SimulationRun run(one_joint(JointKind::slider, kMass), step);
  run.place(effect(name), ElementKind::body, {0}, std::move(values));
  return run;
}

TEST(LinearDrag, LetsTheVelocityDecayExponentially) {
  constexpr double kDrag = 1.2, kSpeed = 3.0, kEnd = 0.8;
  const auto error = [&](double step) {
    return mass_with("linear_drag", {kDrag}, step).from({0.0}, {kSpeed}).last("velocity", kEnd) -
           kSpeed * std::exp(-kDrag / kMass * kEnd);
  };
  constexpr double kVelocityError = 3e-3;  // m/s of 1
  expect_convergence(error, kStep, kVelocityError);
}

TEST(QuadraticDrag, LetsTheVelocityDecayHyperbolically) {
  constexpr double kArea = 1.5, kDensity = 1.2, kSpeed = 3.0, kEnd = 0.8;
  const double expected = kSpeed / (1.0 + 0.5 * kDensity * kArea / kMass * kSpeed * kEnd);
  const auto error = [&](double step) {
    return mass_with("quadratic_drag", {kArea, kDensity}, step).from({0.0}, {kSpeed}).last("velocity", kEnd) - expected;
  };
  constexpr double kVelocityError = 3e-3;  // m/s of 1
  expect_convergence(error, kStep, kVelocityError);
}

SimulationRun hanging(const std::string& name, ElementKind kind, std::vector<double> values) {
  SimulationRun run(pendulum(kMass, kLength, kInertia), kStep);
  run.place(effect(name), kind, kind == ElementKind::world ? std::vector<int>{} : std::vector<int>{0},
            std::move(values));
  return run;
}

TEST(Buoyancy, TakesWeightAndLeavesInertia) {
  constexpr double kDisplaced = 0.3, kStart = 0.02, kEnd = 1.0;
  const double rate = (kMass - kDisplaced) * kGravity * kLength / (kInertia + kMass * kLength * kLength);
  const double position =
      hanging("buoyancy", ElementKind::body, {kDisplaced}).from({kStart}, {0.0}).last("position", kEnd);
  EXPECT_NEAR(position, kStart * std::cos(std::sqrt(rate) * kEnd), 0.005 * kStart);  // small angle, first order
}

TEST(CablePull, HoldsAPendulumWhereTorquesBalance) {
  // A far point along x pulls with a force that does not turn: tan q = T/(m g).
  SimulationRun run = hanging("cable_pull", ElementKind::body, {2.0, 100.0, 0.0, -kLength});
  run.structure.robot.joints[0].damping = 1.0;
  const double q = run.last("position", 20.0);
  EXPECT_NEAR(std::abs(q), std::atan(2.0 / (kMass * kGravity)), 1e-4);
}

TEST(MountTilt, ShiftsTheRestPosition) {
  constexpr double kTilt = 0.15;
  SimulationRun run = hanging("mount_tilt", ElementKind::world, {0.0, kTilt});
  run.structure.robot.joints[0].damping = 1.0;
  // The pendulum hangs upright in the world: turned by −tilt against its mount, about the same axis y.
  EXPECT_NEAR(run.last("position", 20.0), -kTilt, 1e-6);
}

TEST(MountTilt, AcrossTheAxisWeakensGravity) {
  constexpr double kTilt = 0.5, kStart = 0.02, kEnd = 1.0;
  const double rate = pendulum_rate(kMass, kLength, kInertia) * std::cos(kTilt);
  const double position =
      hanging("mount_tilt", ElementKind::world, {kTilt, 0.0}).from({kStart}, {0.0}).last("position", kEnd);
  EXPECT_NEAR(position, kStart * std::cos(std::sqrt(rate) * kEnd), 0.005 * kStart);
}

}  // namespace
}  // namespace lacuna::body_test

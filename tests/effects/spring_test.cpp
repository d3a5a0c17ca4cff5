#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// Elastic joint effects against the solutions of their equations of motion.
namespace lacuna::spring_test {
namespace {

constexpr double kInertia = 0.5;  // kg on a slider
constexpr double kStart = 0.3;    // m
constexpr double kStep = 1e-3;    // s

const PhysicalEffect& effect(const std::string& name) { return built_catalog().get<PhysicalEffect>(name); }

SimulationRun with(const std::string& name, std::vector<double> values, double step = kStep) {
  SimulationRun run(one_joint(JointKind::slider, kInertia), step);
  run.place(effect(name), ElementKind::joint, {0}, std::move(values));
  run.from({kStart}, {0.0});
  return run;
}

TEST(JointSpring, SwingsAboutItsRestPosition) {
  constexpr double kStiffness = 8.0, kRest = 0.1, kEnd = 1.3;
  const double expected = kRest + (kStart - kRest) * std::cos(std::sqrt(kStiffness / kInertia) * kEnd);
  const auto error = [&](double step) {
    return with("joint_spring", {kStiffness, kRest}, step).last("position", kEnd) - expected;
  };
  constexpr double kPositionError = 5e-3;  // m of 0.2
  expect_convergence(error, kStep, kPositionError);
}

TEST(JointSpring, AddsToTheJointsOwn) {
  SimulationRun both = with("joint_spring", {3.0, 0.4}), own = both;
  both.structure.robot.joints[0].stiffness = 5.0;
  both.structure.robot.joints[0].rest = -0.2;
  own.structure.effects.clear();
  own.structure.robot.joints[0].stiffness = 8.0;
  own.structure.robot.joints[0].rest = (5.0 * -0.2 + 3.0 * 0.4) / 8.0;
  EXPECT_NEAR(both.last("position", 0.9), own.last("position", 0.9), kRounding);
}

TEST(CubicStiffness, AgreesWithAnIndependentIntegration) {
  constexpr double kEnd = 1.6;
  for (const double stiffness : {200.0, -6.0}) {
    const Derivative motion = [stiffness](const ReferenceState& x, ReferenceState& dx, double) {
      const double deflection = x[0] - 0.05;
      dx = {x[1], -stiffness * deflection * deflection * deflection / kInertia};
    };
    const double expected = integrate_smooth(motion, {kStart, 0.0}, {0.0, kEnd}).back()[0];
    const auto error = [&](double step) {
      return with("cubic_stiffness", {stiffness, 0.05}, step).last("position", kEnd) - expected;
    };
    constexpr double kPositionError = 5e-3;  // m of 0.3
    expect_convergence(error, kStep, kPositionError);
  }
}

TEST(HardStop, ThrowsBackLikeASpringAndADamper) {
  constexpr double kUpper = 0.5, kStiffness = 400.0, kDamping = 4.0, kSpeed = 2.0, kEnd = 0.4;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    const double depth = x[0] - kUpper;
    dx = {x[1], depth > 0.0 ? -std::max(0.0, kStiffness * depth + kDamping * x[1]) / kInertia : 0.0};
  };
  const double expected = integrate_in_steps(motion, {kStart, kSpeed}, {0.0, kEnd}, 1e-5).back()[0];
  EXPECT_LT(expected, 0.4);  // it has come back
  const auto position = [&](double step) {
    SimulationRun run = with("hard_stop", {-1.0, kUpper, kStiffness, kDamping}, step);
    return run.from({kStart}, {kSpeed}).last("position", kEnd);
  };
  EXPECT_NEAR(position(1e-4), expected, 1.5e-3);
  EXPECT_NEAR(position(1e-5), expected, 1.5e-4);
}

TEST(Cogging, AgreesWithAnIndependentIntegration) {
  constexpr double kSine = 0.7, kCosine = -0.4, kPeriods = 5.0, kEnd = 0.9;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    dx = {x[1], (kSine * std::sin(kPeriods * x[0]) + kCosine * std::cos(kPeriods * x[0])) / kInertia};
  };
  const double expected = integrate_smooth(motion, {kStart, 0.0}, {0.0, kEnd}).back()[0];
  const auto error = [&](double step) {
    return with("cogging", {kSine, kCosine, kPeriods}, step).last("position", kEnd) - expected;
  };
  constexpr double kPositionError = 5e-3;  // m of 0.3
  expect_convergence(error, kStep, kPositionError);
}

TEST(Armature, MakesTheJointSlower) {
  SimulationRun run = with("armature", {0.25});
  run.command("motor", 1.5);
  constexpr double kEnd = 0.5, kOneStep = 2.0 * kEnd * kStep;
  EXPECT_NEAR(run.last("position", kEnd), kStart + 0.5 * 1.5 / (kInertia + 0.25) * kEnd * kEnd, kOneStep);
}

TEST(LinkFlexibility, AgreesWithAnIndependentIntegration) {
  constexpr double kMode = 0.1, kFrequency = 25.0, kRatio = 0.05, kForce = 1.0, kEnd = 0.35;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    const double pull = kMode * (kFrequency * kFrequency * (x[2] - x[0]) + 2.0 * kRatio * kFrequency * (x[3] - x[1]));
    dx = {x[1], (kForce + pull) / kInertia, x[3], -pull / kMode};
  };
  const double expected = integrate_smooth(motion, {kStart, 0.0, kStart, 0.0}, {0.0, kEnd}).back()[0];
  const auto error = [&](double step) {
    SimulationRun run = with("link_flexibility", {kMode, kFrequency, kRatio}, step);
    return run.command("motor", kForce).last("position", kEnd) - expected;
  };
  constexpr double kPositionError = 2e-3;  // m of 0.1
  expect_convergence(error, 2e-4, kPositionError);
}

TEST(BaseCompliance, AgreesWithAnIndependentIntegrationOfLinkAndBase) {
  // A link of inertia I on a base of inertia J; the joint measures q, the link's motion less the base's.
  constexpr double kBase = 5.0, kFrequency = 20.0, kDamping = 0.1, kForce = 1.0, kEnd = 0.4;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    const double base = -kFrequency * kFrequency * x[2] - 2.0 * kDamping * kFrequency * x[3] - kForce / kBase;
    dx = {x[1], kForce / kInertia - base, x[3], base};
  };
  const double expected = integrate_smooth(motion, {kStart, 0.0, 0.0, 0.0}, {0.0, kEnd}).back()[0];
  const auto error = [&](double step) {
    SimulationRun run = with("base_compliance", {kInertia / kBase, kFrequency, kDamping}, step);
    return run.command("motor", kForce).last("position", kEnd) - expected;
  };
  constexpr double kPositionError = 2e-4;  // m of 0.16
  EXPECT_LE(std::abs(error(2e-4)), kPositionError);
  EXPECT_LE(std::abs(error(2e-5)), 0.1 * kPositionError);
}

}  // namespace
}  // namespace lacuna::spring_test

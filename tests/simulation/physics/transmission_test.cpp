#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna::transmission_test {
namespace {

constexpr double kInertia = 0.8;                         // kg·m², of the link
constexpr double kRotor = 2e-4;                          // kg·m², at the motor's shaft
constexpr double kRatio = 50.0;                          // motor turns per joint turn
constexpr double kReflected = kRotor * kRatio * kRatio;  // 0.5 kg·m², at the joint
constexpr double kStep = 5e-4;

RobotSpec geared(double stiffness, double damping, double gap) {
  RobotSpec robot = one_joint(JointKind::hinge, kInertia);
  robot.actuators[0].transmission = {
      .ratio = kRatio, .rotor_inertia = kRotor, .stiffness = stiffness, .damping = damping, .gap = gap};
  return robot;
}

TEST(Transmission, RigidOneReflectsTheRotorWithTheSquareOfTheRatio) {
  SimulationRun run(geared(kInfinity, 0.0, 0.0), kStep);
  EXPECT_NEAR(run.command("motor", 4.0).last("velocity", 0.5), 4.0 * 0.5 / (kInertia + kReflected), 1e-6);
}

/// Rotor and link joined by a spring–damper with a gap; the state is (rotor, link, their velocities), joint side.
struct TwoInertias {
  double stiffness = 0.0, damping = 0.0, gap = 0.0;
  double torque = 0.0, load_damping = 0.0;

  double link_after(double end) const {
    const Derivative motion = [this](const ReferenceState& x, ReferenceState& dx, double) {
      const double twist = x[0] - x[1];
      const double bent = twist - std::clamp(twist, -gap / 2, gap / 2);
      const bool touching = gap == 0.0 || bent != 0.0;
      const double transmitted = stiffness * bent + (touching ? damping * (x[2] - x[3]) : 0.0);
      dx = {x[2], x[3], (torque - transmitted) / kReflected, (transmitted - load_damping * x[3]) / kInertia};
    };
    return integrate_in_steps(motion, {0.0, 0.0, 0.0, 0.0}, {0.0, end}, 2e-5).back()[1];
  }
};

TEST(Transmission, CompliantOneSwingsBetweenRotorAndLink) {
  constexpr double kEnd = 0.4;
  const double expected = TwoInertias{.stiffness = 150.0, .damping = 0.4, .torque = 4.0}.link_after(kEnd);
  const auto error = [&](double step) {
    return SimulationRun(geared(150.0, 0.4, 0.0), step).command("motor", 4.0).last("position", kEnd) - expected;
  };
  expect_convergence(error, kStep, 5e-3);
}

TEST(Transmission, StiffOneBehavesAsRigid) {
  constexpr double kEnd = 0.5;
  const double rigid = SimulationRun(geared(kInfinity, 0.0, 0.0), kStep).command("motor", 4.0).last("position", kEnd);
  const double stiff = SimulationRun(geared(1e7, 1e3, 0.0), kStep).command("motor", 4.0).last("position", kEnd);
  EXPECT_NEAR(stiff, rigid, 1e-3 * rigid);
}

TEST(Transmission, GapLetsTheRotorRunFreeBeforeItBites) {
  constexpr double kGap = 0.06;
  SimulationRun run(geared(400.0, 0.0, kGap), kStep);
  run.command("motor", 4.0);
  const double free_for = std::sqrt(kGap * kReflected / 4.0);  // half the gap at 4/0.5 rad/s²
  EXPECT_NEAR(run.last("position", 0.95 * free_for), 0.0, 1e-9);
  EXPECT_GT(run.last("velocity", free_for + 0.02), 1e-3);
}

TEST(Transmission, GapAgreesWithAnIndependentIntegration) {
  constexpr double kEnd = 0.35;
  RobotSpec robot = geared(400.0, 0.0, 0.06);
  robot.joints[0].damping = 1.0;
  const double expected =
      TwoInertias{.stiffness = 400.0, .gap = 0.06, .torque = 4.0, .load_damping = 1.0}.link_after(kEnd);
  const auto error = [&](double step) {
    return std::abs(SimulationRun(robot, step).command("motor", 4.0).last("position", kEnd) - expected);
  };
  constexpr double kGapError = 0.01;  // rad
  EXPECT_LE(error(kStep), kGapError);
  EXPECT_LE(error(kStep / 8), kGapError / 6);
}

TEST(Transmission, GapWorksInBothDirections) {
  const SimulationRun there = SimulationRun(geared(400.0, 0.0, 0.06), kStep).command("motor", 4.0);
  const SimulationRun back = SimulationRun(geared(400.0, 0.0, 0.06), kStep).command("motor", -4.0);
  EXPECT_NEAR(there.last("position", 0.3), -back.last("position", 0.3), 1e-9);
}

TEST(Transmission, RestoresTheRotorsState) {
  SimulationRun run(geared(150.0, 0.4, 0.02), kStep);
  run.command("motor", {0.0, 0.13}, {4.0, -3.0}, Hold::zero_order);
  expect_same_bits_after_restore(run, evenly_spaced(0.4, 40), 21);
}

}  // namespace
}  // namespace lacuna::transmission_test

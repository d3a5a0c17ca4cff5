#include "plant/motion.h"

#include "laws/law_kind.h"
#include "rigs/rig.h"
#include "stick_slip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hidden_effects {
namespace {

constexpr std::size_t kSamples = 401;
constexpr double kFriction = 0.06;  // N·m

Laws one(const std::string& name, std::vector<double> parameters) { return {law_kind(name).make(parameters, 0)}; }

Excitation multisine(const Rig& rig) {
  Excitation excitation{rig.interval, commands(rig, 0, 2.0, 3), 0.001, {}};
  excitation.commands[0].resize(kSamples);
  return excitation;
}

std::vector<double> angles(const PlantSpec& spec, const Laws& laws, const Excitation& excitation, double step) {
  Simulation plant(spec, laws, excitation, step);
  const Start start{Coordinates::Constant(1, 0.3), Coordinates::Constant(1, -1.0)};
  const Motion motion = simulate(plant, start, excitation.samples(), plant.steps_a_sample());
  return motion.position[0];
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

/// The order of convergence, from three steps each half of the one before.
double order_of(const Laws& laws) {
  const Rig rig = servo_pendulum();
  const Excitation excitation = multisine(rig);
  const auto at = [&](double step) { return angles(rig.nominal, laws, excitation, step); };
  const auto coarse = at(1e-3), middle = at(5e-4), fine = at(2.5e-4);
  return std::log2(largest_difference(coarse, middle) / largest_difference(middle, fine));
}

TEST(Simulation, ConvergesWithTheSecondOrder) {
  EXPECT_NEAR(order_of(one("viscous_friction", {0.03})), 2.0, 0.1);
  EXPECT_NEAR(order_of(one("hysteresis", {0.05, 0.1, 0.7})), 2.0, 0.3);
  EXPECT_NEAR(order_of(one("link_flexibility", {0.004, 50.0, 0.03})), 2.0, 0.2);
  EXPECT_NEAR(order_of(one("actuator_lag", {0.05})), 2.0, 0.2);
}

/// Beside an integration that splits its steps where the arm stops and breaks away.
double error_with_dry_friction(double step) {
  const Rig rig = servo_pendulum();
  const Excitation excitation = multisine(rig);
  const PlantBody& arm = rig.nominal.bodies[0];
  const double lever = arm.com.norm();
  const servo_pendulum::Pendulum pendulum{arm.inertia + arm.mass * lever * lever + rig.nominal.drives[0].rotor_inertia,
                                          arm.mass * 9.81 * lever, rig.nominal.joints[0].damping, kFriction};
  const auto read = angles(rig.nominal, one("coulomb_friction", {kFriction}), excitation, step);
  servo_pendulum::Motion motion{0.3, -1.0};
  constexpr int kParts = 50;
  double largest = 0.0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    largest = std::max(largest, std::abs(motion.angle - read[k]));
    for (int i = 0; i < kParts; ++i)
      motion = advance(pendulum, motion, {excitation.commands[0][k], 0.0}, excitation.interval / kParts);
  }
  return largest;
}

TEST(Simulation, DryFrictionAgreesWithAnIntegrationThatSplitsItsSteps) {
  const double coarse = error_with_dry_friction(1e-3), fine = error_with_dry_friction(1.25e-4);
  EXPECT_LT(coarse, 1e-5);
  EXPECT_GT(std::log2(coarse / fine) / 3.0, 1.8);  // the order
}

/// What a hinge about y feels of gravity that is turned about y and then about the rig's own x.
TEST(Simulation, ATiltedRigHasLessGravityInItsPlane) {
  PlantSpec tilted = servo_pendulum().nominal;
  const double g = -tilted.gravity.y(), roll = 0.4, pitch = 0.3;
  law_kind("mount_tilt").make(std::vector<double>{roll, pitch}, 0)->amend(tilted);
  EXPECT_NEAR(std::abs(tilted.gravity.x()), g * std::sin(pitch), 1e-12);
  EXPECT_NEAR(tilted.gravity.y(), -g * std::cos(pitch) * std::cos(roll), 1e-12);
}

TEST(Simulation, AStopOfDryFrictionHoldsUntilTheTorqueExceedsIt) {
  const Rig rig = servo_pendulum();
  PlantSpec level = rig.nominal;
  level.gravity.setZero();
  Excitation excitation{0.005, {std::vector<double>(100, 0.99 * kFriction)}, 0.001, {}};
  const Start rest{Coordinates::Zero(1), Coordinates::Zero(1)};
  Simulation held(level, one("coulomb_friction", {kFriction}), excitation, 5e-4);
  EXPECT_EQ(simulate(held, rest, 100, 10).position[0].back(), 0.0);
  excitation.commands[0].assign(100, 1.01 * kFriction);
  Simulation moved(level, one("coulomb_friction", {kFriction}), excitation, 5e-4);
  EXPECT_GT(simulate(moved, rest, 100, 10).position[0].back(), 0.0);
}

/// dz/dt = (v − s·|v|·z + (s − 1)·v·|z|)/d with a great many small steps.
TEST(Simulation, HysteresisFollowsItsDifferentialEquation) {
  const double torque = 0.7, distance = 0.03, sharpness = 0.8, step = 1e-3;
  const auto law = law_kind("hysteresis").make(std::vector<double>{torque, distance, sharpness}, 0);
  const Rig rig = servo_pendulum();
  const Chain chain(rig.nominal);
  const Coordinates zero = Coordinates::Zero(1);
  double memory = 0.0, z = 0.0;
  for (int k = 0; k < 400; ++k) {
    const Coordinates velocity = Coordinates::Constant(1, 0.9 * std::sin(0.05 * k) + 0.2);
    const Moment at{0.0, step, zero, velocity, zero, rig.nominal, chain};
    Load load{zero, zero, zero};
    law->act(at, &memory, load);
    constexpr int kParts = 2000;
    const double v = velocity[0], part = step / kParts;
    for (int i = 0; i < kParts; ++i)
      z += part * (v - sharpness * std::abs(v) * z + (sharpness - 1.0) * v * std::abs(z)) / distance;
    ASSERT_NEAR(memory, z, 1e-5) << k;
  }
  EXPECT_GT(std::abs(z), 0.1);
}

}  // namespace
}  // namespace hidden_effects

#include <lacuna/force_law.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lacuna {
namespace {

using Function = Dual (*)(const Dual& q, const Dual& v);

constexpr double kStep = 1e-6;        // of a central difference
constexpr double kDifference = 1e-8;  // what rounding and the third derivative leave of it
constexpr double kRounding = 1e-12;

const std::vector<Function>& laws() {
  static const std::vector<Function> all = {
      [](const Dual& q, const Dual& v) { return q * v - v / (2.0 + q * q) + 3.0; },
      [](const Dual& q, const Dual& v) { return sin(3.0 * q) * cos(v) - exp(-v * v); },
      [](const Dual& q, const Dual& v) { return tanh(v / 0.7) * sqrt(abs(q) + 0.1); },
      [](const Dual& q, const Dual& v) { return pow(abs(v), 1.5) * sgn(v) + pow(q, 3.0); },
  };
  return all;
}

TEST(Dual, DerivativesAgreeWithCentralDifferences) {
  for (const Function law : laws())
    for (const double q : {-1.3, 0.4, 2.0})
      for (const double v : {-0.9, 0.3, 1.7}) {
        const Dual at = law(Dual::position(q), Dual::velocity(v));
        EXPECT_EQ(at.value, law(q, v).value);
        EXPECT_NEAR(at.by_position, (law(q + kStep, v).value - law(q - kStep, v).value) / (2.0 * kStep), kDifference);
        EXPECT_NEAR(at.by_velocity, (law(q, v + kStep).value - law(q, v - kStep).value) / (2.0 * kStep), kDifference);
      }
}

TEST(Dual, AtKinksAndInfiniteSlopesTheDerivativeIsZero) {
  const Dual v = Dual::velocity(0.0);
  for (const Dual& at : {abs(v), sqrt(v), pow(v, 0.5), sgn(v)}) EXPECT_EQ(at.by_velocity, 0.0);
  EXPECT_EQ(pow(v, 1.0).by_velocity, 1.0);
}

TEST(ForceLawHelper, TheForceAtThisMomentIsTheLaws) {
  for (const Function law : laws())
    for (const double q : {-1.3, 0.0, 2.0})
      for (const double v : {-0.9, 0.0, 1.7}) {
        JointLoad load;
        add_force_law(load, q, v, law);
        EXPECT_EQ(load.force, law(q, v).value);
        EXPECT_GE(load.damping, 0.0);
        EXPECT_GE(load.stiffness, 0.0);
      }
}

TEST(ForceLawHelper, WhatFallsIsStiffnessAndDamping) {
  JointLoad load;
  add_force_law(load, 0.5, 2.0, [](const Dual& q, const Dual& v) { return -0.3 * v - 4.0 * q; });
  EXPECT_NEAR(load.damping, 0.3, kRounding);
  EXPECT_NEAR(load.stiffness, 4.0, kRounding);
  JointLoad driving;
  add_force_law(driving, 0.5, 2.0, [](const Dual& q, const Dual& v) { return 0.3 * v + 4.0 * q; });
  EXPECT_EQ(driving.damping, 0.0);
  EXPECT_EQ(driving.stiffness, 0.0);
}

/// An implicit step of mass 1 under the load.
double next_velocity(double v, double step, Function law) {
  JointLoad load;
  add_force_law(load, 0.0, v, law);
  return (v + step * (load.force + load.damping * v)) / (1.0 + step * load.damping);
}

TEST(ForceLawHelper, TheSlopesAreThoseOfTheLaw) {
  JointLoad load;
  add_force_law(load, 0.5, -2.0, [](const Dual& q, const Dual& v) { return -3.0 * v * abs(v) - q * q * q; });
  EXPECT_NEAR(load.damping, 12.0, kRounding);
  EXPECT_NEAR(load.stiffness, 0.75, kRounding);
}

TEST(ForceLawHelper, AStepBringsASteepLawAtMostToRest) {
  const Function steep = [](const Dual&, const Dual& v) { return -5.0 * tanh(v / 1e-4); };
  for (const double v : {1.0, 0.01, 1e-5, -0.3}) {
    const double next = next_velocity(v, 0.01, steep);
    EXPECT_GE(next * v, 0.0);
    EXPECT_LT(std::abs(next), std::abs(v));
  }
}

TEST(ForceLawHelper, AForceAgainstTheMotionIsDryFriction) {
  JointLoad load;
  add_force_along_motion(load, 0.0, -0.4);
  EXPECT_EQ(load.friction_upper, 0.4);
  EXPECT_EQ(load.friction_lower, -0.4);
  EXPECT_EQ(load.force, 0.0);
  JointLoad driven;
  add_force_along_motion(driven, -2.0, 0.4);
  EXPECT_EQ(driven.force, -0.4);
  EXPECT_EQ(driven.friction_upper, 0.0);
}

}  // namespace
}  // namespace lacuna

#include "plugins/built_catalog.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>

/// The joint effects as they come out of a simulation, against the solutions of their equations of motion.
namespace lacuna {
namespace {

constexpr double kInertia = 0.02;  // kg·m² on a hinge, kg on a slider
constexpr double kStart = 3.0;     // rad/s or m/s
constexpr double kStep = 1e-4;     // s

class JointEffects : public testing::TestWithParam<JointKind> {
 protected:
  /// A joint that starts at `velocity` with this effect on it.
  static SimulationRun with(const std::string& effect, double value, double velocity) {
    SimulationRun run(one_joint(GetParam(), kInertia), kStep);
    run.place(built_catalog().get<PhysicalEffect>(effect), ElementKind::joint, {0}, {value});
    run.from({0.0}, {velocity});
    return run;
  }
};

TEST_P(JointEffects, ViscousFrictionLetsTheVelocityDecayExponentially) {
  constexpr double kDamping = 0.05, kEnd = 0.8;
  constexpr double kFirstOrder = kStart * 0.5 * kStep * kDamping / kInertia * 2.0;  // of implicit Euler, with a margin
  const double velocity = with("viscous_friction", kDamping, kStart).last("velocity", kEnd);
  EXPECT_NEAR(velocity, kStart * std::exp(-kDamping / kInertia * kEnd), kFirstOrder);
}

TEST_P(JointEffects, CoulombFrictionStopsTheJointAndHoldsIt) {
  constexpr double kFriction = 0.1;
  constexpr double kDistance = 0.5 * kInertia * kStart * kStart / kFriction;
  constexpr double kStopTime = kInertia * kStart / kFriction;
  constexpr double kOneStep = kStart * kStep;  // of the motion, first order
  const SimulationRun run = with("coulomb_friction", kFriction, kStart);
  EXPECT_NEAR(run.last("position", 2.0 * kStopTime), kDistance, kOneStep);
  EXPECT_NEAR(run.last("velocity", 2.0 * kStopTime), 0.0, 1e-9);
}

TEST_P(JointEffects, AnOffsetTorqueAcceleratesEvenly) {
  constexpr double kTorque = -0.04, kEnd = 0.5;
  constexpr double kOneStep = 0.04 / kInertia * kEnd * kStep;
  const double position = with("joint_offset_torque", kTorque, 0.0).last("position", kEnd);
  EXPECT_NEAR(position, 0.5 * kTorque / kInertia * kEnd * kEnd, kOneStep);
}

INSTANTIATE_TEST_SUITE_P(Kinds, JointEffects, testing::Values(JointKind::hinge, JointKind::slider),
                         [](const auto& kind) { return kind.param == JointKind::hinge ? "hinge" : "slider"; });

}  // namespace
}  // namespace lacuna

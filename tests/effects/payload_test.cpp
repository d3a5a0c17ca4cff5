#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::payload_test {
namespace {

constexpr double kMass = 0.9, kLength = 0.35, kInertia = 0.03;
constexpr double kPayload = 0.4;
const Eigen::Vector3d kPlace(0.12, 0.08, -0.1);  // in the body frame

SimulationRun loaded(double step) {
  SimulationRun run(pendulum(kMass, kLength, kInertia), step);
  run.from({0.6}, {0.0});
  run.place(built_catalog().get<PhysicalEffect>("payload"), ElementKind::body, {0},
            {kPayload, kPlace.x(), kPlace.y(), kPlace.z()});
  return run;
}

/// Body and point mass about the hinge, each on its own: no common centre of mass is formed.
void motion(const ReferenceState& x, ReferenceState& dx, double) {
  const double x_p = kPlace.x(), z_p = kPlace.z() - kLength;
  const double inertia = kInertia + kMass * kLength * kLength + kPayload * (x_p * x_p + z_p * z_p);
  const double torque =
      kGravity * (-kMass * kLength * std::sin(x[0]) + kPayload * (x_p * std::cos(x[0]) + z_p * std::sin(x[0])));
  dx = {x[1], torque / inertia};
}

TEST(Payload, AgreesWithAnIndependentIntegration) {
  for (const double end : {0.5, 1.1}) {
    const ReferenceState expected = integrate_smooth(motion, {0.6, 0.0}, {0.0, end}).back();
    const auto error = [&](double step) { return loaded(step).last("position", end) - expected[0]; };
    constexpr double kPositionError = 0.01;  // rad of 0.6
    expect_convergence(error, 1e-3, kPositionError);
  }
}

TEST(Payload, OfNoMassChangesNothing) {
  SimulationRun empty = loaded(1e-3), bare = loaded(1e-3);
  empty.structure.effects[0].values[0] = 0.0;
  bare.structure.effects.clear();
  EXPECT_NEAR(empty.last("position", 1.0), bare.last("position", 1.0), kRounding);
}

TEST(Payload, ContinuesBitIdenticallyAfterARestore) {
  SimulationRun run = loaded(1e-3);
  run.structure.robot.sensors[0].delay = 0.0043;
  run.structure.robot.joints[0].dry_friction = 0.2;
  expect_same_bits_after_restore(run, evenly_spaced(1.0, 40), 19);
}

TEST(AllEffectsTogether, ContinueBitIdenticallyAfterARestore) {
  SimulationRun run = loaded(1e-3);
  run.structure.robot.actuators[0].transmission = {.ratio = 30.0, .rotor_inertia = 1e-4, .stiffness = 1e3, .gap = 0.01};
  run.structure.robot.sensors[0].delay = 0.0043;
  run.structure.robot.sensors[1].noise = 0.01;
  run.imperfections = SensorImperfections{.seed = 5};
  run.command("motor", {0.0, 0.2, 0.5}, {1.0, -2.0, 3.0}, Hold::first_order);
  run.place(built_catalog().get<PhysicalEffect>("command_delay"), ElementKind::actuator, {0}, {0.0025});
  run.place(built_catalog().get<PhysicalEffect>("lugre_friction"), ElementKind::joint, {0},
            {0.2, 0.1, 0.05, 500.0, 5.0, 0.1});
  run.place(built_catalog().get<PhysicalEffect>("joint_compliance"), ElementKind::actuator, {0}, {40.0, 0.3});
  run.place(built_catalog().get<PhysicalEffect>("load_friction"), ElementKind::joint, {0}, {0.1});
  expect_same_bits_after_restore(run, evenly_spaced(1.0, 50), 27);
}

}  // namespace
}  // namespace lacuna::payload_test

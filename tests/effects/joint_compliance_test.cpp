#include "plugins/built_catalog.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::joint_compliance_test {
namespace {

constexpr double kMass = 0.9, kLength = 0.35, kInertia = 0.03;
constexpr double kRotor = 1e-4, kRatio = 30.0, kReflected = kRotor * kRatio * kRatio;
constexpr double kStiffness = 40.0, kDamping = 0.3;

/// A pendulum lifted through an elastic gear by a torque that starts at once.
SimulationRun lifted(double step) {
  RobotSpec robot = pendulum(kMass, kLength, kInertia);
  robot.actuators[0].transmission.ratio = kRatio;
  robot.actuators[0].transmission.rotor_inertia = kRotor;
  SimulationRun run(robot, step);
  run.command("motor", 1.5);
  run.place(built_catalog().get<PhysicalEffect>("joint_compliance"), ElementKind::actuator, {0},
            {kStiffness, kDamping});
  return run;
}

/// (rotor, link, their velocities), all at the joint.
void motion(const ReferenceState& x, ReferenceState& dx, double) {
  const double transmitted = kStiffness * (x[0] - x[1]) + kDamping * (x[2] - x[3]);
  const double weight = kMass * kGravity * kLength * std::sin(x[1]);
  dx = {x[2], x[3], (1.5 - transmitted) / kReflected, (transmitted - weight) / (kInertia + kMass * kLength * kLength)};
}

TEST(JointCompliance, AgreesWithAnIndependentIntegration) {
  for (const double end : {0.3, 0.8}) {
    const ReferenceState expected = integrate_smooth(motion, {0, 0, 0, 0}, {0.0, end}).back();
    const auto error = [&](double step) { return lifted(step).last("position", end) - expected[1]; };
    constexpr double kPositionError = 0.01;  // rad of 0.8
    expect_convergence(error, 1e-3, kPositionError);
  }
}

TEST(JointCompliance, ApproachesTheRigidTransmissionWhenStiff) {
  SimulationRun stiff = lifted(1e-3), rigid = lifted(1e-3);
  stiff.structure.effects[0].values = {1e7, 1e3};
  rigid.structure.effects.clear();
  EXPECT_NEAR(stiff.last("position", 0.6), rigid.last("position", 0.6), 1e-3);
}

TEST(JointCompliance, ContinuesBitIdenticallyAfterARestore) {
  SimulationRun run = lifted(1e-3);
  run.structure.robot.sensors[0].delay = 0.0043;
  expect_same_bits_after_restore(run, evenly_spaced(0.8, 40), 17);
}

}  // namespace
}  // namespace lacuna::joint_compliance_test

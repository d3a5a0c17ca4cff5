#include "conformance/effect_rig.h"

#include "support/reference_integration.h"
#include "support/robots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// Effects that say they take energy out do, and never put any in.
namespace lacuna {
namespace {

constexpr double kPush = 0.3;    // N·m, of the motor: a force with a potential
constexpr double kEnd = 3.0;     // s
constexpr double kStep = 1e-4;   // s
constexpr double kError = 1e-3;  // of the largest kinetic energy: a first-order method's, and what springs give back

/// Mechanical energy along a motion.
struct Energies {
  std::vector<double> sum;       ///< kinetic and potential, J
  double largest_kinetic = 0.0;  ///< J

  void add(double kinetic, double potential) {
    sum.push_back(kinetic + potential);
    largest_kinetic = std::max(largest_kinetic, kinetic);
  }
};

/// The README's robot without friction of its own under an even torque, its joint velocity measured too.
SimulationRun left_alone(SimulationRun run) {
  run.engine.step = kStep;
  run.command("motor", kPush);
  run.structure.robot.joints[0].damping = 0.0;
  SensorSpec velocity = run.structure.robot.sensors[0];
  velocity.name = "rate";
  velocity.kind = SensorKind::joint_velocity;
  run.structure.robot.sensors.push_back(velocity);
  return run;
}

/// Kinetic energy, and potential energy of weight and motor, along the motion of a servo pendulum, J.
Energies energies_of_pendulum(const SimulationRun& given) {
  const SimulationRun run = left_alone(given);
  const RobotSpec& robot = run.structure.robot;
  const BodySpec& arm = robot.bodies[0];
  const double inertia = arm.inertia.yy + arm.mass * arm.com.squaredNorm() + robot.joints[0].armature +
                         robot.actuators[0].transmission.rotor_inertia;
  const double weight = arm.mass * kGravity * arm.com.norm();
  const TimeSeries motion = run.run(evenly_spaced(kEnd, 300)).readings;
  const Eigen::VectorXd q = column(motion, robot.sensors[0].name), v = column(motion, "rate");
  Energies result;
  for (Eigen::Index i = 0; i < q.size(); ++i)
    result.add(0.5 * inertia * v(i) * v(i), weight * (1.0 - std::cos(q(i))) - kPush * q(i));
  return result;
}

/// A ball that falls onto a ground that slopes down, as gravity has it.
SimulationRun ball(const PlacedEffect* effect) {
  constexpr double kMass = 2.0, kRadius = 0.1, kInertia = 0.4 * kMass * kRadius * kRadius;
  RobotSpec robot = floating_body(kMass, {.xx = kInertia, .yy = kInertia, .zz = kInertia});
  robot.bodies[0].position = {0.0, 0.0, kRadius + 0.05};
  robot.bodies[0].shapes = {{.kind = ShapeKind::sphere, .size = {kRadius, 0.0, 0.0}}};
  robot.gravity = {1.0, 0.0, -kGravity};
  robot.contact = {.ground = true, .friction = 0.5};
  SimulationRun run(robot, kStep);
  if (effect) run.structure.effects = {*effect};
  return run;
}

Energies energies_of_ball(const SimulationRun& run) {
  const TimeSeries motion = run.run(evenly_spaced(kEnd, 300)).readings;
  const BodySpec& body = run.structure.robot.bodies[0];
  const auto at = [&](const char* channel, Eigen::Index i) { return column(motion, channel)(i); };
  Energies result;
  for (Eigen::Index i = 0; i < motion.times.size(); ++i) {
    const Eigen::Vector3d x(at("position.x", i), at("position.y", i), at("position.z", i));
    const Eigen::Vector3d v(at("velocity.x", i), at("velocity.y", i), at("velocity.z", i));
    const Eigen::Vector3d w(at("spin.x", i), at("spin.y", i), at("spin.z", i));
    result.add(0.5 * body.mass * v.squaredNorm() + 0.5 * body.inertia.yy * w.squaredNorm(),
               -body.mass * run.structure.robot.gravity.dot(x));
  }
  return result;
}

void expect_dissipation(const Energies& with, const Energies& without) {
  const double error = kError * with.largest_kinetic;
  EXPECT_LT(with.sum.back(), without.sum.back() - 2.0 * error);
  double least = with.sum.front(), most_risen = 0.0;
  for (const double energy : with.sum) {
    least = std::min(least, energy);
    most_risen = std::max(most_risen, energy - least);
  }
  EXPECT_LE(most_risen, error);
}

TEST(EffectConformance, DissipativeOnesDissipate) {
  int checked = 0;
  on_every_effect([&](const std::string& name, const PhysicalEffect& effect) {
    if (!effect.describe().dissipative) return;
    const ModelDefinition model = readme_model(name);
    if (model.structure.effects.front().elements.size() > 1) return;  // not on a pendulum: tests/effects has its energy
    ++checked;
    if (model.structure.effects.front().kind == ElementKind::world)
      expect_dissipation(energies_of_ball(ball(&model.structure.effects.front())), energies_of_ball(ball(nullptr)));
    else
      expect_dissipation(energies_of_pendulum(moving(model)), energies_of_pendulum(moving_without(model)));
  });
  EXPECT_GT(checked, 2);
}

}  // namespace
}  // namespace lacuna

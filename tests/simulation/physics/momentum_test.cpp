#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace lacuna::momentum_test {
namespace {

constexpr double kBodyInertia = 0.5, kBaseMass = 3.0, kBaseInertia = 0.9;

/// Two floating bodies that a driven joint, with all its laws, holds together.
RobotSpec floating_pair(JointKind kind) {
  RobotSpec robot = one_joint(kind, kBodyInertia, Eigen::Vector3d(1, -2, 3).normalized());
  robot.bodies[0].position = {0.3, 0.2, 0.5};
  robot.bodies.push_back(plain_body("base", kBaseMass, kBaseInertia));
  robot.bodies[1].position = {-0.4, 0.6, 0.2};
  JointSpec& joint = robot.joints[0];
  joint.parent = "base";
  joint.anchor = {0.1, 0.1, 0.1};
  joint.stiffness = 4.0;
  joint.damping = 0.3;
  joint.dry_friction = 0.2;
  joint.force = -0.4;
  joint.upper = 0.6;
  for (const std::string body : {"body", "base"}) {
    robot.sensors.push_back(make_sensor(body + "_position", SensorKind::body_position, body));
    robot.sensors.push_back(make_sensor(body + "_velocity", SensorKind::body_velocity, body));
    robot.sensors.push_back(make_sensor(body + "_spin", SensorKind::body_angular_velocity, body));
  }
  return robot;
}

struct Momentum {
  Eigen::Vector3d linear, angular;
};

Momentum momentum_at_end(const TimeSeries& readings, const RobotSpec& robot) {
  Momentum sum{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const BodySpec& body : robot.bodies) {
    const Eigen::Vector3d p = body.mass * last_vector(readings, body.name + "_velocity");
    sum.linear += p;
    sum.angular += last_vector(readings, body.name + "_position").cross(p) +
                   body.inertia.xx * last_vector(readings, body.name + "_spin");
  }
  return sum;
}

class FloatingPair : public testing::TestWithParam<JointKind> {};
INSTANTIATE_TEST_SUITE_P(HingeAndSlider, FloatingPair, testing::Values(JointKind::hinge, JointKind::slider),
                         [](const auto& test) { return test.param == JointKind::hinge ? "Hinge" : "Slider"; });

TEST_P(FloatingPair, KeepsItsMomentumWhateverItsJointDoes) {
  const RobotSpec robot = floating_pair(GetParam());
  const auto moved = [&](const std::string& engine, double step) {
    SimulationRun run(robot, step);
    run.engine.engine = engine;
    run.command("motor", {0.0, 0.5, 1.0}, {3.0, -2.0, 4.0}, Hold::zero_order);
    const TimeSeries readings = run.run({0.0, 1.5}).readings;
    EXPECT_GT(last_vector(readings, "body_velocity").norm() + last_vector(readings, "body_spin").norm(), 0.1);
    return momentum_at_end(readings, robot);
  };
  const Momentum coarse = moved("ode", 1e-3), fine = moved("ode", 1.25e-4);
  EXPECT_NEAR(coarse.linear.norm(), 0.0, kRounding);
  // What the joint's own correction and the moving lever arms leave is of first order.
  constexpr double kAngularError = 5e-3;  // kg·m²/s
  EXPECT_LE(coarse.angular.norm(), kAngularError);
  EXPECT_LE(fine.angular.norm(), kAngularError / 6);
  // Of second order in joint coordinates: an eighth of the step leaves a 64th.
  const Momentum reduced = moved("articulated", 1e-3), finer = moved("articulated", 1.25e-4);
  EXPECT_LE(reduced.linear.norm(), 1e-5);
  EXPECT_LE(finer.linear.norm(), reduced.linear.norm() / 50.0);
  EXPECT_LE(reduced.angular.norm(), 1e-5);
  EXPECT_LE(finer.angular.norm(), reduced.angular.norm() / 50.0);
}

TEST_P(FloatingPair, VelocityIsTheRateOfThePosition) {
  constexpr double kStep = 1e-4, kEnd = 1.2;
  SimulationRun run(floating_pair(GetParam()), kStep);
  run.command("motor", {0.0, 0.5}, {3.0, -2.0}, Hold::zero_order);
  const TimeSeries readings = run.run({0.0, kEnd - kStep, kEnd + kStep}).readings;
  const Eigen::VectorXd q = column(readings, "position");
  const double velocity = 0.5 * (column(readings, "velocity")(1) + column(readings, "velocity")(2));
  constexpr double kRateError = 2e-3;  // of 2.5; half a step lies between the two
  EXPECT_GT(std::abs(velocity), 0.02);
  EXPECT_NEAR((q(2) - q(1)) / (2.0 * kStep), velocity, kRateError);
}

}  // namespace
}  // namespace lacuna::momentum_test

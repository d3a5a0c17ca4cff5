#include "plugins/built_catalog.h"
#include "support/kick.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

/// Bodies on the ground, against textbook solutions.
namespace lacuna::contact_test {
namespace {

constexpr double kMass = 2.0, kRadius = 0.1;
constexpr double kSphere = 0.4 * kMass * kRadius * kRadius;  // kg·m², of a solid sphere

const PhysicalEffect& effect(const std::string& name) { return built_catalog().get<PhysicalEffect>(name); }

/// A solid sphere `height` above the ground.
RobotSpec sphere(double height) {
  RobotSpec robot = floating_body(kMass, {.xx = kSphere, .yy = kSphere, .zz = kSphere});
  ShapeSpec ball;
  ball.kind = ShapeKind::sphere;
  ball.size = {kRadius, 0.0, 0.0};
  robot.bodies[0].shapes = {ball};
  robot.bodies[0].position = {0.0, 0.0, kRadius + height};
  robot.contact.ground = true;
  return robot;
}

/// A flat box that lies on the ground.
RobotSpec box() {
  RobotSpec robot = floating_body(kMass, {.xx = 0.02, .yy = 0.02, .zz = 0.04});
  ShapeSpec shape;
  shape.size = {0.3, 0.3, 0.1};
  robot.bodies[0].shapes = {shape};
  robot.bodies[0].position = {0.0, 0.0, 0.05};
  robot.contact = {.ground = true, .stiffness = 1e6, .damping = 1e4};
  return robot;
}

SimulationRun on_ground(RobotSpec robot, const std::string& name, std::vector<double> values, double step) {
  SimulationRun run(std::move(robot), step);
  run.place(effect(name), ElementKind::world, {}, std::move(values));
  return run;
}

TEST(Restitution, ThrowsASphereBackToTheSquareOfItsCoefficient) {
  constexpr double kHeight = 0.5, kCoefficient = 0.6;
  const SimulationRun run = on_ground(sphere(kHeight), "restitution", {kCoefficient}, 1e-4);
  const double fall = std::sqrt(2.0 * kHeight / kGravity);
  const double top = run.last("position.z", fall * (1.0 + kCoefficient)) - kRadius;
  EXPECT_NEAR(top, kCoefficient * kCoefficient * kHeight, 3e-4);
}

TEST(ContactCompliance, AgreesWithAnIndependentIntegration) {
  constexpr double kStiffness = 5e3, kDamping = 0.8, kHeight = 0.2, kEnd = 0.35;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    const double depth = kRadius - x[0];
    const double force = depth > 0.0 ? kStiffness * depth * (1.0 - kDamping * x[1]) : 0.0;
    dx = {x[1], std::max(0.0, force) / kMass - kGravity};
  };
  const double expected = integrate_in_steps(motion, {kRadius + kHeight, 0.0}, {0.0, kEnd}, 1e-5).back()[0];
  EXPECT_GT(expected, kRadius + 0.01);  // it has come off the ground again
  const auto height = [&](double step) {
    return on_ground(sphere(kHeight), "contact_compliance", {kStiffness, kDamping}, step).last("position.z", kEnd);
  };
  EXPECT_NEAR(height(1e-4), expected, 1e-3);
  EXPECT_NEAR(height(1e-5), expected, 1e-4);
}

TEST(RollingResistance, SlowsARollingSphereEvenly) {
  constexpr double kLever = 0.004, kSpeed = 1.0, kEnd = 1.5;
  SimulationRun run = on_ground(sphere(0.0), "rolling_resistance", {kLever}, 1e-3);
  const Kick kick;
  run.place(kick, ElementKind::body, {0}, {kMass * kSpeed, 0.0, 0.0, 0.0, kSphere * kSpeed / kRadius, 0.0});
  const double braking = kLever * kGravity / kRadius / (1.0 + 0.4);
  const double expected = kSpeed * kEnd - 0.5 * braking * kEnd * kEnd;
  EXPECT_NEAR(run.last("position.x", kEnd), expected, 5e-4);
  EXPECT_NEAR(run.last("velocity.x", 8.0), 0.0, 1e-3) << "it stops and stays";
}

TEST(WheelSlip, LetsABoxCreepInProportionToTheForce) {
  constexpr double kCreep = 0.02, kPull = 4.0, kPoints = 4.0, kEnd = 2.0;
  SimulationRun run = on_ground(box(), "wheel_slip", {kCreep}, 1e-3);
  run.place(effect("cable_pull"), ElementKind::body, {0}, {kPull, 1e2, 0.0, 0.05});
  const double creeping = run.last("position.x", kEnd) - run.last("position.x", 1.0);
  EXPECT_NEAR(creeping, kCreep * kPull / kPoints * (kEnd - 1.0), 0.02 * kCreep * kPull);
}

TEST(ContactCompliance, IsInSeriesWithTheRobotsOwn) {
  // Two springs of 4 and 12 kN/m in a row are one of 3 kN/m: the sphere sinks in by its weight over that.
  RobotSpec robot = sphere(0.0);
  robot.contact.stiffness = 12e3;
  robot.contact.damping = 60.0;
  const double height = on_ground(robot, "contact_compliance", {4e3, 0.0}, 1e-3).last("position.z", 5.0);
  EXPECT_NEAR(height, kRadius - kMass * kGravity / 3e3, 1e-6);
}

TEST(ContactEffects, RefuseARobotWithoutGround) {
  RobotSpec robot = sphere(0.0);
  robot.contact.ground = false;
  for (const char* name :
       {"contact_compliance", "contact_friction", "restitution", "rolling_resistance", "slope", "wheel_slip"}) {
    std::vector<double> values;
    for (const ParameterDeclaration& parameter : effect(name).describe().parameters)
      values.push_back(parameter.default_value);
    EXPECT_THAT(
        [&] {
          effect(name).amend(robot, {values, {}, ElementKind::world, 1e-3});
        },
        testing::ThrowsMessage<Error>(testing::HasSubstr("no ground")))
        << name;
  }
}

TEST(ContactFriction, LetsABoxSlideDownASlopeWithTheKnownAcceleration) {
  constexpr double kFriction = 0.3, kAngle = 0.4, kEnd = 1.0;
  RobotSpec robot = box();
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(kAngle, Eigen::Vector3d::UnitY()));
  robot.bodies[0].orientation = tilt;
  robot.bodies[0].position = tilt * robot.bodies[0].position;
  SimulationRun run = on_ground(robot, "contact_friction", {kFriction}, 1e-3);
  run.place(effect("slope"), ElementKind::world, {}, {kAngle});
  const double expected = 0.5 * kGravity * (std::sin(kAngle) - kFriction * std::cos(kAngle)) * kEnd * kEnd;
  const TimeSeries readings = run.run({0.0, kEnd}).readings;
  const Eigen::Vector3d way = last_vector(readings, "position") - robot.bodies[0].position;
  EXPECT_NEAR(way.norm(), expected, 2e-3 * expected);
  EXPECT_LT(way.z(), 0.0);
}

}  // namespace
}  // namespace lacuna::contact_test

#include "support/kick.h"
#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace lacuna::sensor_test {
namespace {

constexpr double kStep = 1e-3;
const Eigen::Vector3d kWeight(0.0, 0.0, -kGravity);

/// A link that turns evenly about an askew axis, its frame's origin and its centre of mass both off the axis.
struct TurningLink {
  Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 2).normalized();
  Eigen::Vector3d anchor{0.1, 0.0, -0.3};
  Eigen::Vector3d origin{0.4, 0.2, 0.1};
  Eigen::Quaterniond pose{Eigen::AngleAxisd(0.6, Eigen::Vector3d(0, 1, 1).normalized())};
  double rate = 3.0;

  RobotSpec robot() const {
    RobotSpec spec = one_joint(JointKind::hinge, 0.3, axis);
    spec.joints[0].anchor = anchor;
    BodySpec& body = spec.bodies[0];
    body.position = origin;
    body.orientation = pose;
    body.com = {0.05, -0.1, 0.2};
    SensorSpec range = make_sensor("range", SensorKind::beacon_range, "body");
    range.beacon = {-1.0, 2.0, 0.5};
    spec.sensors = {make_sensor("position", SensorKind::body_position, "body"),
                    make_sensor("velocity", SensorKind::body_velocity, "body"),
                    make_sensor("orientation", SensorKind::body_orientation, "body"),
                    make_sensor("spin", SensorKind::body_angular_velocity, "body"), range};
    return spec;
  }
  Eigen::Quaterniond turn(double time) const { return Eigen::Quaterniond(Eigen::AngleAxisd(rate * time, axis)); }
  Eigen::Vector3d place(double time) const { return anchor + turn(time) * (origin - anchor); }
};

Eigen::Vector3d vector_at(const TimeSeries& readings, const std::string& sensor, Eigen::Index row) {
  return {column(readings, sensor + ".x")(row), column(readings, sensor + ".y")(row),
          column(readings, sensor + ".z")(row)};
}

TEST(BodySensors, ReadTheFramesOriginInTheWorld) {
  const TurningLink link;
  // A servo keeps the turning even; what the engine's joint gives way under the centrifugal force is the tolerance.
  RobotSpec robot = link.robot();
  robot.actuators[0].kind = ActuatorKind::velocity_servo;
  robot.actuators[0].kd = 1e9;
  const SimulationRun run = SimulationRun(robot, kStep).from({0.0}, {link.rate}).command("motor", link.rate);
  const TimeSeries readings = run.run(evenly_spaced(2.0, 20)).readings;
  constexpr double kWay = 2e-3;  // m, m/s, rad
  for (Eigen::Index row = 0; row < readings.times.size(); ++row) {
    const double time = readings.times(row);
    const Eigen::Vector3d place = link.place(time);
    EXPECT_NEAR((vector_at(readings, "position", row) - place).norm(), 0.0, kWay);
    const Eigen::Vector3d velocity = (link.rate * link.axis).cross(place - link.anchor);
    EXPECT_NEAR((vector_at(readings, "velocity", row) - velocity).norm(), 0.0, 3.0 * kWay);
    EXPECT_NEAR((vector_at(readings, "spin", row) - link.rate * link.axis).norm(), 0.0, kWay);
    EXPECT_NEAR(column(readings, "range")(row), (place - Eigen::Vector3d(-1.0, 2.0, 0.5)).norm(), kWay);
  }
}

/// Towards the axis by the square of the rate, and away from the ground as if the whole room rose.
TEST(BodySensors, AnAccelerometerReadsItsPointLessGravityAlongTheBodysAxes) {
  const TurningLink link;
  const Eigen::Vector3d at(0.3, -0.2, 0.1);
  RobotSpec robot = link.robot();
  robot.gravity = {0.5, 0.0, -9.81};
  robot.actuators[0].kind = ActuatorKind::velocity_servo;
  robot.actuators[0].kd = 1e9;
  robot.sensors = {make_sensor("imu", SensorKind::accelerometer, "body")};
  robot.sensors[0].at = at;
  const SimulationRun run = SimulationRun(robot, kStep).from({0.0}, {link.rate}).command("motor", link.rate);
  const TimeSeries readings = run.run(evenly_spaced(2.0, 20)).readings;
  const auto expected = [&](double time) {
    const Eigen::Quaterniond orientation = link.turn(time) * link.pose;
    const Eigen::Vector3d arm = link.turn(time) * (link.origin - link.anchor) + orientation * at;
    const Eigen::Vector3d spin = link.rate * link.axis;
    return Eigen::Vector3d(orientation.conjugate() * (spin.cross(spin.cross(arm)) - robot.gravity));
  };
  EXPECT_NEAR((vector_at(readings, "imu", 0) - link.pose.conjugate() * -robot.gravity).norm(), 0.0, 1e-9) << "at rest";
  for (Eigen::Index row = 1; row < readings.times.size(); ++row)
    EXPECT_NEAR((vector_at(readings, "imu", row) - expected(readings.times(row))).norm(), 0.0, 0.05);  // m/s²
}

TEST(BodySensors, OrientationKeepsItsSignConvention) {
  const TurningLink link;
  const SimulationRun run = SimulationRun(link.robot(), kStep).from({0.0}, {link.rate});
  const TimeSeries readings = run.run({0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0}).readings;
  SimulationRun watched = run;
  watched.structure.robot.sensors.push_back(make_sensor("angle", SensorKind::joint_position, "joint"));
  const Eigen::VectorXd angle = column(watched.run({0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0}).readings, "angle");
  for (Eigen::Index row = 0; row < readings.times.size(); ++row) {
    const Eigen::Quaterniond read(column(readings, "orientation.w")(row), column(readings, "orientation.x")(row),
                                  column(readings, "orientation.y")(row), column(readings, "orientation.z")(row));
    EXPECT_GE(read.w(), 0.0);
    EXPECT_NEAR(read.norm(), 1.0, kRounding);
    const Eigen::Quaterniond expected = Eigen::Quaterniond(Eigen::AngleAxisd(angle(row), link.axis)) * link.pose;
    EXPECT_NEAR(read.angularDistance(expected), 0.0, 5e-3);
  }
}

TEST(BodySensors, VelocityOfATumblingBodyIsThatOfItsOrigin) {
  RobotSpec robot = floating_body(2.0, {.xx = 0.3, .yy = 0.3, .zz = 0.3});
  robot.gravity.setZero();
  robot.bodies[0].com = {0.2, 0.0, 0.0};
  const Kick kick;
  SimulationRun run(robot, kStep);
  run.engine.engine = "ode";  // a step's force moves it for the whole of that step
  run.place(kick, ElementKind::body, {0}, {2.0, 0, 0, 0, 0, 0.6});  // 1 m/s along x, 2 rad/s about z
  const TimeSeries readings = run.run(evenly_spaced(1.0, 10)).readings;
  for (Eigen::Index row = 1; row < readings.times.size(); ++row) {
    const double angle = 2.0 * readings.times(row);
    const Eigen::Vector3d com_to_origin(-0.2 * std::cos(angle), -0.2 * std::sin(angle), 0.0);
    const Eigen::Vector3d velocity = Eigen::Vector3d::UnitX() + Eigen::Vector3d(0, 0, 2.0).cross(com_to_origin);
    const Eigen::Vector3d place = Eigen::Vector3d(0.2 + readings.times(row), 0.0, 0.0) + com_to_origin;
    EXPECT_NEAR((vector_at(readings, "velocity", row) - velocity).norm(), 0.0, 1e-6);
    EXPECT_NEAR((vector_at(readings, "position", row) - place).norm(), 0.0, 1e-6);
  }
}

TEST(JointForceSensor, AddsActuatorAndJointLaws) {
  RobotSpec robot = one_joint(JointKind::slider, 2.0);
  robot.joints[0].force = 0.5;
  EXPECT_NEAR(SimulationRun(robot, kStep).command("motor", 3.0).last("force", 0.1), 3.5, 1e-6);
  robot.joints[0].damping = 4.0;
  // At the final velocity the damping takes all that drives.
  EXPECT_NEAR(SimulationRun(robot, kStep).command("motor", 3.0).last("force", 20.0), 0.0, 1e-6);
  EXPECT_NEAR(SimulationRun(robot, kStep).command("motor", 3.0).last("velocity", 20.0), 3.5 / 4.0, 1e-6);
}

TEST(JointForceSensor, ReadsTheSpringTheServoAndTheFriction) {
  for (const double sign : {1.0, -1.0}) {
    RobotSpec robot = pendulum(0.7, 0.4, 0.02);
    const double load = 0.7 * kGravity * 0.4 * std::sin(0.5 * sign);
    robot.actuators[0].kind = ActuatorKind::position_servo;
    robot.actuators[0].kp = 1e6;
    robot.actuators[0].kd = 1e4;
    SimulationRun held(robot, kStep);
    held.from({0.5 * sign}, {0.0}).command("motor", 0.5 * sign);
    EXPECT_NEAR(held.last("force", 1.0), load, 1e-3);

    RobotSpec rough = pendulum(0.7, 0.4, 0.02);
    rough.joints[0].dry_friction = 3.0;
    EXPECT_NEAR(SimulationRun(rough, kStep).from({0.5 * sign}, {0.0}).last("force", 1.0), load, 1e-3);
  }
}

RobotSpec ball_above_ground(double height) {
  RobotSpec robot = floating_body(2.0, {.xx = 0.01, .yy = 0.01, .zz = 0.01});
  ShapeSpec sphere;
  sphere.kind = ShapeKind::sphere;
  sphere.size = {0.1, 0.0, 0.0};
  robot.bodies[0].shapes = {sphere};
  robot.bodies[0].position = {0.0, 0.0, 0.1 + height};
  robot.contact = {.ground = true, .stiffness = 2e4, .damping = 300.0, .friction = 1.0};
  robot.sensors.push_back(make_sensor("touch", SensorKind::touch, "body"));
  robot.sensors.push_back(make_sensor("contact", SensorKind::contact_force, "body"));
  return robot;
}

TEST(TouchSensor, TurnsWhenTheBodyHasFallen) {
  constexpr double kHeight = 0.2;
  const double falls_for = std::sqrt(2.0 * kHeight / kGravity);
  const SimulationRun run(ball_above_ground(kHeight), kStep);
  const TimeSeries readings = run.run({0.0, falls_for - 3.0 * kStep, falls_for + 3.0 * kStep, 3.0}).readings;
  const Eigen::VectorXd touch = column(readings, "touch");
  EXPECT_EQ(touch(0), -1.0);
  EXPECT_EQ(touch(1), -1.0);
  EXPECT_EQ(touch(2), 1.0);
  EXPECT_EQ(touch(3), 1.0);
  EXPECT_NEAR(vector_at(readings, "contact", 1).norm(), 0.0, kRounding);
}

TEST(ContactForceSensor, ReadsTheWeightAtRest) {
  const SimulationRun run(ball_above_ground(0.0), kStep);
  const TimeSeries readings = run.run({0.0, 3.0}).readings;
  EXPECT_NEAR((last_vector(readings, "contact") + 2.0 * kWeight).norm(), 0.0, 1e-3);
  // The ground gives way like the spring it is.
  EXPECT_NEAR(last_vector(readings, "position").z(), 0.1 - 2.0 * kGravity / 2e4, 1e-5);
}

TEST(ContactForceSensor, HoldsAgainstAHorizontalPull) {
  RobotSpec robot = ball_above_ground(0.0);
  ShapeSpec box;
  box.size = {0.2, 0.2, 0.2};
  robot.bodies[0].shapes = {box};
  robot.gravity = {2.0, 1.0, -kGravity};
  const TimeSeries readings = SimulationRun(robot, kStep).run({0.0, 2.0}).readings;
  EXPECT_NEAR((last_vector(readings, "contact") + 2.0 * robot.gravity).norm(), 0.0, 0.02);
}

TEST(GroundContact, IsTheSpringDamperOfItsConstants) {
  // A mass on a spring and damper that it cannot leave: a damped oscillation about the rest position.
  constexpr double kMass = 2.0, kStiffness = 4000.0, kDamping = 60.0, kEnd = 0.1;
  RobotSpec robot = ball_above_ground(0.0);
  robot.contact.stiffness = kStiffness;
  robot.contact.damping = kDamping;
  const Derivative motion = [](const ReferenceState& x, ReferenceState& dx, double) {
    dx = {x[1], -kGravity + (-kStiffness * x[0] - kDamping * x[1]) / kMass};
  };
  const double expected = integrate_smooth(motion, {0.0, 0.0}, {0.0, kEnd}).back()[0];
  const auto error = [&](double step) { return SimulationRun(robot, step).last("position.z", kEnd) - 0.1 - expected; };
  EXPECT_LE(std::abs(error(kStep)), 5e-4);
  EXPECT_LE(std::abs(error(kStep / 8)), 1e-4);
}

}  // namespace
}  // namespace lacuna::sensor_test

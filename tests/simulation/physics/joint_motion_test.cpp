#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace lacuna::joint_motion_test {
namespace {

constexpr double kInertia = 0.5;  // kg·m², about every axis through the joint

RobotSpec free_joint(JointKind kind) {
  RobotSpec robot = one_joint(kind, kInertia, Eigen::Vector3d::UnitZ());
  robot.joints[0].axis2 = Eigen::Vector3d::UnitX();
  robot.actuators.clear();
  return robot;
}

TEST(BallJoint, TurnsEvenlyAboutAFixedAxis) {
  const Eigen::Vector3d rate = 1.4 * Eigen::Vector3d(1, -2, 2).normalized();
  const TimeSeries readings = SimulationRun(free_joint(JointKind::ball))
                                  .from({0.0, 0.0, 0.0}, {rate.x(), rate.y(), rate.z()})
                                  .run({0.0, 0.5, 1.5})
                                  .readings;
  constexpr double kTurnError = 1e-5;  // rad, rad/s
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) {
      const std::string channel = "." + std::to_string(i + 1);
      EXPECT_NEAR(column(readings, "position" + channel)(row), rate(i) * readings.times(row), kTurnError);
      EXPECT_NEAR(column(readings, "velocity" + channel)(row), rate(i), kTurnError);
    }
  }
}

TEST(BallJoint, DampsAllItsCoordinates) {
  RobotSpec robot = free_joint(JointKind::ball);
  robot.joints[0].damping = 2.0;
  constexpr double kEnd = 0.4, kRate = 1e-2;  // rad/s
  const double expected = std::exp(-2.0 / kInertia * kEnd);
  for (const char* channel : {"velocity.1", "velocity.2", "velocity.3"}) {
    const auto error = [&](double step) {
      return SimulationRun(robot, step).from({0.0, 0.0, 0.0}, {kRate, kRate, kRate}).last(channel, kEnd) / kRate -
             expected;
    };
    expect_convergence(error, 1e-3, 5e-3);
  }
}

TEST(UniversalJoint, SwingsOnItsSpringsInBothCoordinates) {
  RobotSpec robot = free_joint(JointKind::universal);
  robot.joints[0].stiffness = 40.0;
  constexpr double kEnd = 0.3, kFirst = 2e-3, kSecond = -1e-3;  // rad, small: the coordinates do not mix
  const double expected = std::cos(std::sqrt(40.0 / kInertia) * kEnd);
  for (const auto& coordinate : {std::pair{"position.1", kFirst}, std::pair{"position.2", kSecond}}) {
    const char* channel = coordinate.first;
    const double start = coordinate.second;
    const auto error = [&](double step) {
      return SimulationRun(robot, step).from({kFirst, kSecond}, {0.0, 0.0}).last(channel, kEnd) / start - expected;
    };
    expect_convergence(error, 1e-3, 0.02);
  }
}

TEST(UniversalJoint, DampsBothCoordinates) {
  RobotSpec robot = free_joint(JointKind::universal);
  robot.joints[0].damping = 2.0;
  constexpr double kEnd = 0.4, kRate = 1e-2;  // rad/s
  const double expected = std::exp(-2.0 / kInertia * kEnd);
  for (const char* channel : {"velocity.1", "velocity.2"}) {
    const auto error = [&](double step) {
      return SimulationRun(robot, step).from({0.0, 0.0}, {kRate, kRate}).last(channel, kEnd) / kRate - expected;
    };
    expect_convergence(error, 1e-3, 5e-3);
  }
}

TEST(UniversalJoint, CountsTheTurnsOfItsFirstAxis) {
  for (const double rate : {7.0, -7.0}) {
    const SimulationRun run = SimulationRun(free_joint(JointKind::universal)).from({0.0, 0.0}, {rate, 0.0});
    EXPECT_NEAR(run.last("position.1", 2.0), 2.0 * rate, 1e-3);
    EXPECT_NEAR(run.last("position.2", 2.0), 0.0, 1e-3);
  }
}

TEST(UniversalJoint, RestoresItsState) {
  RobotSpec robot = free_joint(JointKind::universal);
  robot.joints[0].stiffness = 40.0;
  robot.joints[0].dry_friction = 0.1;
  expect_same_bits_after_restore(SimulationRun(robot).from({4.0, 0.5}, {3.0, -2.0}), {0.0, 0.1, 0.2, 0.3, 0.4}, 2);
}

TEST(BallJoint, RestoresItsState) {
  RobotSpec robot = free_joint(JointKind::ball);
  robot.bodies[0].com = {0.1, 0.0, -0.2};
  robot.gravity = {0.0, 0.0, -kGravity};
  expect_same_bits_after_restore(SimulationRun(robot).from({0.3, 0.2, -0.5}, {1.0, 2.0, 3.0}),
                                 {0.0, 0.1, 0.2, 0.3, 0.4}, 2);
}

class CarriedJoint : public testing::TestWithParam<JointKind> {};
INSTANTIATE_TEST_SUITE_P(HingeAndSlider, CarriedJoint, testing::Values(JointKind::hinge, JointKind::slider),
                         [](const auto& test) { return test.param == JointKind::hinge ? "Hinge" : "Slider"; });

/// A joint along x on a base that stands turned by a right angle about z: the joint's axis has become y.
SimulationRun carried(JointKind kind, double step) {
  RobotSpec robot = one_joint(kind, kInertia, Eigen::Vector3d::UnitX());
  robot.bodies.push_back(plain_body("base", 1.0, 1.0));
  robot.joints[0].parent = "base";
  JointSpec turntable;
  turntable.name = "turntable";
  turntable.child = "base";
  turntable.axis = Eigen::Vector3d::UnitZ();
  turntable.dry_friction = 1e6;  // it stays
  robot.joints.push_back(turntable);
  SimulationRun run(robot, step);
  run.from({0.0, std::numbers::pi / 2}, {1.5, 0.0});
  return run;
}

TEST_P(CarriedJoint, IsDampedAlongItsTurnedAxis) {
  constexpr double kEnd = 0.4;
  const double expected = 1.5 * std::exp(-2.0 / kInertia * kEnd);
  const auto error = [&](double step) {
    SimulationRun run = carried(GetParam(), step);
    run.structure.robot.joints[0].damping = 2.0;
    return run.last("velocity", kEnd) - expected;
  };
  expect_convergence(error, 1e-3, 5e-3);
}

TEST_P(CarriedJoint, IsStoppedByFrictionAndServoAlongItsTurnedAxis) {
  SimulationRun rough = carried(GetParam(), 1e-3), served = carried(GetParam(), 1e-3);
  rough.structure.robot.joints[0].dry_friction = 2.0;
  EXPECT_NEAR(rough.last("position", 1.0), 1.5 * 1.5 * kInertia / (2.0 * 2.0), 1e-3);
  served.structure.robot.actuators[0].kind = ActuatorKind::velocity_servo;
  served.structure.robot.actuators[0].kd = 100.0;
  EXPECT_NEAR(served.last("velocity", 1.0), 0.0, 1e-6);
}

TEST_P(CarriedJoint, IsDrivenAndStoppedAlongItsTurnedAxis) {
  SimulationRun run = carried(GetParam(), 1e-3);
  run.from({0.0, std::numbers::pi / 2}, {0.0, 0.0});
  run.command("motor", 2.0);
  EXPECT_NEAR(run.last("velocity", 0.5), 2.0 / kInertia * 0.5, 1e-6);
  run.structure.robot.joints[0].upper = 0.2;
  constexpr double kPenetration = 2e-3;
  EXPECT_NEAR(run.last("position", 2.0), 0.2, kPenetration);
}

/// A box that falls, tumbles and slides down a slope.
TEST(Contact, RestoresItsState) {
  RobotSpec robot = floating_body(2.0, {.xx = 0.02, .yy = 0.03, .zz = 0.04});
  ShapeSpec box;
  box.size = {0.3, 0.2, 0.1};
  robot.bodies[0].shapes = {box};
  robot.bodies[0].position = {0.0, 0.0, 0.3};
  robot.bodies[0].orientation = Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 1, 0).normalized());
  robot.contact = {.ground = true, .stiffness = 2e4, .damping = 300.0, .friction = 0.4, .slope = 0.3};
  robot.sensors.push_back(make_sensor("touch", SensorKind::touch, "body"));
  robot.sensors.push_back(make_sensor("contact", SensorKind::contact_force, "body"));
  SimulationRun run(robot);
  std::vector<double> times;
  for (int i = 0; i <= 50; ++i) times.push_back(0.02 * i);
  for (const std::size_t middle : {11UL, 14UL, 30UL}) expect_same_bits_after_restore(run, times, middle);
}

}  // namespace
}  // namespace lacuna::joint_motion_test

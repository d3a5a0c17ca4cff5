#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace lacuna::joint_frame_test {
namespace {

constexpr double kSameFrame = 1e-6;  // rad, m and their rates; the engine's joints drift a little

Eigen::Vector3d reading_vector(const TimeSeries& readings, const std::string& sensor, Eigen::Index row) {
  const auto value = [&](const char* axis) { return column(readings, sensor + axis)(row); };
  return {value(".x"), value(".y"), value(".z")};
}

Eigen::Quaterniond reading_orientation(const TimeSeries& readings, const std::string& sensor, Eigen::Index row) {
  const auto value = [&](const char* part) { return column(readings, sensor + part)(row); };
  return {value(".w"), value(".x"), value(".y"), value(".z")};
}

void watch(RobotSpec& robot, const std::string& body) {
  robot.sensors.push_back(make_sensor(body + "_position", SensorKind::body_position, body));
  robot.sensors.push_back(make_sensor(body + "_velocity", SensorKind::body_velocity, body));
  robot.sensors.push_back(make_sensor(body + "_orientation", SensorKind::body_orientation, body));
  robot.sensors.push_back(make_sensor(body + "_spin", SensorKind::body_angular_velocity, body));
}

const Eigen::Vector3d kAnchor(0.3, -0.2, 0.5);
const Eigen::Quaterniond kChildPose(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
const Eigen::Quaterniond kParentPose(Eigen::AngleAxisd(-1.1, Eigen::Vector3d(0, 1, 3).normalized()));

/// A joint to the world, or to a floating body `base`; both bodies lie askew.
RobotSpec askew(JointKind kind, const Eigen::Vector3d& axis, bool floating) {
  RobotSpec robot = one_joint(kind, 0.5, axis);
  robot.bodies[0].position = {0.1, 0.2, 0.3};
  robot.bodies[0].orientation = kChildPose;
  robot.joints[0].anchor = kAnchor;
  if (kind == JointKind::ball || kind == JointKind::universal || kind == JointKind::fixed) robot.actuators.clear();
  if (kind == JointKind::fixed) robot.sensors.clear();
  watch(robot, "body");
  if (floating) {
    robot.bodies.push_back(plain_body("base", 3.0, 0.9));
    robot.bodies[1].position = {-0.4, 0.6, 0.2};
    robot.bodies[1].orientation = kParentPose;
    robot.joints[0].parent = "base";
    watch(robot, "base");
  }
  return robot;
}

struct Placement {
  std::string name;
  Eigen::Vector3d axis;
  bool floating;
};

class JointFrame : public testing::TestWithParam<Placement> {};

std::vector<Placement> placements() {
  const std::pair<std::string, Eigen::Vector3d> axes[] = {{"PlusX", {1, 0, 0}},
                                                          {"MinusX", {-1, 0, 0}},
                                                          {"PlusY", {0, 1, 0}},
                                                          {"MinusY", {0, -1, 0}},
                                                          {"PlusZ", {0, 0, 1}},
                                                          {"MinusZ", {0, 0, -1}},
                                                          {"Askew", Eigen::Vector3d(1, -2, 3).normalized()}};
  std::vector<Placement> all;
  for (const auto& [name, axis] : axes)
    for (const bool floating : {false, true}) all.push_back({name + (floating ? "OnBody" : "OnWorld"), axis, floating});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Axes, JointFrame, testing::ValuesIn(placements()),
                         [](const auto& test) { return test.param.name; });

/// How the child has turned since the zero configuration, seen from the parent's zero configuration.
Eigen::Quaterniond relative_turn(const TimeSeries& readings, Eigen::Index row, bool floating) {
  Eigen::Quaterniond child = reading_orientation(readings, "body_orientation", row) * kChildPose.conjugate();
  if (!floating) return child;
  const Eigen::Quaterniond parent = reading_orientation(readings, "base_orientation", row) * kParentPose.conjugate();
  return parent.conjugate() * child;
}

TEST_P(JointFrame, HingeStartsTurnedRightHandedChildAgainstParent) {
  const auto& [name, axis, floating] = GetParam();
  SimulationRun run(askew(JointKind::hinge, axis, floating));
  const TimeSeries readings = run.from({0.8}, {1.3}).run({0.0, 1e-3}).readings;
  EXPECT_NEAR(column(readings, "position")(0), 0.8, kSameFrame);
  EXPECT_NEAR(column(readings, "velocity")(0), 1.3, kSameFrame);
  const Eigen::Quaterniond expected(Eigen::AngleAxisd(0.8, axis));
  EXPECT_NEAR(relative_turn(readings, 0, floating).angularDistance(expected), 0.0, kSameFrame);
  EXPECT_NEAR((reading_vector(readings, "body_spin", 0) - 1.3 * axis).norm(), 0.0, kSameFrame);
  const Eigen::Vector3d arm = Eigen::Vector3d(0.1, 0.2, 0.3) - kAnchor;
  const Eigen::Vector3d turned = expected * arm;
  EXPECT_NEAR((reading_vector(readings, "body_position", 0) - kAnchor - turned).norm(), 0.0, kSameFrame);
  EXPECT_NEAR((reading_vector(readings, "body_velocity", 0) - (1.3 * axis).cross(turned)).norm(), 0.0, kSameFrame);
}

TEST_P(JointFrame, HingeTurnsRightHandedUnderAPositiveTorque) {
  const auto& [name, axis, floating] = GetParam();
  SimulationRun run(askew(JointKind::hinge, axis, floating));
  const TimeSeries readings = run.command("motor", 2.0).run({0.0, 0.7}).readings;
  const double q = column(readings, "position")(1), v = column(readings, "velocity")(1);
  EXPECT_GT(q, 0.3);
  EXPECT_GT(v, 0.5);
  constexpr double kTurnError = 2e-3;  // rad; the engine's joint error while moving
  const Eigen::Quaterniond turn = relative_turn(readings, 1, floating);
  EXPECT_NEAR(turn.angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(q, axis))), 0.0, kTurnError);
}

TEST_P(JointFrame, SliderMovesAlongItsAxisUnderAPositiveForce) {
  const auto& [name, axis, floating] = GetParam();
  SimulationRun run(askew(JointKind::slider, axis, floating));
  const TimeSeries readings = run.from({0.25}, {0.6}).command("motor", 1.5).run({0.0, 0.5}).readings;
  EXPECT_NEAR(column(readings, "position")(0), 0.25, kSameFrame);
  EXPECT_NEAR(column(readings, "velocity")(0), 0.6, kSameFrame);
  EXPECT_GT(column(readings, "velocity")(1), 1.0);
  const Eigen::Vector3d shift = reading_vector(readings, "body_position", 0) - Eigen::Vector3d(0.1, 0.2, 0.3);
  EXPECT_NEAR((shift - 0.25 * axis).norm(), 0.0, kSameFrame);
  EXPECT_NEAR((reading_vector(readings, "body_velocity", 0) - 0.6 * axis).norm(), 0.0, kSameFrame);
  const Eigen::Vector3d moved =
      reading_vector(readings, "body_position", 1) - reading_vector(readings, "body_position", 0);
  EXPECT_GT(moved.dot(axis), 0.0);
}

TEST_P(JointFrame, HingeCountsItsTurnsBothWays) {
  const auto& [name, axis, floating] = GetParam();
  RobotSpec robot = askew(JointKind::hinge, axis, floating);
  robot.bodies[0].position = kAnchor;  // on the axis: it keeps turning evenly
  if (floating) robot.bodies[1].position = kAnchor;
  for (const double rate : {9.0, -9.0}) {
    const TimeSeries readings = SimulationRun(robot).from({0.0}, {rate}).run({0.0, 0.5, 1.0, 2.0}).readings;
    constexpr double kTurnsError = 1e-3;  // rad of 18
    for (Eigen::Index row = 0; row < 4; ++row)
      EXPECT_NEAR(column(readings, "position")(row), rate * readings.times(row), kTurnsError);
    EXPECT_NEAR(column(readings, "velocity")(3), rate, kTurnsError);
  }
}

TEST_P(JointFrame, HingeMayStartBeyondATurn) {
  const auto& [name, axis, floating] = GetParam();
  const SimulationRun run = SimulationRun(askew(JointKind::hinge, axis, floating)).from({-7.5}, {0.0});
  EXPECT_NEAR(run.last("position", 0.1), -7.5, kSameFrame);
}

TEST_P(JointFrame, FixedJointHoldsItsPlace) {
  const auto& [name, axis, floating] = GetParam();
  RobotSpec robot = askew(JointKind::fixed, axis, floating);
  robot.gravity = 5.0 * axis;
  const TimeSeries readings = SimulationRun(robot).run({0.0, 0.5}).readings;
  constexpr double kHeld = 1e-4;
  EXPECT_NEAR(relative_turn(readings, 1, floating).angularDistance(Eigen::Quaterniond::Identity()), 0.0, kHeld);
  const Eigen::Vector3d moved =
      reading_vector(readings, "body_position", 1) - reading_vector(readings, "body_position", 0);
  const double fallen = floating ? 0.5 * 5.0 * 0.25 : 0.0;
  EXPECT_NEAR((moved - fallen * axis).norm(), 0.0, floating ? 2e-3 : kHeld);
}

TEST_P(JointFrame, BallReadsTheRotationVectorOfTheChild) {
  const auto& [name, axis, floating] = GetParam();
  SimulationRun run(askew(JointKind::ball, Eigen::Vector3d::UnitY(), floating));
  const Eigen::Vector3d turn = 0.9 * axis;
  // The rotation vector stands in the parent's frame, which lies askew in the world.
  const Eigen::Vector3d in_parent = floating ? Eigen::Vector3d(kParentPose.conjugate() * turn) : turn;
  run.from({in_parent.x(), in_parent.y(), in_parent.z()}, {0.0, 0.0, 0.0});
  const TimeSeries readings = run.run({0.0, 0.2}).readings;
  EXPECT_NEAR(relative_turn(readings, 0, floating).angularDistance(Eigen::Quaterniond(Eigen::AngleAxisd(0.9, axis))),
              0.0, kSameFrame);
  for (Eigen::Index row = 0; row < 2; ++row)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(column(readings, "position." + std::to_string(i + 1))(row), in_parent(i), kSameFrame);
}

TEST_P(JointFrame, BallReadsItsAngularVelocity) {
  const auto& [name, axis, floating] = GetParam();
  SimulationRun run(askew(JointKind::ball, Eigen::Vector3d::UnitY(), floating));
  const Eigen::Vector3d spin = 0.7 * axis;
  const Eigen::Vector3d in_parent = floating ? Eigen::Vector3d(kParentPose.conjugate() * spin) : spin;
  run.from({0.0, 0.0, 0.0}, {in_parent.x(), in_parent.y(), in_parent.z()});
  const TimeSeries readings = run.run({0.0, 1e-3}).readings;
  EXPECT_NEAR((reading_vector(readings, "body_spin", 0) - spin).norm(), 0.0, kSameFrame);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(column(readings, "velocity." + std::to_string(i + 1))(0), in_parent(i), kSameFrame);
}

TEST_P(JointFrame, UniversalTurnsAboutTheParentsThenTheChildsAxis) {
  const auto& [name, axis, floating] = GetParam();
  RobotSpec robot = askew(JointKind::universal, axis, floating);
  const Eigen::Vector3d second = axis.unitOrthogonal();
  robot.joints[0].axis2 = second;
  SimulationRun run(robot);
  const TimeSeries readings = run.from({0.5, -0.8}, {0.3, 0.4}).run({0.0, 1e-3}).readings;
  const Eigen::Quaterniond first_turn(Eigen::AngleAxisd(0.5, axis));
  const Eigen::Quaterniond expected = first_turn * Eigen::Quaterniond(Eigen::AngleAxisd(-0.8, second));
  EXPECT_NEAR(relative_turn(readings, 0, floating).angularDistance(expected), 0.0, kSameFrame);
  const Eigen::Vector3d spin = 0.3 * axis + 0.4 * (first_turn * second);
  EXPECT_NEAR((reading_vector(readings, "body_spin", 0) - spin).norm(), 0.0, kSameFrame);
  EXPECT_NEAR(column(readings, "position.1")(0), 0.5, kSameFrame);
  EXPECT_NEAR(column(readings, "position.2")(0), -0.8, kSameFrame);
  EXPECT_NEAR(column(readings, "velocity.1")(0), 0.3, kSameFrame);
  EXPECT_NEAR(column(readings, "velocity.2")(0), 0.4, kSameFrame);
}

}  // namespace
}  // namespace lacuna::joint_frame_test

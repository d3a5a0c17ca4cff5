#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::slope_test {
namespace {

constexpr double kFriction = 0.5;
const double kFrictionAngle = std::atan(kFriction);

/// A flat box that lies on a slope, turned by `yaw` about the slope's normal.
SimulationRun box_on_slope(double slope, double yaw, double step = 1e-3) {
  RobotSpec robot = floating_body(2.0, {.xx = 0.02, .yy = 0.02, .zz = 0.04});
  BodySpec& body = robot.bodies[0];
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(slope, Eigen::Vector3d::UnitY()));
  ShapeSpec box;
  box.size = {0.3, 0.3, 0.1};
  body.shapes = {box};
  body.orientation = tilt * Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  body.position = tilt * Eigen::Vector3d(0.0, 0.0, 0.05);
  robot.contact = {.ground = true, .stiffness = 1e6, .damping = 1e4, .friction = kFriction, .slope = slope};
  return SimulationRun(robot, step);
}

/// How far it has slid down the slope after `end`, m.
double slid(const SimulationRun& run, double slope, double end) {
  const TimeSeries readings = run.run({0.0, end}).readings;
  const Eigen::Vector3d downhill(std::cos(slope), 0.0, -std::sin(slope));
  Eigen::Vector3d start;
  for (int i = 0; i < 3; ++i) start(i) = readings.samples(0, i);
  return downhill.dot(last_vector(readings, "position") - start);
}

TEST(BoxOnASlope, StaysJustBelowTheFrictionAngle) {
  constexpr double kCreep = 1e-3;  // m in a second; sliding at this excess would be 0.1 m
  for (const double yaw : {0.0, 0.5}) {
    const double slope = 0.98 * kFrictionAngle;
    EXPECT_NEAR(slid(box_on_slope(slope, yaw), slope, 1.0), 0.0, kCreep) << "yaw " << yaw;
  }
}

TEST(BoxOnASlope, SlidesAboveTheFrictionAngleWithTheKnownAcceleration) {
  constexpr double kEnd = 1.0;
  constexpr double kAccelerationError = 0.01;  // of it; covers settling into the soft ground
  for (const double excess : {1.05, 1.3}) {
    for (const double yaw : {0.0, 0.5}) {
      const double slope = excess * kFrictionAngle;
      const double expected = 0.5 * kGravity * (std::sin(slope) - kFriction * std::cos(slope)) * kEnd * kEnd;
      EXPECT_NEAR(slid(box_on_slope(slope, yaw), slope, kEnd), expected, kAccelerationError * expected)
          << "slope " << slope << ", yaw " << yaw;
    }
  }
}

TEST(BoxOnASlope, PositiveSlopeDescendsTowardsX) {
  const double slope = 1.3 * kFrictionAngle;
  EXPECT_GT(box_on_slope(slope, 0.0).last("position.x", 0.5), 0.1);
  EXPECT_LT(box_on_slope(-slope, 0.0).last("position.x", 0.5), -0.1);
}

}  // namespace
}  // namespace lacuna::slope_test

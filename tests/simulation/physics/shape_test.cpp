#include "support/robots.h"
#include "support/simulation_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace lacuna::shape_test {
namespace {

constexpr double kTilt = 0.4;  // rad, of the shape against its body
const Eigen::Vector3d kOffset(0.05, -0.02, 0.03);

struct RestingShape {
  std::string name;
  ShapeKind kind;
  Eigen::Vector3d size;
  double tilt;         ///< about y, rad
  double half_height;  ///< from the shape's centre down to its lowest point, m
};

std::vector<RestingShape> resting_shapes() {
  const double c = std::cos(kTilt), s = std::sin(kTilt);
  const double flat = std::numbers::pi / 2;
  return {{"BoxFlat", ShapeKind::box, {0.2, 0.3, 0.4}, 0.0, 0.2},
          {"BoxTilted", ShapeKind::box, {0.2, 0.3, 0.4}, kTilt, 0.2 * c + 0.1 * s},
          {"Sphere", ShapeKind::sphere, {0.15, 0.0, 0.0}, 0.0, 0.15},
          {"CapsuleUpright", ShapeKind::capsule, {0.1, 0.4, 0.0}, 0.0, 0.3},
          {"CapsuleTilted", ShapeKind::capsule, {0.1, 0.4, 0.0}, kTilt, 0.2 * c + 0.1},
          {"CapsuleFlat", ShapeKind::capsule, {0.1, 0.4, 0.0}, flat, 0.1},
          {"CylinderUpright", ShapeKind::cylinder, {0.1, 0.4, 0.0}, 0.0, 0.2},
          {"CylinderTilted", ShapeKind::cylinder, {0.1, 0.4, 0.0}, kTilt, 0.2 * c + 0.1 * s},
          {"CylinderFlat", ShapeKind::cylinder, {0.1, 0.4, 0.0}, flat, 0.1}};
}

class ShapeOnGround : public testing::TestWithParam<RestingShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, ShapeOnGround, testing::ValuesIn(resting_shapes()),
                         [](const auto& test) { return test.param.name; });

/// A body that can only move up and down and falls onto its shape.
RobotSpec falling(const RestingShape& resting) {
  RobotSpec robot = one_joint(JointKind::slider, 2.0, Eigen::Vector3d::UnitZ());
  robot.gravity = {0.0, 0.0, -kGravity};
  robot.bodies[0].position = {0.0, 0.0, 0.5};
  ShapeSpec shape;
  shape.kind = resting.kind;
  shape.size = resting.size;
  shape.position = kOffset;
  shape.orientation = Eigen::AngleAxisd(resting.tilt, Eigen::Vector3d::UnitY());
  robot.bodies[0].shapes = {shape};
  robot.contact = {.ground = true, .stiffness = 1e6, .damping = 2e3, .friction = 1.0};
  robot.sensors = {make_sensor("place", SensorKind::body_position, "body"),
                   make_sensor("touch", SensorKind::touch, "body"),
                   make_sensor("contact", SensorKind::contact_force, "body")};
  return robot;
}

TEST_P(ShapeOnGround, RestsOnItsLowestPointAndCarriesItsWeight) {
  const TimeSeries readings = SimulationRun(falling(GetParam())).run({0.0, 3.0}).readings;
  constexpr double kSag = 1e-4;  // m; the soft ground gives way by 2e-5
  EXPECT_EQ(column(readings, "touch")(0), -1.0);
  EXPECT_EQ(column(readings, "touch")(1), 1.0);
  EXPECT_NEAR(last_vector(readings, "place").z(), GetParam().half_height - kOffset.z(), kSag);
  EXPECT_NEAR(last_vector(readings, "contact").z(), 2.0 * kGravity, 1e-2);
}

}  // namespace
}  // namespace lacuna::shape_test

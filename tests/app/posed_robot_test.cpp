#include "app/runs/posed_robot.h"

#include <lacuna/error.h>

#include "support/robots.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

/// A ball of 1 dm above the ground, with a sensor of its own.
ModelStructure ball(double height) {
  BodySpec body = plain_body("ball", 1.0, 0.004);
  body.position = {0.0, 0.0, height};
  ShapeSpec shape;
  shape.kind = ShapeKind::sphere;
  shape.size = {0.1, 0.0, 0.0};
  body.shapes = {shape};
  ModelStructure structure;
  structure.robot.name = "ball";
  structure.robot.bodies = {body};
  structure.robot.sensors = {make_sensor("velocity", SensorKind::body_velocity, "ball")};
  structure.robot.contact.ground = true;
  structure.robot.contact.stiffness = 1e4;
  structure.robot.contact.damping = 100.0;
  return structure;
}

EngineSettings engine() {
  EngineSettings settings;
  settings.step = 0.001;
  return settings;
}

TEST(PosedRobot, SaysWhereBodiesAreAndWhenTheyTouchTheGround) {
  constexpr double kHeight = 0.3;
  const double lands = std::sqrt(2.0 * (kHeight - 0.1) / kGravity);
  const std::vector<double> times = {0.0, 0.5 * lands, 1.0};
  const PosedRobot::Motion motion =
      PosedRobot(ball(kHeight), engine()).move({}, lacuna::Test{CommandSeries{}, 1.0, {}}, times);
  ASSERT_EQ(motion.poses.samples.cols(), 7);
  EXPECT_EQ(motion.poses.channels[2].name, "ball.z");
  EXPECT_NEAR(motion.poses.samples(0, 2), kHeight, 1e-12);
  EXPECT_NEAR(motion.poses.samples(1, 2), kHeight - 0.125 * kGravity * lands * lands, 2e-3);
  EXPECT_NEAR(motion.poses.samples(2, 2), 0.1, 5e-3);
  ASSERT_EQ(motion.contacts.channels.size(), 1U);
  EXPECT_EQ(motion.contacts.channels[0].name, "ball");
  EXPECT_LT(motion.contacts.samples(1, 0), 0.0);
  EXPECT_GT(motion.contacts.samples(2, 0), 0.0);
  EXPECT_EQ(motion.readings.samples.cols(), 3) << "of the robot's own sensor alone";
}

TEST(PosedRobot, HasNoContactsWithoutAGround) {
  ModelStructure structure = ball(0.3);
  structure.robot.contact = {};
  const PosedRobot::Motion motion =
      PosedRobot(structure, engine()).move({}, lacuna::Test{CommandSeries{}, 0.1, {}}, {0.0, 0.1});
  EXPECT_TRUE(motion.contacts.channels.empty());
  EXPECT_EQ(motion.readings.samples.cols(), 3);
}

}  // namespace
}  // namespace lacuna

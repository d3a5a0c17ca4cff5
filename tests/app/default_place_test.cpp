#include "app/workspace/default_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::ElementsAre;

RobotSpec cart_pole() {
  RobotSpec robot;
  for (const char* name : {"cart", "pole"}) {
    robot.bodies.emplace_back().name = name;
    robot.joints.emplace_back().name = std::string(name) + "_joint";
  }
  robot.actuators.emplace_back().name = "motor";
  return robot;
}

TEST(ElementsOf, AreThoseOfTheKindsAsWhereNamesThem) {
  EXPECT_THAT(elements_of(cart_pole(), {ElementKind::joint}), ElementsAre("joint.cart_joint", "joint.pole_joint"));
  EXPECT_THAT(elements_of(cart_pole(), {ElementKind::actuator, ElementKind::body}),
              ElementsAre("actuator.motor", "body.cart", "body.pole"));
  EXPECT_THAT(elements_of(cart_pole(), {ElementKind::sensor}), ElementsAre());
}

TEST(QuestionOfPlace, HasTheLineToType) {
  EXPECT_EQ(question_of_place("coulomb_friction", {ElementKind::joint}, {"joint.rail", "joint.hinge"}),
            "say where: --where joint.rail or --where joint.hinge (coulomb_friction acts on joints)");
  EXPECT_EQ(question_of_place("sensor_lag", {ElementKind::sensor}, {}),
            "sensor_lag acts on sensors, which this robot does not have");
}

}  // namespace
}  // namespace lacuna

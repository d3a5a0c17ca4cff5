#include "foundation/address.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

namespace lacuna {
namespace {

RobotSpec two_joints() {
  RobotSpec robot;
  robot.bodies.resize(2);
  robot.bodies[0].name = "upper";
  robot.bodies[1].name = "lower";
  robot.joints.resize(2);
  robot.joints[0].name = "shoulder";
  robot.joints[1].name = "elbow";
  robot.joints[1].kind = JointKind::slider;
  return robot;
}

TEST(Matches, StarStandsForOneLevel) {
  EXPECT_TRUE(matches("body.*.mass", "body.upper.mass"));
  EXPECT_FALSE(matches("body.*", "body.upper.mass"));
  EXPECT_TRUE(matches("joint.el*", "joint.elbow"));
  EXPECT_FALSE(matches("joint.el", "joint.elbow"));
}

TEST(AddressedValues, PointIntoTheRobot) {
  RobotSpec robot = two_joints();
  for (const AddressedValue& value : addressed_values(robot)) {
    if (value.address != "joint.elbow.damping") continue;
    *value.value = 3.0;
    EXPECT_EQ(value.unit, "N*s/m");
  }
  EXPECT_EQ(robot.joints[1].damping, 3.0);
}

TEST(MatchElements, ListsEachElementOnceInSpecOrder) {
  const ElementMatch match = match_elements(two_joints(), {"joint.elbow", "joint.*"});
  EXPECT_EQ(match.kind, ElementKind::joint);
  EXPECT_EQ(match.elements, (std::vector<int>{0, 1}));
}

TEST(MatchElements, NamesTheNearestWhenNothingMatches) {
  try {
    match_elements(two_joints(), {"joint.elbov"});
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"joint.elbow\"?"), std::string::npos) << error.what();
  }
}

TEST(MatchElements, RefusesMixedKinds) {
  EXPECT_THROW(match_elements(two_joints(), {"joint.elbow", "body.upper"}), Error);
}

}  // namespace
}  // namespace lacuna

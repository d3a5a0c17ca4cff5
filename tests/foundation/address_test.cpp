#include "foundation/address.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

#include <limits>

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

TEST(AddressedValues, AreInBoundsAndFiniteWhereTheyMustBe) {
  const auto in_bounds_with = [](double& (*place)(RobotSpec&), double value) {
    RobotSpec robot = two_joints();
    place(robot) = value;
    return values_in_bounds(robot);
  };
  const auto damping = [](RobotSpec& robot) -> double& { return robot.joints[0].damping; };
  const auto rest = [](RobotSpec& robot) -> double& { return robot.joints[0].rest; };
  const auto stop = [](RobotSpec& robot) -> double& { return robot.joints[0].upper; };
  const auto gravity = [](RobotSpec& robot) -> double& { return robot.gravity.z(); };
  EXPECT_TRUE(values_in_bounds(two_joints()));
  EXPECT_FALSE(in_bounds_with(damping, -1.0));
  EXPECT_FALSE(in_bounds_with(damping, kInfinity));
  EXPECT_FALSE(in_bounds_with(rest, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(in_bounds_with(stop, 1.0));
  EXPECT_TRUE(in_bounds_with(stop, kInfinity)) << "no stop";
  EXPECT_FALSE(in_bounds_with(gravity, -kInfinity));
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

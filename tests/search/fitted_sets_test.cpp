#include "search/fitted_sets.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

EffectEntry friction_on(const std::string& place) {
  EffectEntry entry;
  entry.id = entry.effect = "coulomb_friction";
  entry.where = {place};
  return entry;
}

RobotSpec robot_of(std::size_t joints) {
  RobotSpec robot;
  for (std::size_t i = 0; i < joints; ++i) robot.joints.push_back({.name = "j" + std::to_string(i)});
  return robot;
}

TEST(FittedSets, LeaveOutOneMember) {
  const Entries both = {friction_on("joint.j0"), friction_on("joint.j1")};
  EXPECT_EQ(members_of(without_member(both, 0)), std::set<std::string>{"coulomb_friction @ joint.j1"});
  EXPECT_EQ(members_of(without_member(both, 1)), std::set<std::string>{"coulomb_friction @ joint.j0"});
}

/// On many joints the effect has a value on each already; on few it has one value for all, beside which one joint may
/// have more.
TEST(FittedSets, AreTwiceWhereAnEffectHasTwoValuesOnAJoint) {
  const Entries every_and_one = {friction_on("joint.*"), friction_on("joint.j1")};
  EXPECT_TRUE(is_twice(every_and_one, robot_of(4)));
  EXPECT_FALSE(is_twice(every_and_one, robot_of(3)));
  EXPECT_FALSE(is_twice({friction_on("joint.j0"), friction_on("joint.j1")}, robot_of(4)));
}

}  // namespace
}  // namespace lacuna

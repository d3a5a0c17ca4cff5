#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Declared, IsTheRobotOfTheFile) {
  RobotSpec file;
  file.name = "rig";
  file.bodies.resize(1);
  file.bodies[0].mass = 0.7;
  const RobotSpec robot = built_catalog().get<RobotDefinition>("declared").build({{}, &file});
  EXPECT_EQ(robot.name, "rig");
  EXPECT_EQ(robot.bodies.at(0).mass, 0.7);
}

TEST(Declared, WithoutAFileSaysHowToNameOne) {
  EXPECT_THAT([] { built_catalog().get<RobotDefinition>("declared").build({}); },
              ThrowsMessage<Error>(HasSubstr("file = ")));
}

}  // namespace
}  // namespace lacuna

#include "evaluation/model/target_check.h"

#include "config/robots/robot_reader.h"
#include "foundation/text/problem.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A carriage on a rail, driven by a force.
class CheckTarget : public testing::Test {
 protected:
  CheckTarget()
      : robot_(read_robot_text("[robot]\nname = \"r\"\n[body.cart]\nmass = 1\ninertia = [1, 1, 1]\n"
                               "[joint.rail]\nkind = \"slider\"\nchild = \"cart\"\n[actuator.motor]\njoint = \"rail\"\n"
                               "[sensor.place]\nkind = \"joint_position\"\njoint = \"rail\"\n",
                               "robot.toml")) {
    experiment_.file = "rig.toml";
    experiment_.target.recording.sensors.resize(1);
    experiment_.target.recording.sensors[0].channel = "place";
    experiment_.target.recording.commands.resize(1);
    experiment_.target.recording.commands[0].channel = "motor";
    experiment_.target.recording.initial["rail"] = {};
    experiment_.noise.process = {{"joint.rail", 0.1}};
  }

  std::vector<std::string> problems() const {
    Complaints complaints(experiment_);
    check_target(robot_, experiment_, complaints);
    std::vector<std::string> sentences;
    try {
      complaints.throw_if_any();
    } catch (const BadInput& bad) {
      for (const Problem& problem : bad.problems()) sentences.push_back(problem.message);
    }
    return sentences;
  }

  RobotSpec robot_;
  Experiment experiment_;
};

TEST_F(CheckTarget, AcceptsUnitsOfTheRightDimension) {
  experiment_.written_units = {{"target.sensors.place.offset", "mm"},
                               {"target.commands.motor.noise", "mN"},
                               {"target.initial.rail.velocity", "mm/s"},
                               {"noise.process.joint.rail", "N"}};
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(CheckTarget, RefusesUnitsOfAnotherDimension) {
  experiment_.written_units = {{"target.sensors.place.offset", "deg"},
                               {"target.commands.motor.noise", "N*m"},
                               {"target.initial.rail.position", "deg"},
                               {"noise.process.joint.rail", "N*m"}};
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("target.sensors.place.offset: is in deg, but must be in m"),
                                      HasSubstr("target.commands.motor.noise: is in N*m, but must be in N"),
                                      HasSubstr("target.initial.rail.position: is in deg, but must be in m"),
                                      HasSubstr("noise.process.joint.rail: is in N*m, but must be in N")));
}

TEST_F(CheckTarget, RefusesRandomForcesOnWhatIsNoJoint) {
  experiment_.noise.process = {{"body.cart", 0.1}, {"joint.rial", 0.1}};
  EXPECT_THAT(problems(),
              ElementsAre(HasSubstr("a random force acts on joints"), HasSubstr("did you mean \"joint.rail\"?")));
}

}  // namespace
}  // namespace lacuna

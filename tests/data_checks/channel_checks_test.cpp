#include "data_checks/channel_checks.h"

#include "data_checks/data_checks.h"
#include "data_checks/recorded_pendulum.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> sentences(const std::vector<DataWarning>& doubts) {
  std::vector<std::string> all;
  for (const DataWarning& doubt : doubts) all.push_back(doubt.sentence);
  return all;
}

std::vector<DataWarning> amount_of(RecordedPendulum& rig, const std::vector<double>& durations) {
  rig.trials.clear();
  for (const double duration : durations)
    rig.trials.push_back(recorded({}, "run" + std::to_string(rig.trials.size()), multisine, duration, 1));
  return amount_doubts({rig.definition, *rig.model, rig.trials, rig.values});
}

/// Seven stretches of half a second, which favour a model by chance in one of 128 cases.
TEST(AmountOfData, IsEnoughFromSevenStretchesOn) {
  RecordedPendulum rig;
  EXPECT_THAT(limits_among(amount_of(rig, {2.0, 1.5})), IsEmpty());
  EXPECT_THAT(limits_among(amount_of(rig, {2.0, 1.4})), ElementsAre(HasSubstr("have 3.4 s, 6 segments")));
}

TEST(AmountOfData, IsNotDoubtedWithoutAFitTrial) {
  RecordedPendulum rig;
  for (Trial& trial : rig.trials) trial.held_out = true;
  EXPECT_THAT(amount_doubts({rig.definition, *rig.model, rig.trials, rig.values}), IsEmpty());
}

TEST(ChannelChecks, NoteAChannelWithoutValues) {
  RecordedPendulum rig;
  rig.angle(1).setConstant(std::nan(""));
  const std::vector<DataWarning> doubts = channel_checks({rig.definition, *rig.model, rig.trials, rig.values});
  EXPECT_THAT(sentences(doubts), ElementsAre("multi.csv: angle has no values"));
  EXPECT_EQ(doubts.front().severity, Severity::note);
}

/// Under less than half the commands that moved it elsewhere, friction may hold a joint.
TEST(ChannelChecks, DoNotBlameAJointThatMayBeHeldByFriction) {
  RecordedPendulum rig;
  rig.angle(1).setConstant(0.1);
  rig.trials[1].commands.series.samples *= 0.3;
  const std::vector<DataWarning> doubts = channel_checks({rig.definition, *rig.model, rig.trials, rig.values});
  EXPECT_THAT(sentences(doubts), ElementsAre(StartsWith("multi.csv: angle stays at 0.100 rad")));
  EXPECT_EQ(doubts.front().severity, Severity::note);
}

/// What stays at a value after arriving slowly, as at a hard stop, is no saturated sensor.
TEST(Saturated, IsASensorAtTheEndOfItsRange) {
  RecordedPendulum rig;
  EXPECT_FALSE(is_saturated(rig.definition.structure.robot, rig.trials[1]));
  rig.angle(1) = rig.angle(1).cwiseMin(0.15);
  EXPECT_TRUE(is_saturated(rig.definition.structure.robot, rig.trials[1]));
}

TEST(Saturated, IsNoneOfAChannelThatMeasuresNoJoint) {
  RecordedPendulum rig;
  rig.angle(1) = rig.angle(1).cwiseMin(0.15);
  rig.definition.structure.robot.sensors[0].kind = SensorKind::joint_force;
  EXPECT_FALSE(is_saturated(rig.definition.structure.robot, rig.trials[1]));
}

}  // namespace
}  // namespace lacuna

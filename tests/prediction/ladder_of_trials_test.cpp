#include "prediction/one_joint_rig.h"
#include "prediction/prediction_ladder.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::ElementsAre;

std::vector<FreeValue> damping() { return {analytic::free_value("b", 0.5, 0.0, 10.0)}; }

/// Of these recordings of a spring, s.
struct SpringRig : OneJointRig {
  explicit SpringRig(const std::vector<double>& durations) : OneJointRig(damped_spring, damping(), {0.5}, durations) {}
};

TEST(LadderOf, TilesTheTrialWithEachLength) {
  const SpringRig rig({2.0});
  const PredictionLadder ladder = rig.ladder({0.5, 1.0});
  std::vector<Eigen::Index> firsts[2];
  for (const PredictedStretch& one : ladder.stretches) firsts[one.length].push_back(one.stretch.first);
  EXPECT_EQ(firsts[0].size(), 4U);
  EXPECT_EQ(firsts[1].size(), 2U);
  for (std::size_t k = 0; k + 1 < 4; ++k)
    EXPECT_EQ(ladder.stretches[k].stretch.last, ladder.stretches[k + 1].stretch.first + 1)
        << "ends with the first sample of the next";
}

TEST(LadderOf, ScoresEveryReadingButTheStart) {
  const SpringRig rig({2.0});
  const PredictedStretch stretch = rig.ladder({0.5}).stretches[1];
  EXPECT_EQ(static_cast<Eigen::Index>(stretch.rows.size()), stretch.stretch.size() - 1);
  EXPECT_EQ(stretch.rows.front(), 1);
  EXPECT_THAT(stretch.unknown, ElementsAre(0, 1));
  EXPECT_EQ(stretch.covariance.rows(), 2);
}

TEST(LadderOf, LeavesOutTrialsThatAreMuchShorterThanALength) {
  const SpringRig rig({2.0, 0.5});
  std::vector<std::size_t> trials;
  for (const PredictedStretch& one : rig.ladder({1.0}).stretches) trials.push_back(one.stretch.trial);
  EXPECT_THAT(trials, ElementsAre(0, 0));
}

TEST(LadderOf, ReadsHeldOutTrialsOrTheOthers) {
  const SpringRig rig({2.0, 2.0});
  std::vector<Trial> trials = rig.trials;
  trials[1].held_out = true;
  const TrialPredictor predictor(rig.model, trials, {1});
  const StartStates states(rig.definition.structure.robot, predictor, rig.noise);
  const SmoothedStarts starts(states, predictor.trials());
  LadderSource source{rig.definition.structure.robot, predictor, states, starts, rig.noise};
  for (const PredictedStretch& one : ladder_of(source, {0.5}, 100).stretches) EXPECT_EQ(one.stretch.trial, 0U);
  source.held_out = true;
  for (const PredictedStretch& one : ladder_of(source, {0.5}, 100).stretches) EXPECT_EQ(one.stretch.trial, 1U);
}

TEST(LadderOf, KeepsAtMostSoManyStretchesEvenlySpread) {
  const SpringRig rig({8.0});
  const PredictionLadder ladder = rig.ladder({0.5}, 4);
  ASSERT_EQ(ladder.stretches.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(static_cast<double>(ladder.stretches[k].stretch.first), 200.0 * static_cast<double>(k), 5.0);
}

TEST(LadderOf, HasFortyBlocksOfTimeAndThreeFoldsOfThem) {
  const SpringRig rig({7.99});  // 800 samples
  const CellLayout layout = rig.ladder({0.5}).layout;
  EXPECT_EQ(layout.blocks(), 40U);
  EXPECT_EQ(layout.folds, 3U);
  EXPECT_EQ(layout.fold_of_block.front(), 0U);
  EXPECT_EQ(layout.fold_of_block[20], 1U);
  EXPECT_EQ(layout.fold_of_block.back(), 2U);
}

TEST(LadderOf, LeavesOutWholeRecordingsWhereThereAreThree) {
  const SpringRig rig({2.0, 2.0, 2.0, 2.0});
  const PredictionLadder ladder = rig.ladder({0.5});
  EXPECT_EQ(ladder.layout.folds, 4U);
  for (const PredictedStretch& one : ladder.stretches)
    for (const std::size_t block : one.blocks) EXPECT_EQ(ladder.layout.fold_of_block[block], one.stretch.trial);
}

TEST(LadderOf, WeighsLengthsAlike) {
  const SpringRig rig({4.0});
  const PredictionLadder ladder = rig.ladder({0.5, 1.0});
  ASSERT_EQ(ladder.layout.cells.size(), 2U);
  for (const Cell& cell : ladder.layout.cells) EXPECT_DOUBLE_EQ(cell.weight, 0.5);
}

TEST(LadderOf, GivesAChannelThatIsNotReadNoWeight) {
  SpringRig rig({4.0});
  rig.noise.push_back({"speed", "rad/s", 1.0, ""});
  const PredictionLadder ladder = rig.ladder({0.5});
  EXPECT_DOUBLE_EQ(ladder.layout.cells[ladder.cell(0, 0)].weight, 1.0);
  EXPECT_EQ(ladder.layout.cells[ladder.cell(0, 1)].weight, 0.0);
}

TEST(JointsOf, AreTheElementsThatTheChannelsMeasure) {
  RobotSpec robot = analytic::one_joint_robot();
  robot.sensors.push_back(robot.sensors[0]);
  robot.sensors[1].name = "speed";
  robot.sensors[1].kind = SensorKind::joint_velocity;
  robot.sensors[1].element = "elbow";
  EXPECT_THAT(joints_of(robot, {{"speed", "rad/s", 1.0, ""}, {"angle", "rad", 1.0, ""}}),
              ElementsAre("elbow", "hinge"));
}

}  // namespace
}  // namespace lacuna

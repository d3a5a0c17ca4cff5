#include "data_checks/acceleration_table.h"

#include "data_checks/recorded_pendulum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

AccelerationTable table_of(const RecordedPendulum& rig) {
  return acceleration_table({rig.definition, *rig.model, rig.trials, rig.values},
                            sensor_noise(rig.definition.structure.robot, rig.trials));
}

/// With enough noise that the motion within three samples adds nothing to it.
TEST(AccelerationTable, OfARightModelExplainsWhatIsMeasuredToItsNoise) {
  const AccelerationTable table = table_of(RecordedPendulum{{.noise = 3e-3}});
  ASSERT_EQ(table.channels.size(), 3U) << "one channel, three trials";
  double squares = 0.0, count = 0.0;
  for (const ChannelAccelerations& one : table.channels) {
    const Eigen::VectorXd predicted = one.uncommanded + one.commanded.rowwise().sum();
    squares += ((one.measured - predicted) / one.deviation).squaredNorm();
    count += static_cast<double>(one.size());
    EXPECT_EQ(one.unit, "rad/s^2");
  }
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.25);
}

/// The motor turns it by u/I, whatever gravity does.
TEST(AccelerationTable, KnowsTheAccelerationOfACommandApart) {
  RecordedPendulum rig;
  const AccelerationTable table = table_of(rig);
  for (const ChannelAccelerations& one : table.channels) {
    const Eigen::VectorXd torque_over_inertia = one.of_commands(table.trials[one.trial], 0.0) / 0.025;
    EXPECT_LT((one.commanded.col(0) - torque_over_inertia).norm(), 0.05 * torque_over_inertia.norm());
  }
}

TEST(AccelerationTable, LeavesOutStretchesAtRest) {
  RecordedPendulum rig;
  rig.trials = {recorded(
      {}, "late.csv", [](double t) { return t < 3.0 ? 0.0 : multisine(t); }, 6.0, 1)};
  const AccelerationTable table = table_of(rig);
  ASSERT_EQ(table.channels.size(), 1U);
  for (const Eigen::Index first : table.channels[0].first) EXPECT_GT(first, 280);
  EXPECT_GT(table.channels[0].size(), 10);
}

TEST(AccelerationTable, DoesNotReadWhatIsHeldOut) {
  RecordedPendulum rig;
  rig.trials[0].held_out = true;
  const AccelerationTable table = table_of(rig);
  ASSERT_EQ(table.trials.size(), 2U);
  EXPECT_EQ(table.trials[0].name, "multi.csv");
  for (Trial& trial : rig.trials) trial.held_out = true;
  EXPECT_TRUE(table_of(rig).empty());
}

TEST(AccelerationTable, TakesLongerStretchesWhereNoiseHidesTheShort) {
  EXPECT_EQ(table_of(RecordedPendulum{{.noise = 5e-4}}).stretch, 0.1);
  const AccelerationTable longer = table_of(RecordedPendulum{{.noise = 2e-2}});
  EXPECT_EQ(longer.stretch, 0.2);
  EXPECT_GE(clearness(longer), 5.0);
  EXPECT_EQ(table_of(RecordedPendulum{{.noise = 0.5}}).stretch, 0.4) << "the longest, clear or not";
}

TEST(AccelerationTable, IsEmptyWhereAJointIsNotMeasured) {
  RecordedPendulum rig;
  RobotSpec& robot = rig.definition.structure.robot;
  robot.bodies.push_back(robot.bodies[0]);
  robot.bodies[1].name = "second";
  robot.joints.push_back(robot.joints[0]);
  robot.joints[1].name = "elbow";
  robot.joints[1].parent = "arm";
  robot.joints[1].child = "second";
  rig.model = compile(rig.definition.structure, rig.definition.engine);
  EXPECT_TRUE(table_of(rig).empty());
}

TEST(Clearness, IsTheRmsOfTheAccelerationsOverTheirNoise) {
  AccelerationTable table;
  table.channels.resize(2);
  table.channels[0].measured = Eigen::Vector2d(3.0, -4.0);
  table.channels[0].deviation = 0.5;
  table.channels[1].measured = Eigen::Vector2d(0.0, 0.0);
  table.channels[1].deviation = 2.0;
  EXPECT_DOUBLE_EQ(clearness(table), std::sqrt((36.0 + 64.0) / 4.0));
}

}  // namespace
}  // namespace lacuna

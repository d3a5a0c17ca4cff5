#include "data_checks/command_lags.h"

#include "data_checks/recorded_pendulum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

CommandLags lags_of(const RecordedPendulum& rig) {
  const DataCheckTask task{rig.definition, *rig.model, rig.trials, rig.values};
  return command_lags(task, acceleration_table(task, sensor_noise(rig.definition.structure.robot, rig.trials)));
}

std::vector<const CommandLagProfile*> all_of(const CommandLags& lags) {
  std::vector<const CommandLagProfile*> all;
  for (const CommandLagProfile& profile : lags.profiles) all.push_back(&profile);
  return all;
}

/// Curves with their least place at an index.
CommandLagProfile profile_at(Eigen::Index all, Eigen::Index early, Eigen::Index late) {
  const auto curve = [](Eigen::Index least) {
    return Eigen::VectorXd::NullaryExpr(5, [=](Eigen::Index i) { return std::pow(static_cast<double>(i - least), 2); });
  };
  CommandLagProfile profile;
  profile.squares = curve(all);
  profile.early = curve(early);
  profile.late = curve(late);
  return profile;
}

TEST(Surroundings, AreWhatAnInertiaASpringADamperAndFrictionDo) {
  ChannelAccelerations channel;
  channel.deviation = 2.0;
  channel.measured = Eigen::Vector3d::Zero();
  channel.uncommanded = Eigen::Vector3d(1.0, 2.0, 3.0);
  channel.position = Eigen::Vector3d(4.0, 5.0, 6.0);
  channel.velocity = Eigen::Vector3d(10.0, 0.0, -10.0);
  const Eigen::MatrixXd columns = surroundings(channel);
  ASSERT_EQ(columns.cols(), 5);
  EXPECT_TRUE(columns.col(0).isApprox(Eigen::Vector3d(0.5, 1.0, 1.5)));
  EXPECT_TRUE(columns.col(1).isConstant(0.5));
  EXPECT_TRUE(columns.col(2).isApprox(Eigen::Vector3d(2.0, 2.5, 3.0)));
  EXPECT_TRUE(columns.col(3).isApprox(Eigen::Vector3d(5.0, 0.0, -5.0)));
  EXPECT_TRUE(columns.col(4).isApprox(Eigen::Vector3d(0.5, 0.0, -0.5), 1e-6)) << "the direction of motion";
}

TEST(CommandLags, FindTheDelayOfTheCommands) {
  const RecordedPendulum rig({.delay = 0.04});
  const CommandLags lags = lags_of(rig);
  ASSERT_EQ(lags.profiles.size(), 3U);
  EXPECT_NEAR(lags.lags(best_lag(all_of(lags))), 0.04, 0.006);
  EXPECT_NEAR(lags.interval, 0.01, 1e-9);
}

TEST(CommandLags, FindNoneOfARigWithoutDelay) {
  const CommandLags lags = lags_of(RecordedPendulum());
  EXPECT_NEAR(lags.lags(best_lag(all_of(lags))), 0.0, 0.006);
}

/// A position servo accelerates by its error, not by its command.
TEST(CommandLags, AreNotAskedOfServos) {
  RecordedPendulum rig;
  const DataCheckTask task{rig.definition, *rig.model, rig.trials, rig.values};
  const AccelerationTable table = acceleration_table(task, sensor_noise(rig.definition.structure.robot, rig.trials));
  rig.definition.structure.robot.actuators[0].kind = ActuatorKind::position_servo;
  EXPECT_TRUE(command_lags(task, table).profiles.empty());
}

TEST(BestLag, IsLeastOfTheSumOfTheProfiles) {
  const CommandLagProfile one = profile_at(1, 1, 1), other = profile_at(3, 3, 3);
  EXPECT_EQ(best_lag({&one}), 1);
  EXPECT_EQ(best_lag({&one, &other}), 2);
}

TEST(BestLag, IsNoneWhereAllAreAlike) {
  CommandLagProfile flat;
  flat.squares = Eigen::VectorXd::Ones(5);
  EXPECT_EQ(best_lag({&flat}), 2) << "the middle, a lag of zero";
}

TEST(LagDrift, IsByHowMuchTheSecondHalvesLagMore) {
  CommandLags lags;
  lags.lags = Eigen::VectorXd::LinSpaced(5, -0.2, 0.2);
  const CommandLagProfile gains = profile_at(2, 1, 4), steady = profile_at(3, 3, 3);
  EXPECT_NEAR(lag_drift(lags, {&gains}), 0.3, 1e-12);
  EXPECT_NEAR(lag_drift(lags, {&steady}), 0.0, 1e-12);
}

}  // namespace
}  // namespace lacuna

#include "data_checks/stacked_accelerations.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// Four accelerations without gravity, at one place and without velocity; only a constant lies beside the command.
ChannelAccelerations of_one_command(const std::string& channel, std::size_t trial, const Eigen::Vector4d& measured,
                                    double deviation = 1.0) {
  ChannelAccelerations one;
  one.trial = trial;
  one.channel = channel;
  one.unit = "rad/s^2";
  one.deviation = deviation;
  one.measured = measured;
  one.uncommanded = one.position = one.velocity = Eigen::Vector4d::Zero();
  one.commanded = Eigen::Vector4d(1.0, 1.0, -1.0, -1.0);
  return one;
}

const Eigen::Vector4d kBeside(1.0, -1.0, 1.0, -1.0);  ///< orthogonal to the command and to a constant

TEST(StackedAccelerations, HoldTheTrialsOfAChannelBelowEachOtherInUnitsOfTheirNoise) {
  AccelerationTable table;
  table.channels = {of_one_command("a", 0, Eigen::Vector4d::Constant(6.0), 2.0),
                    of_one_command("b", 0, Eigen::Vector4d::Constant(5.0)),
                    of_one_command("a", 1, Eigen::Vector4d::Constant(8.0), 4.0)};
  const std::vector<StackedAccelerations> all = stacked(table);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].channel, "a");
  ASSERT_EQ(all[0].measured.size(), 8);
  EXPECT_TRUE(all[0].measured.head(4).isConstant(3.0));
  EXPECT_TRUE(all[0].measured.tail(4).isConstant(2.0));
  EXPECT_DOUBLE_EQ(all[0].commanded(0, 0), 0.5);
  EXPECT_DOUBLE_EQ(all[0].commanded(4, 0), 0.25);
  EXPECT_EQ(all[0].deviation, 2.0);
  EXPECT_EQ(all[1].measured.size(), 4);
}

TEST(UnexplainedShare, IsNoneWhereACommandInAnyProportionExplainsAll) {
  AccelerationTable table;
  table.channels = {of_one_command("a", 0, -7.0 * Eigen::Vector4d(1.0, 1.0, -1.0, -1.0))};
  EXPECT_NEAR(unexplained_share(table), 0.0, 1e-12);
}

/// Squares of 4 by the command, of 1 beside it.
TEST(UnexplainedShare, IsThatOfTheSquares) {
  AccelerationTable table;
  table.channels = {of_one_command("a", 0, Eigen::Vector4d(1.0, 1.0, -1.0, -1.0) + 0.5 * kBeside)};
  EXPECT_NEAR(unexplained_share(table), 0.2, 1e-12);
}

/// One proportion for all trials: twice the response in one of them stays unexplained.
TEST(UnexplainedShare, HasOneProportionForAllTrials) {
  AccelerationTable table;
  const Eigen::Vector4d command(1.0, 1.0, -1.0, -1.0);
  table.channels = {of_one_command("a", 0, command), of_one_command("a", 1, 2.0 * command)};
  EXPECT_NEAR(unexplained_share(table), 2.0 / 20.0, 1e-12);
}

TEST(UnexplainedShare, IsAllOfAnEmptyTable) { EXPECT_EQ(unexplained_share({}), 1.0); }

}  // namespace
}  // namespace lacuna

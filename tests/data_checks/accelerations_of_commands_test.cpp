#include "data_checks/acceleration_table.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr double kApart = 0.1;  // s between samples of readings and commands

/// Second differences of a position, or differences of a velocity, of ten samples.
ChannelAccelerations differences(int order) {
  ChannelAccelerations channel;
  channel.order = order;
  const Eigen::VectorXd weights = order == 2 ? Eigen::VectorXd(Eigen::Vector3d(1.0, -2.0, 1.0) / (kApart * kApart))
                                             : Eigen::VectorXd(Eigen::Vector2d(-1.0, 1.0) / kApart);
  for (Eigen::Index first = 0; first + weights.size() <= 10; ++first) {
    channel.first.push_back(first);
    channel.weights.push_back(weights);
  }
  channel.measured = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(channel.first.size()));
  return channel;
}

/// Commands at the times of the readings.
Trial commanded(const Eigen::VectorXd& commands, Hold hold = Hold::zero_order) {
  Trial trial;
  trial.measured.times = Eigen::VectorXd::LinSpaced(10, 0.0, 9.0 * kApart);
  trial.commands.series.times = trial.measured.times.head(commands.size());
  trial.commands.series.samples = commands;
  trial.commands.hold = hold;
  return trial;
}

/// 0 up to 0.5 s, then 2.
Eigen::VectorXd step() {
  Eigen::VectorXd commands = Eigen::VectorXd::Zero(10);
  commands.tail(5).setConstant(2.0);
  return commands;
}

TEST(AccelerationsOfCommands, OfAConstantCommandAreTheCommand) {
  for (const int order : {1, 2}) {
    const Eigen::MatrixXd made = differences(order).of_commands(commanded(Eigen::VectorXd::Constant(10, 3.0)), 0.0);
    ASSERT_EQ(made.cols(), 1);
    EXPECT_TRUE(made.isApproxToConstant(3.0, 1e-9)) << made.transpose();
  }
}

/// The samples 0.4, 0.5 and 0.6 s, from the fifth on, see half of the step.
TEST(AccelerationsOfCommands, OfAHeldCommandAreItsMeanOverTheStretch) {
  const Eigen::MatrixXd made = differences(2).of_commands(commanded(step()), 0.0);
  EXPECT_NEAR(made(3, 0), 0.0, 1e-9);
  EXPECT_NEAR(made(4, 0), 1.0, 1e-9);
  EXPECT_NEAR(made(5, 0), 2.0, 1e-9);
}

TEST(AccelerationsOfCommands, ComeLaterByTheLag) {
  const ChannelAccelerations channel = differences(2);
  EXPECT_NEAR(channel.of_commands(commanded(step()), kApart)(5, 0), 1.0, 1e-9);
  EXPECT_NEAR(channel.of_commands(commanded(step()), -kApart)(3, 0), 1.0, 1e-9);
}

TEST(AccelerationsOfCommands, FollowALineBetweenSamplesWhereTheHoldSaysSo) {
  const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(10, 0.0, 0.9);
  EXPECT_NEAR(differences(2).of_commands(commanded(ramp, Hold::first_order), 0.0)(4, 0), 0.5, 1e-9);
  EXPECT_NEAR(differences(2).of_commands(commanded(ramp), 0.0)(4, 0), 0.45, 1e-9) << "a staircase is behind the line";
}

TEST(AccelerationsOfCommands, GoOnWithTheFirstAndTheLastCommandBeyondThem) {
  for (const Hold hold : {Hold::zero_order, Hold::first_order}) {
    const Eigen::MatrixXd made = differences(1).of_commands(commanded(Eigen::Vector3d(1.0, 5.0, 4.0), hold), 0.2);
    EXPECT_NEAR(made(0, 0), 1.0, 1e-9);
    EXPECT_NEAR(made(8, 0), 4.0, 1e-9);
  }
}

TEST(AccelerationsOfCommands, AreZeroWithoutCommands) {
  Trial trial = commanded(step());
  trial.commands.series.times.resize(0);
  trial.commands.series.samples.resize(0, 1);
  EXPECT_TRUE(differences(2).of_commands(trial, 0.0).isZero());
}

}  // namespace
}  // namespace lacuna

#include "fitting/floor/disturbance.h"

#include "fitting/analytic_models.h"
#include "support/robots.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna::disturbance_test {
namespace {

using namespace lacuna::analytic;
using testing::HasSubstr;
using testing::ThrowsMessage;

const DisturbedJoint kHinge = {"hinge", "random_force_hinge", 0.3};

NoiseSection noise_on(std::map<std::string, double> process) {
  NoiseSection noise;
  noise.process = std::move(process);
  return noise;
}

TEST(DisturbedJointsOf, AreThoseThatTheNoiseNamesInTheOrderOfTheRobot) {
  const RobotSpec robot = double_pendulum(1.0, 0.5, 0.1);
  const std::vector<DisturbedJoint> joints =
      disturbed_joints(robot, noise_on({{"joint.*", 0.1}, {"joint.lower", 0.3}}));
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_EQ(joints[0].joint, "upper");
  EXPECT_EQ(joints[0].deviation, 0.1);
  EXPECT_EQ(joints[1].actuator, "random_force_lower");
  EXPECT_EQ(joints[1].deviation, 0.3);
  EXPECT_EQ(disturbed_joints(robot, noise_on({{"joint.*", 0.1}, {"joint.lower", 0.0}})).size(), 1U);
}

TEST(DisturbedJointsOf, AreHingesAndSlidersAlone) {
  RobotSpec robot = one_joint_robot();
  robot.joints[0].kind = JointKind::ball;
  EXPECT_THAT(
      [&] {
        disturbed_joints(robot, noise_on({{"joint.*", 0.1}}));
      },
      ThrowsMessage<Error>(HasSubstr("random forces act on hinges and sliders only")));
}

/// A mass of 2 kg, at rest, on which a motor and a random force act: half of ½ t² for each newton of both.
TEST(CompileDisturbed, ActsWithARandomForceBesideTheMotor) {
  ModelDefinition definition = define({}, one_joint(JointKind::slider, 2.0));
  definition.engine.step = 0.01;
  const std::unique_ptr<CompiledModel> model = compile_disturbed(definition, {{"joint", "random_force_joint", 0.3}});
  CommandSeries commands;
  commands.series = {
      {{"motor", "N"}, {"random_force_joint", "N"}}, Eigen::VectorXd::Zero(1), TimeSeries::Samples(1, 2)};
  commands.series.samples << 0.5, 1.0;
  const Trial trial = record(*model, {}, regular_times(101, 100.0), commands, {{0.0}, {0.0}}, 0.0, 1);
  EXPECT_NEAR(trial.measured.samples(100, 0), 0.5 * 0.5 * 1.5, 1e-6);
}

TEST(WithCommandNoise, DisturbsTheChannelsWhoseDeviationIsKnown) {
  CommandSeries commands;
  commands.series = {{{"a", "N"}, {"b", "N"}}, regular_times(4000, 100.0), TimeSeries::Samples::Ones(4000, 2)};
  const std::vector<double> deviations = {std::nan(""), 0.2};
  const CommandSeries noisy = with_command_noise(commands, deviations, 1, 2);
  EXPECT_EQ(noisy.series.samples.col(0), commands.series.samples.col(0));
  const Eigen::VectorXd added = noisy.series.samples.col(1) - commands.series.samples.col(1);
  EXPECT_NEAR(added.norm() / std::sqrt(4000.0), 0.2, 0.01);
  EXPECT_LT(std::abs(added.head(3999).dot(added.tail(3999))) / added.squaredNorm(), 0.07) << "white";
  EXPECT_EQ(with_command_noise(commands, deviations, 1, 2).series.samples, noisy.series.samples);
  EXPECT_NE(with_command_noise(commands, deviations, 1, 3).series.samples, noisy.series.samples);
}

/// The command of a channel at a time, where it is held or a line.
double at(const CommandSeries& commands, Eigen::Index channel, double time) {
  const Eigen::VectorXd& times = commands.series.times;
  Eigen::Index row = 0;
  while (row + 1 < times.size() && times(row + 1) <= time) ++row;
  const double value = commands.series.samples(row, channel);
  if (commands.hold == Hold::zero_order || row + 1 == times.size()) return value;
  const double share = (time - times(row)) / (times(row + 1) - times(row));
  return value + share * (commands.series.samples(row + 1, channel) - value);
}

TEST(WithForcePulses, ActsDuringTheIntervalsAloneAndKeepsTheCommands) {
  for (const Hold hold : {Hold::zero_order, Hold::first_order}) {
    CommandSeries commands = two_sines(1.0, 1.0);
    commands.hold = hold;
    const CommandSeries pulsed = with_force_pulses(commands, kHinge, {{0.203, 0.307}, {0.5, 0.6}}, 2.5);
    EXPECT_EQ(pulsed.hold, hold);
    EXPECT_EQ(pulsed.series.channels.back().name, "random_force_hinge");
    for (const double time : {0.1, 0.2029, 0.3071, 0.4, 0.601, 0.9})
      EXPECT_NEAR(at(pulsed, 1, time), 0.0, 1e-9) << time;
    for (const double time : {0.2031, 0.25, 0.3069, 0.501, 0.599}) EXPECT_NEAR(at(pulsed, 1, time), 2.5, 1e-9) << time;
    for (const double time : {0.1, 0.2029, 0.25, 0.5555, 0.9})
      EXPECT_NEAR(at(pulsed, 0, time), at(commands, 0, time), 1e-9) << time;
  }
}

TEST(WithForcePulses, KnowsNoEarlierForceWhereEarlierCommandsAreKnown) {
  CommandSeries commands = two_sines(1.0, 1.0);
  commands.before = {0.7};
  const CommandSeries pulsed = with_force_pulses(commands, kHinge, {{0.5, 0.6}}, 2.5);
  ASSERT_EQ(pulsed.before.size(), 2U);
  EXPECT_EQ(pulsed.before[0], 0.7);
  EXPECT_TRUE(std::isnan(pulsed.before[1]));
}

}  // namespace
}  // namespace lacuna::disturbance_test

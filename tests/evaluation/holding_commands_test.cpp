#include "evaluation/prediction/holding_commands.h"

#include "evaluation/prediction/trial_predictor.h"
#include "foundation/address.h"
#include "support/robots.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::holding_commands_test {
namespace {

constexpr double kMass = 0.5, kLength = 0.2, kInertia = 0.004;
constexpr double kAngle = 0.7;  // rad
const double kTorque = kMass * kGravity * kLength * std::sin(kAngle);

std::unique_ptr<CompiledModel> compiled(RobotSpec robot) {
  ModelStructure structure;
  structure.robot = std::move(robot);
  EngineSettings engine;
  engine.step = 2e-3;
  engine.substeps = 2;
  return compile(std::move(structure), engine);
}

RobotSpec arm() { return pendulum(kMass, kLength, kInertia); }

std::optional<std::vector<double>> holding(const RobotSpec& robot, double position, double known = std::nan("")) {
  const auto model = compiled(robot);
  const auto workspace = model->make_workspace();
  return holding_commands(*model, {}, command_channels(robot), {known}, {position}, {}, *workspace);
}

TEST(HoldingCommands, AreZeroWhereGravityDoesNotPull) { EXPECT_EQ(holding(arm(), 0.0), std::vector{0.0}); }

TEST(HoldingCommands, BalanceGravity) {
  const auto found = holding(arm(), kAngle);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->front(), kTorque, 1e-5 * kTorque);
}

TEST(HoldingCommands, AreInTheUnitBeforeGainAndDelay) {
  RobotSpec robot = arm();
  robot.actuators[0].gain = 4.0;
  robot.actuators[0].offset = 0.1;
  robot.actuators[0].delay = 0.03;
  const auto found = holding(robot, kAngle);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->front(), (kTorque - 0.1) / 4.0, 1e-5);
}

TEST(HoldingCommands, OfAServoAreItsPositionAndTheSag) {
  RobotSpec robot = arm();
  robot.actuators[0].kind = ActuatorKind::position_servo;
  robot.actuators[0].kp = 30.0;
  robot.actuators[0].kd = 1.0;
  const auto found = holding(robot, kAngle);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->front(), kAngle + kTorque / 30.0, 1e-5);
}

TEST(HoldingCommands, AreZeroWhereFrictionHolds) {
  RobotSpec robot = arm();
  robot.joints[0].dry_friction = 1.5 * kTorque;
  EXPECT_EQ(holding(robot, kAngle), std::vector{0.0});
}

TEST(HoldingCommands, AreNoneWhereNoCommandHolds) {
  RobotSpec limp = arm();
  limp.actuators[0].force_limit = 0.5 * kTorque;
  EXPECT_FALSE(holding(limp, kAngle));
  EXPECT_FALSE(holding(arm(), kAngle, 0.0)) << "the only command is known, and does not hold";
}

/// An arm at rest, raised, whose torque steps up at its first sample and acts late.
Trial raised(double first_command, const std::vector<double>& before, InitialKnowledge knowledge) {
  Trial trial;
  trial.name = "raised";
  trial.measured.channels = {{"position", "rad"}};
  trial.measured.times = Eigen::VectorXd::LinSpaced(101, 0.0, 0.2);
  trial.measured.samples = TimeSeries::Samples::Zero(101, 1);
  trial.commands.series = {{{"motor", "N*m"}}, trial.measured.times, {}};
  trial.commands.series.samples = TimeSeries::Samples::Constant(101, 1, first_command);
  trial.commands.before = before;
  trial.initial = {{knowledge, kAngle, 0.0}};
  return trial;
}

/// How far the arm has come after `seconds` when the drive is 20 ms late.
double moved(const Trial& trial, double seconds) {
  RobotSpec robot = arm();
  robot.actuators[0].delay = 0.02;
  const auto model = compiled(robot);
  const TrialPredictor predictor(*model, {trial}, {1});
  Prediction prediction;
  predictor.predict(predictor.whole(0), {}, {{kAngle}, {0.0}}, 0, prediction);
  EXPECT_TRUE(prediction.valid) << prediction.reason;
  return prediction.samples(static_cast<Eigen::Index>(std::lround(seconds / 0.002)), 0) - kAngle;
}

const double kUnknown = std::nan("");

TEST(TrialPast, AtRestIsWhatHeldTheRobot) {
  const Trial trial = raised(kTorque + 0.3, {kUnknown}, InitialKnowledge::given);
  EXPECT_NEAR(moved(trial, 0.02), 0.0, 1e-6);
  EXPECT_GT(moved(trial, 0.06), 0.009);
}

TEST(TrialPast, IsAsStated) {
  const Trial trial = raised(kTorque + 0.3, {kTorque - 0.3}, InitialKnowledge::given);
  EXPECT_LT(moved(trial, 0.02), -1e-3) << "it was commanded too little before";
}

TEST(TrialPast, OfATestIsItsFirstCommand) {
  EXPECT_GT(moved(raised(kTorque + 0.3, {}, InitialKnowledge::given), 0.02), 1e-3);
}

TEST(TrialPast, OfAMotorThatIsOffIsThatItWasOff) {
  // Held by hand and let go: the motor never held it, so it falls at once however late the drive is.
  EXPECT_LT(moved(raised(0.0, {kUnknown}, InitialKnowledge::given), 0.02), -1e-3);
}

TEST(TrialPast, IsUnknownWhereNeitherCommandNorRestIsStated) {
  const auto model = compiled(arm());
  const auto unknown = [&](const Trial& trial) { return TrialPredictor(*model, {trial}, {1}).past_is_unknown(0); };
  EXPECT_TRUE(unknown(raised(0.3, {kUnknown}, InitialKnowledge::from_data)));
  EXPECT_TRUE(unknown(raised(0.3, {kUnknown}, InitialKnowledge::free)));
  EXPECT_FALSE(unknown(raised(0.3, {0.0}, InitialKnowledge::from_data)));
  EXPECT_FALSE(unknown(raised(0.3, {kUnknown}, InitialKnowledge::given)));
  EXPECT_FALSE(unknown(raised(0.3, {}, InitialKnowledge::from_data)));
}

}  // namespace
}  // namespace lacuna::holding_commands_test

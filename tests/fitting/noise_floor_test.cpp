#include "fitting/floor/noise_floor.h"

#include "fitting/analytic_models.h"
#include "fitting/floor/disturbance.h"
#include "fitting/floor/free_run.h"
#include "fitting/numerics/seeded_noise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

/// A run of one piece, from rest at zero.
const std::vector<RunPiece>& from_rest() {
  static const std::vector<RunPiece> kPieces = [] {
    RunPiece piece;
    piece.start.start = {{0.0}, {0.0}};
    return std::vector<RunPiece>{piece};
  }();
  return kPieces;
}

using namespace lacuna::analytic;
using testing::HasSubstr;

constexpr double kRate = 100.0;

/// A trial that measures "angle" as given.
Trial trial_of(const Eigen::VectorXd& angles) {
  Trial trial;
  trial.name = "made";
  trial.measured.channels = {{"angle", "rad"}};
  trial.measured.times = regular_times(angles.size(), kRate);
  trial.measured.samples = angles;
  trial.sensor_noise = {std::nan("")};
  return trial;
}

/// Fast motion without rest, plus white noise.
Trial moving_trial(double noise) {
  SeededNoise random(4, 4);
  Eigen::VectorXd angles(2000);
  for (Eigen::Index i = 0; i < angles.size(); ++i)
    angles(i) = std::sin(static_cast<double>(i) / kRate) + noise * random.normal();
  return trial_of(angles);
}

TEST(SensorNoise, BelievesWhatTheColumnDeclares) {
  Trial trial = moving_trial(0.01);
  trial.sensor_noise = {0.02};
  const ChannelNoise noise = sensor_noise(one_joint_robot(), {trial}).front();
  EXPECT_DOUBLE_EQ(noise.deviation, 0.02);
  EXPECT_EQ(noise.origin, "declared for the column");
}

/// The same readings among the rows of a second device, whose clock is not in step.
Trial among_other_rows(const Trial& trial) {
  const Eigen::VectorXd& times = trial.measured.times;
  std::vector<std::pair<double, double>> rows;
  for (Eigen::Index i = 0; i < times.size(); ++i) rows.emplace_back(times(i), trial.measured.samples(i, 0));
  for (double time = 0.0013; time < times(times.size() - 1); time += 0.37 / kRate)
    rows.emplace_back(time, std::nan(""));
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Trial joined = trial;
  joined.measured.times.resize(static_cast<Eigen::Index>(rows.size()));
  joined.measured.samples.resize(static_cast<Eigen::Index>(rows.size()), 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    joined.measured.times(static_cast<Eigen::Index>(i)) = rows[i].first;
    joined.measured.samples(static_cast<Eigen::Index>(i), 0) = rows[i].second;
  }
  return joined;
}

TEST(SensorNoise, OfTwoDevicesIsThatOfOne) {
  constexpr double kSame = 1e-6;  // of the figure
  Trial resting = moving_trial(0.01), counted = resting;
  for (Eigen::Index i = 0; i < 1000; ++i) resting.measured.samples(i, 0) -= std::sin(static_cast<double>(i) / kRate);
  for (double& value : counted.measured.samples.reshaped()) value = 0.02 * std::round(value / 0.02);
  for (const Trial& trial : {moving_trial(0.01), moving_trial(0.0005), resting, counted}) {
    const ChannelNoise one = sensor_noise(one_joint_robot(), {trial}).front();
    const ChannelNoise two = sensor_noise(one_joint_robot(), {among_other_rows(trial)}).front();
    EXPECT_NEAR(two.deviation, one.deviation, kSame * one.deviation);
    EXPECT_EQ(two.origin, one.origin);
  }
}

/// Second differences by number would take the motion between readings that come early and late for noise.
TEST(SensorNoise, OfReadingsAtUnevenTimesIsTheirOwn) {
  SeededNoise random(4, 4);
  Trial trial = moving_trial(0.0);
  for (Eigen::Index i = 0; i < trial.measured.times.size(); ++i) {
    trial.measured.times(i) += 0.3 / kRate * std::sin(static_cast<double>(i * i));
    trial.measured.samples(i, 0) = 20.0 * trial.measured.times(i) + 0.01 * random.normal();
  }
  EXPECT_NEAR(sensor_noise(one_joint_robot(), {trial}).front().deviation, 0.01, 0.0005);
}

TEST(SensorNoise, ElseTheRobotsSensor) {
  RobotSpec robot = one_joint_robot();
  robot.sensors[0].quantum = 0.012;
  const ChannelNoise noise = sensor_noise(robot, {moving_trial(0.01)}).front();
  EXPECT_DOUBLE_EQ(noise.deviation, 0.012 / std::sqrt(12.0));
  EXPECT_THAT(noise.origin, HasSubstr("encoder step 12.0 mrad/√12"));
}

TEST(SensorNoise, ElseTheScatterAtRest) {
  SeededNoise random(4, 4);
  Eigen::VectorXd angles(2000);
  for (Eigen::Index i = 0; i < angles.size(); ++i)
    angles(i) = (i < 1000 ? 0.0 : std::sin(static_cast<double>(i - 1000) / kRate)) + 0.01 * random.normal();
  const ChannelNoise noise = sensor_noise(one_joint_robot(), {trial_of(angles)}).front();
  EXPECT_NEAR(noise.deviation, 0.01, 0.001);
  EXPECT_THAT(noise.origin, HasSubstr("rest"));
}

/// Five changes in 500 readings of −1 or 1: beside each, one reading is off by 2 with a chance of one half.
TEST(SensorNoise, OfATouchIsTheMomentOfItsChanges) {
  RobotSpec robot = one_joint_robot();
  robot.sensors[0].kind = SensorKind::touch;
  Eigen::VectorXd touch(500);
  for (Eigen::Index i = 0; i < touch.size(); ++i) touch(i) = (i + 30) / 100 % 2 == 0 ? -1.0 : 1.0;
  Trial trial = trial_of(touch);
  trial.measured.channels = {{robot.sensors[0].name, "1"}};
  const ChannelNoise noise = sensor_noise(robot, {trial}).front();
  EXPECT_DOUBLE_EQ(noise.deviation, std::sqrt(4.0 * 0.5 * 5.0 / 500.0));
  EXPECT_THAT(noise.origin, HasSubstr("change of touch"));
}

TEST(SensorNoise, ElseSecondDifferencesAndSaysSo) {
  Trial trial = moving_trial(0.01);
  for (Eigen::Index i = 0; i < trial.measured.samples.rows(); ++i)  // never at rest
    trial.measured.samples(i, 0) += 5.0 * static_cast<double>(i) / kRate;
  const ChannelNoise noise = sensor_noise(one_joint_robot(), {trial}).front();
  EXPECT_NEAR(noise.deviation, 0.01, 0.001);
  EXPECT_THAT(noise.origin, HasSubstr("second differences"));
}

TEST(SensorNoise, IsNeverZero) {
  const ChannelNoise noise = sensor_noise(one_joint_robot(), {trial_of(Eigen::VectorXd::Constant(500, 0.25))}).front();
  EXPECT_GT(noise.deviation, 0.0);
  EXPECT_LT(noise.deviation, 1e-12);
}

TEST(NoiseFloor, CommandNoisePassesThroughTheModel) {
  // q' = u held for 10 ms: position error is a random walk, variance k (0.1 · 0.01)² after k steps; its mean
  // over n steps is n/2 of that.
  const OneJointModel model([](std::span<const double>, double, double v, double u) { return (u - v) / 1e-3; });
  const ModelDefinition definition = define({}, one_joint_robot());
  Trial trial = trial_of(Eigen::VectorXd::Zero(401));
  trial.commands = two_sines(4.0, 1.0);
  trial.command_noise = {0.1};
  trial.sensor_noise = {1e-4};
  const std::vector<ChannelNoise> sensors = sensor_noise(one_joint_robot(), {trial});
  const NoiseSection noise;
  const FloorValue floor =
      noise_floor({definition, model, {trial}, noise, {}, sensors, {{&from_rest(), 0}}}).front().channels.front();
  const double expected = 0.1 * 0.01 * std::sqrt(400.0 / 2.0);
  EXPECT_NEAR(floor.input, expected, 0.35 * expected);  // 24 walks: their mean square varies by a quarter
  EXPECT_DOUBLE_EQ(floor.total, std::hypot(floor.input, 1e-4));
  EXPECT_THAT(floor.origin, HasSubstr("command noise adds"));
}

TEST(NoiseFloor, IsNotKnownWhereNoDisturbedRunCanBeSimulated) {
  // Still only under no command at all: the undisturbed run works, each disturbed one fails.
  const OneJointModel model(
      [](std::span<const double>, double, double, double u) { return u == 0.0 ? 0.0 : std::nan(""); });
  const ModelDefinition definition = define({}, one_joint_robot());
  Trial trial = trial_of(Eigen::VectorXd::Zero(101));
  trial.commands = two_sines(1.0, 0.0);
  trial.command_noise = {0.1};
  trial.sensor_noise = {1e-4};
  const std::vector<ChannelNoise> sensors = sensor_noise(one_joint_robot(), {trial});
  const NoiseSection noise;
  const FloorValue floor =
      noise_floor({definition, model, {trial}, noise, {}, sensors, {{&from_rest(), 0}}}).front().channels.front();
  EXPECT_TRUE(std::isnan(floor.input));
  EXPECT_TRUE(std::isnan(floor.total));
  EXPECT_EQ(floor.sensor, 1e-4);
  EXPECT_THAT(floor.origin, HasSubstr("the contribution of command noise is unknown"));
}

TEST(NoiseFloor, RandomForceActsThroughTheEngine) {
  // A free mass of 2 kg under a force that is white from step to step: position error σ h²/m √(k³/3) after k steps,
  // whose RMS over n steps is σ h²/m √(n³/12).
  RobotSpec robot = one_joint_robot();
  robot.joints[0].kind = JointKind::slider;
  robot.joints[0].axis = {1.0, 0.0, 0.0};
  robot.bodies[0].mass = 2.0;
  robot.gravity.setZero();
  ModelDefinition definition = define({}, robot);
  definition.engine.step = 0.01;
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  Trial trial = trial_of(Eigen::VectorXd::Zero(401));
  trial.measured.channels = {{"angle", "m"}};
  trial.sensor_noise = {1e-6};
  NoiseSection noise;
  noise.process = {{"joint.hinge", 0.3}};
  const std::vector<ChannelNoise> sensors = sensor_noise(robot, {trial});
  const FloorValue floor =
      noise_floor({definition, *model, {trial}, noise, {}, sensors, {{&from_rest(), 0}}}).front().channels.front();
  const double expected = 0.3 * 1e-4 / 2.0 * std::sqrt(std::pow(400.0, 3) / 12.0);
  EXPECT_NEAR(floor.process, expected, 0.4 * expected);  // 24 walks, each one draw of its size
  EXPECT_THAT(floor.origin, HasSubstr("random force adds"));
}

TEST(WithRandomForces, KeepsTheCommandsAndAddsAForceOfTheDeclaredSizeAndMemory) {
  const CommandSeries commands = two_sines(50.0, 1.0);
  const CommandSeries disturbed =
      with_random_forces(commands, {{"hinge", "random_force_hinge", 0.3}}, 0.001, 0.02, 0.0, 50.0, 1, 2);
  ASSERT_EQ(disturbed.series.channels.back().name, "random_force_hinge");
  const auto force = disturbed.series.samples.col(1);
  const Eigen::Index size = force.size();
  EXPECT_EQ(size, 50001);
  EXPECT_EQ(disturbed.series.samples(25, 0), commands.series.samples(2, 0));
  EXPECT_NEAR(std::sqrt(force.squaredNorm() / static_cast<double>(size)), 0.3, 0.03);
  const double lagged = force.tail(size - 20).dot(force.head(size - 20)) / force.squaredNorm();
  EXPECT_NEAR(lagged, std::exp(-1.0), 0.1);  // 20 ms later, with a correlation time of 20 ms
}

TEST(DisturbedJoints, RefusesWhatIsNoJoint) {
  NoiseSection noise;
  noise.process = {{"body.arm", 1.0}};
  EXPECT_THROW(disturbed_joints(one_joint_robot(), noise), Error);
}

}  // namespace
}  // namespace lacuna

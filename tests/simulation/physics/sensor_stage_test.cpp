#include "support/reference_integration.h"
#include "support/robots.h"
#include "support/simulation_run.h"
#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna::sensor_stage_test {
namespace {

constexpr double kStep = 1e-3;

/// A mass that moves evenly: position 0.5 + 2·t, so that every stage has a simple answer.
RobotSpec even_motion() { return one_joint(JointKind::slider, 1.0); }
SimulationRun moving(const RobotSpec& robot) { return SimulationRun(robot, kStep).from({0.5}, {2.0}); }

TEST(SensorDelay, ReadsThePast) {
  for (const double delay : {0.0, 0.001, 0.0125, 0.0203}) {
    RobotSpec robot = even_motion();
    robot.sensors[0].delay = delay;
    const TimeSeries readings = moving(robot).run({0.0, 0.1, 0.2505, 0.7}).readings;
    for (Eigen::Index row = 1; row < 4; ++row)
      EXPECT_NEAR(column(readings, "position")(row), 0.5 + 2.0 * (readings.times(row) - delay), kRounding);
  }
}

TEST(SensorDelay, ReadsTheInitialValueBeforeTheStart) {
  RobotSpec robot = even_motion();
  robot.sensors[0].delay = 0.05;
  const TimeSeries readings = moving(robot).run({0.0, 0.02, 0.05, 0.06}).readings;
  EXPECT_NEAR(column(readings, "position")(0), 0.5, kRounding);
  EXPECT_NEAR(column(readings, "position")(1), 0.5, kRounding);
  EXPECT_NEAR(column(readings, "position")(2), 0.5, kRounding);
  EXPECT_NEAR(column(readings, "position")(3), 0.52, kRounding);
}

TEST(SensorDelay, CanBeRoundedToWholeSteps) {
  RobotSpec robot = even_motion();
  robot.sensors[0].delay = 2.4 * kStep;
  SimulationRun run = moving(robot);
  run.engine.delay_rounding = DelayRounding::step;
  EXPECT_NEAR(run.last("position", 0.1), 0.5 + 2.0 * (0.1 - 2.0 * kStep), kRounding);
}

TEST(SensorScaleAndOffset, ApplyInThisOrder) {
  RobotSpec robot = even_motion();
  robot.sensors[0].scale = -3.0;
  robot.sensors[0].offset = 0.25;
  EXPECT_NEAR(moving(robot).last("position", 0.1), -3.0 * 0.7 + 0.25, kRounding);
}

TEST(SensorReadings, BetweenStepsAreInterpolated) {
  EXPECT_NEAR(moving(even_motion()).last("position", 0.10037), 0.5 + 2.0 * 0.10037, kRounding);
}

/// Readings of a mass at rest at 0.5 m, `count` samples a step apart.
TimeSeries noisy_readings(double noise, double quantum, std::uint64_t seed, int count) {
  RobotSpec robot = even_motion();
  for (SensorSpec& sensor : robot.sensors) {
    sensor.noise = noise;
    sensor.quantum = quantum;
  }
  SimulationRun run = SimulationRun(robot, kStep).from({0.5}, {0.0});
  run.imperfections = SensorImperfections{.seed = seed};
  return run.run(evenly_spaced(count * kStep, count)).readings;
}

double mean(const Eigen::VectorXd& x) { return x.mean(); }
double deviation(const Eigen::VectorXd& x) {
  return std::sqrt((x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

TEST(SensorNoise, HasTheDeclaredMeanAndDeviation) {
  constexpr double kNoise = 0.03;
  constexpr int kCount = 20000;
  constexpr double kSigmas = 4.5;  // chance of a false alarm below 1e-5
  const TimeSeries readings = noisy_readings(kNoise, 0.0, 7, kCount);
  for (const auto& [channel, level] : {std::pair{"position", 0.5}, std::pair{"velocity", 0.0}}) {
    const Eigen::VectorXd x = column(readings, channel);
    EXPECT_NEAR(mean(x), level, kSigmas * kNoise / std::sqrt(kCount));
    EXPECT_NEAR(deviation(x), kNoise, kSigmas * kNoise / std::sqrt(2.0 * kCount));
    const Eigen::ArrayXd z = (x.array() - level) / kNoise;
    EXPECT_NEAR(z.cube().mean(), 0.0, kSigmas * std::sqrt(15.0 / kCount));             // skewness of a normal
    EXPECT_NEAR(z.square().square().mean(), 3.0, kSigmas * std::sqrt(96.0 / kCount));  // its kurtosis
  }
}

double correlation(const Eigen::ArrayXd& a, const Eigen::ArrayXd& b) {
  const Eigen::ArrayXd x = a - a.mean(), y = b - b.mean();
  return (x * y).mean() / std::sqrt(x.square().mean() * y.square().mean());
}

TEST(SensorNoise, IsIndependentOverTimeAndBetweenChannels) {
  constexpr int kCount = 20000;
  const double bound = 4.5 / std::sqrt(kCount);
  const TimeSeries readings = noisy_readings(0.03, 0.0, 7, kCount);
  const Eigen::VectorXd position = column(readings, "position"), velocity = column(readings, "velocity");
  EXPECT_NEAR(correlation(position.array(), velocity.array()), 0.0, bound);
  for (const Eigen::Index lag : {1, 2, 7})
    EXPECT_NEAR(correlation(position.head(kCount - lag).array(), position.tail(kCount - lag).array()), 0.0, bound);
}

TEST(SensorNoise, IsGivenByItsSeed) {
  const TimeSeries first = noisy_readings(0.03, 0.0, 7, 50), again = noisy_readings(0.03, 0.0, 7, 50);
  const TimeSeries other = noisy_readings(0.03, 0.0, 8, 50);
  EXPECT_EQ(first.samples, again.samples);
  EXPECT_GT((first.samples - other.samples).cwiseAbs().maxCoeff(), 0.01);
}

TEST(SensorNoise, IsAbsentFromIdealReadings) {
  RobotSpec robot = even_motion();
  robot.sensors[0].noise = 0.03;
  robot.sensors[0].quantum = 0.1;
  EXPECT_NEAR(moving(robot).last("position", 0.1), 0.7, kRounding);
}

TEST(SensorQuantiser, RoundsToItsStep) {
  constexpr double kQuantum = 0.013;
  RobotSpec robot = even_motion();
  robot.sensors[0].quantum = kQuantum;
  SimulationRun run = moving(robot);
  run.imperfections = SensorImperfections{};
  const TimeSeries readings = run.run(evenly_spaced(0.5, 500)).readings;
  double largest = 0.0;
  for (Eigen::Index row = 0; row < readings.times.size(); ++row) {
    const double read = column(readings, "position")(row), truth = 0.5 + 2.0 * readings.times(row);
    EXPECT_NEAR(std::remainder(read, kQuantum), 0.0, kRounding);
    largest = std::max(largest, std::abs(read - truth));
  }
  EXPECT_LE(largest, kQuantum / 2 + kRounding);
  EXPECT_GT(largest, 0.45 * kQuantum);
}

TEST(SensorQuantiser, ComesAfterTheNoise) {
  const TimeSeries readings = noisy_readings(0.03, 0.02, 7, 200);
  for (Eigen::Index row = 0; row < readings.times.size(); ++row)
    EXPECT_NEAR(std::remainder(column(readings, "position")(row), 0.02), 0.0, kRounding);
  EXPECT_GT(deviation(column(readings, "position")), 0.02);
}

TEST(SensorState, RestoresDelayLinesAndNoise) {
  RobotSpec robot = even_motion();
  robot.joints[0].stiffness = 30.0;
  robot.sensors[0].delay = 0.0125;
  robot.sensors[0].noise = 0.01;
  SimulationRun run = moving(robot);
  run.imperfections = SensorImperfections{.seed = 3};
  expect_same_bits_after_restore(run, evenly_spaced(0.4, 40), 13);
}

}  // namespace
}  // namespace lacuna::sensor_stage_test

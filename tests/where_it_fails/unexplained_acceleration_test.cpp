#include "where_it_fails/unexplained_acceleration.h"

#include "where_it_fails/wheel_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr Eigen::Index kSamplesOfWheel = 1000;
constexpr double kSensorNoise = 1e-4;

/// A trial of the wheel with one channel, whose free run stays close, and a row of the table for each sample.
struct Residuals {
  Comparison comparison;
  FeatureTable table;

  explicit Residuals(const std::function<double(double time)>& residual, const std::string& channel = "angle",
                     const std::string& unit = "rad") {
    TrialComparison trial;
    trial.times = Eigen::VectorXd::LinSpaced(kSamplesOfWheel, 0.0, kInterval * (kSamplesOfWheel - 1));
    trial.residuals.resize(kSamplesOfWheel, 1);
    for (Eigen::Index i = 0; i < kSamplesOfWheel; ++i) {
      trial.residuals(i, 0) = residual(trial.times(i));
      table.trial.push_back(0);
      table.sample.push_back(i);
    }
    ChannelScore score;
    score.channel = channel;
    score.unit = unit;
    score.samples = kSamplesOfWheel;
    score.normalised_rmse = 0.01;
    score.times_floor = 20.0;
    trial.channels = {score};
    comparison.trials = {trial};
    comparison.floors = {{"", {{channel, unit, kSensorNoise, 0.0, 0.0, kSensorNoise, ""}}}};
  }
  Accelerations accelerations() const { return unexplained_accelerations(wheel(), comparison, table); }
};

/// Half a second into the trial.
constexpr Eigen::Index kInside = 125;
constexpr double kTimeInside = kInterval * kInside;

TEST(UnexplainedAccelerations, AreTheCurvatureOfTheResidualOfAPosition) {
  const auto parabola = [](double t) { return 0.01 + 0.5 * 2.0 * std::pow(t - 1.0, 2); };
  const Accelerations all = Residuals(parabola).accelerations();
  ASSERT_EQ(all.channels.size(), 1U);
  const UnexplainedAcceleration& one = all.channels[0];
  EXPECT_EQ(one.channel.unit, "rad/s^2");
  EXPECT_EQ(all.horizon, 0.0);
  EXPECT_NEAR(one.values(kInside), 2.0, 1e-6);
  EXPECT_NEAR(one.own_error(kInside, 0), parabola(kTimeInside), 1e-9) << "the error itself";
  EXPECT_NEAR(one.own_error(kInside, 1), 2.0 * (kTimeInside - 1.0), 1e-6) << "its derivative";
}

TEST(UnexplainedAccelerations, AreTheSlopeOfTheResidualOfAVelocity) {
  RobotSpec robot = wheel();
  robot.sensors[0].kind = SensorKind::joint_velocity;
  const Residuals line([](double t) { return 3.0 * (t - 1.0); }, "angle", "rad/s");
  const Accelerations all = unexplained_accelerations(robot, line.comparison, line.table);
  ASSERT_EQ(all.channels.size(), 1U);
  EXPECT_EQ(all.channels[0].channel.unit, "rad/s^2");
  EXPECT_NEAR(all.channels[0].values(kInside), 3.0, 1e-9);
  EXPECT_EQ(all.channels[0].own_error.cols(), 1);
}

TEST(UnexplainedAccelerations, AreNoneOfAChannelThatMeasuresNoMotion) {
  RobotSpec robot = wheel();
  robot.sensors[0].kind = SensorKind::joint_force;
  const Residuals line([](double t) { return t; });
  EXPECT_TRUE(unexplained_accelerations(robot, line.comparison, line.table).channels.empty());
}

TEST(UnexplainedAccelerations, HaveNoValueWhereTooFewSamplesSurroundThem) {
  const UnexplainedAcceleration one = Residuals([](double t) { return t * t; }).accelerations().channels[0];
  EXPECT_TRUE(std::isnan(one.values(0)));
  EXPECT_TRUE(std::isnan(one.values(kSamplesOfWheel - 1)));
  EXPECT_TRUE(std::isfinite(one.values(20)));
}

TEST(UnexplainedAccelerations, KnowTheirNoise) {
  SeededNoise random(5, 0);
  const UnexplainedAcceleration one =
      Residuals([&](double) { return kSensorNoise * random.normal(); }).accelerations().channels[0];
  double squares = 0.0, count = 0.0;
  for (Eigen::Index i = 0; i < one.values.size(); ++i)
    if (std::isfinite(one.values(i))) squares += std::pow(one.values(i) / one.deviations(i), 2), count += 1.0;
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.25);
}

/// The deviation falls with the power 5/2 of the window: 4 times as long, a thirty-second of it.
TEST(UnexplainedAccelerations, ComeFromALongerWindowWhereNoiseHidesThem) {
  SeededNoise random(5, 0);
  const double seen = Residuals([](double t) { return t * t; }).accelerations().channels[0].deviations(kInside);
  const double hidden =
      Residuals([&](double) { return kSensorNoise * random.normal(); }).accelerations().channels[0].deviations(kInside);
  EXPECT_NEAR(seen / hidden, 32.0, 6.0);
}

/// A free run that is off by half of the motion is not the state at which forces acted.
TEST(UnexplainedAccelerations, ComeFromTheLongestShortPredictionsWhereTheFreeRunIsFarOff) {
  Residuals far([](double t) { return 100.0 * t * t; });
  TrialComparison& trial = far.comparison.trials[0];
  trial.channels[0].normalised_rmse = 0.5;
  for (const double horizon : {0.1, 0.5, 2.0}) {
    HorizonScore score;
    score.horizon = horizon;
    score.restarts = {0, kSamplesOfWheel / 2};
    score.residuals = (horizon * trial.times.array().square()).matrix();
    trial.horizons.push_back(score);
  }
  const Accelerations all = far.accelerations();
  EXPECT_EQ(all.horizon, 0.5);
  EXPECT_NEAR(all.channels[0].values(kInside), 2.0 * 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(all.channels[0].values(kSamplesOfWheel / 2))) << "no parabola through a restart";
}

}  // namespace
}  // namespace lacuna

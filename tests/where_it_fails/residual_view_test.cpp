#include "where_it_fails/residual_view.h"

#include "where_it_fails/wheel_rig.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::ElementsAre;

constexpr Eigen::Index kRowsOfView = 1000;

/// Random samples of a feature between −1 and 1, and residuals of a channel by it, in units of its floor.
struct Viewed {
  FeatureTable table;
  Comparison comparison;
  SeededNoise random{4, 0};

  Viewed() {
    table.features = {{FeatureKind::position, "position", "", "rad"}};
    table.values.resize(kRowsOfView, 1);
    for (Eigen::Index i = 0; i < kRowsOfView; ++i) {
      table.trial.push_back(0);
      table.sample.push_back(i);
      table.values(i, 0) = 2.0 * std::fmod(0.618033988749895 * static_cast<double>(i), 1.0) - 1.0;
    }
    TrialComparison trial;
    trial.times = Eigen::VectorXd::LinSpaced(kRowsOfView, 0.0, kInterval * (kRowsOfView - 1));
    trial.residuals.resize(kRowsOfView, 0);
    comparison.trials = {trial};
  }
  double sign() { return std::copysign(1.0, random.normal()); }
  void add(const std::string& channel, double floor, const std::function<double(double feature)>& residual) {
    TrialComparison& trial = comparison.trials[0];
    trial.residuals.conservativeResize(kRowsOfView, trial.residuals.cols() + 1);
    for (Eigen::Index i = 0; i < kRowsOfView; ++i)
      trial.residuals(i, trial.residuals.cols() - 1) = floor * residual(table.values(i, 0));
    ChannelScore score;
    score.channel = channel;
    score.unit = "rad";
    score.samples = kRowsOfView;
    score.floor = floor;
    trial.channels.push_back(score);
  }
  ResidualView view() const { return free_run_view(wheel(), comparison, table, {1}); }
};

TEST(ChannelsOfComparison, AreThoseOfTheFitTrialsOnce) {
  Viewed viewed;
  viewed.add("a", 1.0, [](double) { return 0.0; });
  viewed.add("b", 1.0, [](double) { return 0.0; });
  viewed.comparison.trials.push_back(viewed.comparison.trials[0]);
  viewed.comparison.trials[1].channels[1].channel = "c";
  viewed.comparison.trials.push_back(viewed.comparison.trials[0]);
  viewed.comparison.trials[2].channels[0].channel = "of the held-out trial";
  viewed.comparison.trials[2].held_out = true;
  std::vector<std::string> names;
  for (const Channel& channel : channels_of(viewed.comparison)) names.push_back(channel.name);
  EXPECT_THAT(names, ElementsAre("a", "b", "c"));
}

/// Three floors in half of the samples, one in the others: √((9 + 1)/2).
TEST(FreeRunView, IsInMultiplesOfTheFloor) {
  Viewed viewed;
  viewed.add("angle", 1e-3, [&](double x) { return viewed.sign() * (x < 0.0 ? 3.0 : 1.0); });
  EXPECT_NEAR(viewed.view().times_floor, std::sqrt(5.0), 0.02);
}

TEST(FreeRunView, DividesTheErrorIntoRegimes) {
  Viewed viewed;
  viewed.add("angle", 1e-3, [&](double x) { return viewed.sign() * (x < 0.0 ? 3.0 : 1.0); });
  const ResidualView view = viewed.view();
  ASSERT_EQ(view.regimes.size(), 2U);
  const Regime& most = view.regimes[0];
  EXPECT_NEAR(most.share_of_error, 0.9, 0.01);
  EXPECT_NEAR(most.share_of_samples, 0.5, 0.01);
  EXPECT_NEAR(most.times_floor, 3.0, 0.02);
  EXPECT_NEAR(view.regimes[1].times_floor, 1.0, 0.02);
  ASSERT_EQ(most.conditions.size(), 1U);
  EXPECT_NEAR(most.conditions[0].upper, 0.0, 0.02);
  EXPECT_TRUE(std::isinf(most.conditions[0].lower));
}

TEST(FreeRunView, SharesTheErrorAmongTheChannels) {
  Viewed viewed;
  viewed.add("near", 1e-3, [&](double) { return viewed.sign(); });
  viewed.add("far", 5.0, [&](double) { return 3.0 * viewed.sign(); });
  const ResidualView view = viewed.view();
  ASSERT_EQ(view.channels.size(), 2U);
  EXPECT_NEAR(view.channels[0].share_of_error, 0.1, 1e-9);
  EXPECT_NEAR(view.channels[1].share_of_error, 0.9, 1e-9);
  EXPECT_EQ(view.family, 2U * 2U * 1U) << "two views, two channels, one feature";
}

TEST(FreeRunView, KnowsOnWhichFeatureAChannelDepends) {
  Viewed viewed;
  viewed.add("sloped", 1e-3, [&](double x) { return 2.0 * x + viewed.random.normal(); });
  viewed.add("noise", 1e-3, [&](double) { return viewed.random.normal(); });
  const ResidualView view = viewed.view();
  EXPECT_TRUE(view.depends(0, 0));
  EXPECT_FALSE(view.depends(1, 0));
}

TEST(FreeRunView, HasNoValueWhereATrialLacksTheChannelOrItsFloor) {
  Viewed viewed;
  viewed.add("angle", 1e-3, [&](double) { return viewed.sign(); });
  viewed.add("unknown", 1e-3, [&](double) { return viewed.sign(); });
  viewed.comparison.trials[0].channels[1].floor = std::nan("");
  const ResidualView view = viewed.view();
  EXPECT_TRUE(view.residuals.col(0).allFinite());
  EXPECT_TRUE(view.residuals.col(1).array().isNaN().all());
  EXPECT_NEAR(view.times_floor, 1.0, 1e-9);
}

/// Of a touch sensor that its residual depends on contact shows nothing.
TEST(FreeRunView, DoesNotAskATouchSensorForItsContact) {
  RobotSpec robot = wheel();
  robot.sensors[0].kind = SensorKind::touch;
  robot.sensors[0].element = "wheel";
  Viewed viewed;
  viewed.table.features[0].kind = FeatureKind::contact;
  viewed.add("angle", 1e-3, [&](double x) { return 2.0 * x + viewed.sign(); });
  EXPECT_TRUE(viewed.view().depends(0, 0));
  EXPECT_FALSE(free_run_view(robot, viewed.comparison, viewed.table, {1}).depends(0, 0));
}

TEST(AccelerationView, HasNoChannelsWhereNoMotionIsMeasured) {
  RobotSpec robot = wheel();
  robot.sensors[0].kind = SensorKind::joint_force;
  Viewed viewed;
  viewed.add("angle", 1e-3, [&](double) { return viewed.sign(); });
  EXPECT_TRUE(acceleration_view(robot, viewed.comparison, viewed.table, {1}).channels.empty());
}

}  // namespace
}  // namespace lacuna

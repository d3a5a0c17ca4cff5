#include "diagnosis/experiment_design/test_conditions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kPeriod = 0.01;  // s

/// Two segments of half a second, the first at a trial's start, one channel in bins of five samples.
Round round_of_two_segments() {
  std::vector<RowBins::Bin> bins;
  for (int i = 0; i < 10; ++i) bins.push_back({0, 0.05 * i, 5.0});
  Round round(RowBins({bins, bins}));
  Trial trial;
  trial.measured.times = Eigen::VectorXd::LinSpaced(101, 0.0, 1.0);
  round.base.trials = {trial};
  round.base.noise = {{"angle", "rad", 1e-3, "declared"}};
  Segment first, second;
  first.stretch = {0, 0, 51};
  first.start = {{0.3}, {-0.1}};
  first.unknown = {0, 1};
  first.deviation = Eigen::Vector2d(0.02, std::numeric_limits<double>::infinity());
  second.stretch = {0, 40, 61};
  second.run_in = 10;
  round.base.segments = {second, first};
  return round;
}

/// Sensor noise, white and slow.
void set_noise(Round& round, double white, double slow) { round.noise.set_deviations({white, slow}); }

TEST(TestConditions, BeginAsTheFirstTrialDidAsWellAsThatIsKnown) {
  const TestConditions conditions = like_the_trials(round_of_two_segments(), kPeriod);
  EXPECT_EQ(conditions.start.positions, std::vector{0.3});
  EXPECT_EQ(conditions.start.velocities, std::vector{-0.1});
  EXPECT_EQ(conditions.start_deviation, (std::vector{0.02, 0.0})) << "what no reading tells is not refitted";
}

TEST(TestConditions, CountReadingsThatShareSlowNoiseAsOne) {
  Round round = round_of_two_segments();
  set_noise(round, 2.0, 0.0);
  EXPECT_DOUBLE_EQ(like_the_trials(round, kPeriod).noise.at(0).deviation, 2e-3);
  set_noise(round, 2.0, 1.0);
  const double alike = 2.0 * kSlowSensor / kPeriod;
  EXPECT_DOUBLE_EQ(like_the_trials(round, kPeriod).noise.at(0).deviation, 1e-3 * std::sqrt(4.0 + alike));
  set_noise(round, 0.3, 0.0);
  EXPECT_DOUBLE_EQ(like_the_trials(round, kPeriod).noise.at(0).deviation, 1e-3) << "a sensor is no better than it says";
}

}  // namespace
}  // namespace lacuna

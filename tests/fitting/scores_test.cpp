#include "fitting/scores.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna::scores_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Five readings of an angle each tenth of a second, the first of which is not scored and the fourth not measured.
TrialComparison comparison() {
  TrialComparison trial;
  trial.trial = "one";
  trial.first_scored = 1;
  trial.times = Eigen::VectorXd::LinSpaced(5, 0.0, 0.4);
  trial.measured.resize(5, 1);
  trial.measured << 10.0, 1.0, 2.0, kNone, 4.0;
  trial.predicted.resize(5, 1);
  trial.predicted << 1.0, 0.0, 4.0, 3.0, 2.0;
  trial.residuals = trial.measured - trial.predicted;
  return trial;
}

const FloorValue kFloor = {"angle", "rad", 0.5, 0.0, 0.0, 0.5, "the sensor"};

TEST(ScoreChannel, IsOfTheMeasuredReadingsThatAreScored) {
  const ChannelScore score = score_channel(comparison(), 0, kFloor);
  EXPECT_EQ(score.channel, "angle");
  EXPECT_EQ(score.unit, "rad");
  EXPECT_EQ(score.samples, 3U);
  EXPECT_DOUBLE_EQ(score.rmse, std::sqrt((1.0 + 4.0 + 4.0) / 3.0));
  EXPECT_DOUBLE_EQ(score.times_floor, 2.0 * score.rmse);
  EXPECT_DOUBLE_EQ(score.bias, (1.0 - 2.0 + 2.0) / 3.0);
  EXPECT_DOUBLE_EQ(score.normalised_rmse, score.rmse / std::sqrt(14.0 / 9.0)) << "standard deviation of 1, 2 and 4";
  EXPECT_NEAR(score.parts.bias_share, std::pow(score.bias / score.rmse, 2), 1e-12);
}

TEST(ScoreChannel, KnowsTheFirstTimeOfTheLargestError) {
  const ChannelScore score = score_channel(comparison(), 0, kFloor);
  EXPECT_EQ(score.max_error, 2.0);
  EXPECT_DOUBLE_EQ(score.max_error_time, 0.2);
}

TEST(ScoreChannel, OfATrialThatCannotBeSimulatedOnlyCountsWhatIsToBeScored) {
  TrialComparison failed = comparison();
  failed.valid = false;
  const ChannelScore score = score_channel(failed, 0, kFloor);
  EXPECT_EQ(score.samples, 3U);
  EXPECT_TRUE(std::isnan(score.rmse) && std::isnan(score.max_error) && std::isnan(score.bias));
  EXPECT_EQ(score.floor, 0.5);
}

/// A trial whose only channel has this error (RMS and largest) over so many samples.
TrialComparison scored(const std::string& name, double rmse, std::size_t samples, bool held_out = false) {
  TrialComparison trial;
  trial.trial = name;
  trial.held_out = held_out;
  ChannelScore score;
  score.channel = "angle";
  score.unit = "rad";
  score.samples = samples;
  score.rmse = score.max_error = score.rmse_as_written = rmse;
  score.max_error_time = 10.0 * rmse;
  score.floor = 0.5;
  score.from_start = 0.1;
  score.numerical = 0.01;
  trial.channels = {score};
  return trial;
}

std::vector<TrialFloor> floors_of(const std::vector<TrialComparison>& trials) {
  std::vector<TrialFloor> floors;
  for (const TrialComparison& trial : trials) {
    FloorValue floor = kFloor;
    floor.origin = "noise of " + trial.trial;
    floors.push_back({trial.trial, std::vector<FloorValue>(trial.channels.size(), floor)});
  }
  return floors;
}

std::vector<PooledScore> pooled(const std::vector<TrialComparison>& trials) { return pool(trials, floors_of(trials)); }

TEST(Pool, WeighsSquaresBySamples) {
  const PooledScore all = pooled({scored("one", 1.0, 30), scored("two", 3.0, 10)})[0];
  EXPECT_EQ(all.samples, 40U);
  EXPECT_DOUBLE_EQ(all.rmse, std::sqrt((30.0 * 1.0 + 10.0 * 9.0) / 40.0));
  EXPECT_DOUBLE_EQ(all.floor, 0.5);
  EXPECT_DOUBLE_EQ(all.times_floor, 2.0 * all.rmse);
  EXPECT_DOUBLE_EQ(all.from_start, 0.1);
  EXPECT_DOUBLE_EQ(*all.numerical, 0.01);
  EXPECT_EQ(all.worst_trial, "two");
  EXPECT_DOUBLE_EQ(all.worst_time, 30.0);
  EXPECT_EQ(all.floor_origin, "noise of two");
}

TEST(Pool, KeepsHeldOutTrialsApart) {
  const std::vector<PooledScore> all = pooled({scored("one", 1.0, 30), scored("held", 3.0, 10, true)});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_FALSE(all[0].held_out);
  EXPECT_DOUBLE_EQ(all[0].rmse, 1.0);
  EXPECT_TRUE(all[1].held_out);
  EXPECT_DOUBLE_EQ(all[1].rmse, 3.0);
}

/// A model gains nothing by failing on its hardest trial.
TEST(Pool, HasNoErrorWhereATrialCannotBeSimulated) {
  TrialComparison failed = scored("two", kNone, 10);
  failed.valid = false;
  failed.channels[0].rmse_as_written = 3.0;
  const PooledScore all = pooled({scored("one", 1.0, 30), failed})[0];
  EXPECT_EQ(all.failed_trials, 1);
  EXPECT_TRUE(std::isnan(all.rmse) && std::isnan(all.times_floor));
  EXPECT_EQ(all.samples, 30U);
  EXPECT_EQ(all.worst_trial, "one");
  EXPECT_DOUBLE_EQ(all.rmse_as_written, std::sqrt((30.0 + 90.0) / 40.0));
}

TEST(Pool, LeavesOutChannelsOfWhichNothingIsScored) {
  std::vector<TrialComparison> trials = {scored("one", 1.0, 30)};
  trials[0].channels.push_back(trials[0].channels[0]);
  trials[0].channels[1].channel = "speed";
  trials[0].channels[1].samples = 0;
  ASSERT_EQ(pooled(trials).size(), 1U);
  EXPECT_EQ(pooled(trials)[0].channel, "angle");
}

TEST(Pool, HasNoNumericalShareWhereOneTrialHasNone) {
  std::vector<TrialComparison> trials = {scored("one", 1.0, 30), scored("two", 3.0, 10)};
  trials[0].channels[0].numerical = std::nullopt;
  EXPECT_FALSE(pooled(trials)[0].numerical);
}

TEST(Pool, SaysWhyItsFloorIsNotKnown) {
  std::vector<TrialComparison> trials = {scored("one", 1.0, 30), scored("two", 3.0, 10)};
  trials[0].channels[0].floor = kNone;
  const PooledScore all = pooled(trials)[0];
  EXPECT_TRUE(std::isnan(all.floor));
  EXPECT_EQ(all.floor_origin, "noise of one");
}

}  // namespace
}  // namespace lacuna::scores_test

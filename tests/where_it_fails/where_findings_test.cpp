#include "where_it_fails/where_it_fails.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

/// A view of a free run, three floors off, with one channel that has all of the error.
ResidualView view_of_one_channel() {
  ResidualView view;
  view.times_floor = 3.0;
  view.channels.resize(1);
  view.channels[0].channel = "angle";
  view.channels[0].unit = "rad";
  view.channels[0].share_of_error = 1.0;
  return view;
}

TrialComparison trial_of_one_channel(const std::string& name, double times_floor, std::size_t samples = 100) {
  ChannelScore score;
  score.channel = "angle";
  score.samples = samples;
  score.times_floor = times_floor;
  score.normalised_rmse = std::nan("");
  TrialComparison trial;
  trial.trial = name;
  trial.channels = {score};
  return trial;
}

Comparison two_trials(double first, double second) {
  Comparison comparison;
  comparison.trials = {trial_of_one_channel("first", first), trial_of_one_channel("second", second)};
  return comparison;
}

TEST(FindingsOf, NameADependenceWithTheShareOfWhatWasSelected) {
  ResidualView view = view_of_one_channel();
  view.channels[0].share_of_error = 0.5;
  view.channels[0].selected = {{4, 0.6, 1e-5}, {2, 0.2, 1e-3}};
  view.channels[0].not_on = {1};
  const std::vector<Finding> found = findings_of(two_trials(3.0, 3.0), {view});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FindingKind::dependence);
  EXPECT_NEAR(found[0].share, 0.4, 1e-12);
  EXPECT_EQ(found[0].features, (std::vector<std::size_t>{4, 2}));
  EXPECT_EQ(found[0].not_on, (std::vector<std::size_t>{1}));
  EXPECT_EQ(found[0].p, 1e-5);
}

TEST(FindingsOf, NameARegimeWithHalfAsMuchErrorAgainAsSamples) {
  ResidualView view = view_of_one_channel();
  view.regimes = {{{}, 0.6, 0.3, 5.0}, {{}, 0.3, 0.25, 3.0}, {{}, 0.09, 0.01, 9.0}};
  const std::vector<Finding> found = findings_of(two_trials(3.0, 3.0), {view});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FindingKind::regime);
  EXPECT_EQ(found[0].share, 0.6);
}

/// At the floor there is nothing to find but a dependence.
TEST(FindingsOf, NameNoRegimeNearTheFloor) {
  ResidualView view = view_of_one_channel();
  view.regimes = {{{}, 0.6, 0.3, 1.5}};
  view.channels[0].selected = {{0, 0.3, 1e-5}};
  view.times_floor = 1.1;
  const std::vector<Finding> found = findings_of(two_trials(1.1, 1.1), {view});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FindingKind::dependence);
}

/// 100 samples 1 mrad and 300 samples 3 mrad off.
TEST(FindingsOf, NameAnOffsetWithItsMeanOverAllSamples) {
  ResidualView view = view_of_one_channel();
  view.channels[0].mean.testable = true;
  view.channels[0].mean.p = 1e-4;
  view.channels[0].mean.share = 0.5;
  Comparison comparison;
  comparison.trials = {trial_of_one_channel("first", 3.0, 100), trial_of_one_channel("second", 3.0, 300)};
  comparison.trials[0].channels[0].bias = 1e-3;
  comparison.trials[1].channels[0].bias = 3e-3;
  const std::vector<Finding> found = findings_of(comparison, {view});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FindingKind::offset);
  EXPECT_NEAR(found[0].size, 2.5e-3, 1e-12);
  EXPECT_EQ(found[0].unit, "rad");
  view.channels[0].mean.share = 0.1;
  EXPECT_TRUE(findings_of(comparison, {view}).empty()) << "a tenth of the squares is too little";
}

/// Of squares 16 to 1.
TEST(FindingsOf, NameATrialWithMostOfTheError) {
  const std::vector<Finding> found = findings_of(two_trials(1.0, 4.0), {view_of_one_channel()});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, FindingKind::trial);
  EXPECT_EQ(found[0].trial, "second");
  EXPECT_NEAR(found[0].share, 16.0 / 17.0, 1e-12);
  EXPECT_NEAR(found[0].share_of_samples, 0.5, 1e-12);
}

TEST(FindingsOf, NameNoTrialForBeingLong) {
  Comparison comparison = two_trials(3.0, 3.0);
  comparison.trials[1].channels[0].samples = 900;
  EXPECT_TRUE(findings_of(comparison, {view_of_one_channel()}).empty());
}

TEST(FindingsOf, DoNotCountWhatIsHeldOut) {
  Comparison comparison = two_trials(3.0, 3.0);
  comparison.trials.push_back(trial_of_one_channel("held out", 50.0));
  comparison.trials.back().held_out = true;
  EXPECT_TRUE(findings_of(comparison, {view_of_one_channel()}).empty());
}

TEST(FindingsOf, BeginWithTheLargestShareAndLeaveOutLessThanAHundredth) {
  ResidualView view = view_of_one_channel();
  view.channels.assign(3, view.channels[0]);
  const std::vector<double> shares = {0.2, 0.005, 0.7};
  for (std::size_t i = 0; i < 3; ++i) view.channels[i].selected = {{i, shares[i], 1e-5}};
  const std::vector<Finding> found = findings_of(two_trials(3.0, 3.0), {view});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].share, 0.7);
  EXPECT_EQ(found[1].share, 0.2);
}

}  // namespace
}  // namespace lacuna

#include "report/text/advice_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// One channel of the fit trials with a floor of 1 mrad.
PooledScore fit_score(double rmse, double from_start) {
  PooledScore score;
  score.channel = "angle";
  score.unit = "rad";
  score.samples = 100;
  score.rmse = rmse;
  score.floor = 1e-3;
  score.times_floor = rmse / score.floor;
  score.from_start = from_start;
  return score;
}

Comparison comparison_of(const PooledScore& score) {
  Comparison comparison;
  comparison.trials.resize(2);
  comparison.trials[0].trial = "sine";
  comparison.trials[1].trial = "chirp";
  comparison.pooled = {score};
  return comparison;
}

std::string advice_on(const PooledScore& score) {
  return advice_text(comparison_of(score), "lacuna diagnose rig.toml");
}

TEST(AdviceText, AnErrorOfTheFloorsSizeIsAtTheFloor) {
  EXPECT_EQ(advice_on(fit_score(1.1e-3, 0.0)), "Error is 1.1 × the noise floor: as small as the noise allows\n");
}

TEST(AdviceText, WhatTheUncertainStartExplainsIsNoMissingEffect) {
  // √(1² + (2 · 0.6)²) mrad = 1.56 mrad is what a right model leaves 19 times in 20 after one start like this.
  EXPECT_THAT(
      advice_on(fit_score(1.7e-3, 6e-4)),
      AllOf(
          HasSubstr(
              "Error is 1.7 × the noise floor. The initial-state uncertainty can explain it: a correct model has up to "
              "1.9 ×. No missing effect is visible\n"),
          Not(HasSubstr("something is missing")), Not(HasSubstr("lacuna diagnose"))));
  EXPECT_TRUE(advice_on(comparison_of(fit_score(1.7e-3, 6e-4)), "lacuna diagnose rig.toml").is_explained);
}

TEST(AdviceText, WhatTheStartDoesNotExplainMayBeAnEffect) {
  EXPECT_THAT(advice_on(fit_score(8e-3, 2e-3)),
              AllOf(HasSubstr("Error is 8.0 × the noise floor: something is missing."),
                    HasSubstr("Next: lacuna diagnose rig.toml\n")));
}

TEST(AdviceText, ManyTrialsLeaveLessToTheChanceOfTheirStarts) {
  // 16 starts: √(1² + (1.25 · 2)²) mrad = 2.7 mrad, not √(1² + 4²) mrad = 4.1 mrad as after one.
  Comparison comparison = comparison_of(fit_score(4.5e-3, 2e-3));
  EXPECT_THAT(advice_text(comparison, "lacuna diagnose rig.toml"), HasSubstr("initial-state uncertainty"));
  ChannelScore score;
  score.channel = "angle";
  score.samples = 100;
  comparison.trials.resize(16);
  for (TrialComparison& trial : comparison.trials) trial.channels = {score};
  EXPECT_THAT(advice_text(comparison, "lacuna diagnose rig.toml"),
              HasSubstr("Error is 4.5 × the noise floor: something is missing"));
}

TEST(AdviceText, TheChannelWithTheMostUnexplainedErrorCounts) {
  Comparison comparison = comparison_of(fit_score(4e-3, 4e-3));
  comparison.pooled.push_back(fit_score(3e-3, 0.0));
  EXPECT_THAT(advice_text(comparison, "lacuna diagnose rig.toml"),
              HasSubstr("Error is 3.0 × the noise floor: something is missing"));
}

/// A right fit of the fit trials, and a held-out trial with this error.
Comparison with_held_out(double rmse) {
  Comparison comparison = comparison_of(fit_score(1e-3, 0.0));
  comparison.pooled.push_back(fit_score(rmse, 0.0));
  comparison.pooled.back().held_out = true;
  comparison.pooled.back().worst_trial = "held.csv";
  comparison.pooled.back().worst_time = 5.22;
  return comparison;
}

TEST(AdviceText, AModelIsNotAtTheFloorWhereHeldOutTrialsAreNot) {
  EXPECT_THAT(advice_text(with_held_out(9e-3), "lacuna diagnose rig.toml"),
              AllOf(HasSubstr("Error is 1.0 × the noise floor: as small as the noise allows. Held-out files: "
                              "angle 9.0 ×, largest in held.csv at 5.22 s. Either this motion"),
                    HasSubstr("Next: move a held-out file to target.files, then lacuna diagnose rig.toml\n")));
}

TEST(AdviceText, SaysWhereTheStartExplainsTheErrorOfHeldOutTrials) {
  Comparison comparison = with_held_out(9e-3);
  comparison.pooled.back().from_start = 5e-3;
  EXPECT_EQ(advice_text(comparison, "lacuna diagnose rig.toml"),
            "Error is 1.0 × the noise floor: as small as the noise allows. Held-out files: angle 9.0 × (a correct "
            "model has up to 12.1 ×, because of the initial-state uncertainty). No missing effect is visible\n");
}

TEST(AdviceText, HeldOutTrialsAtTheFloorAreNotWorthAWord) {
  EXPECT_EQ(advice_text(with_held_out(1.1e-3), "lacuna diagnose rig.toml"),
            "Error is 1.0 × the noise floor: as small as the noise allows\n");
}

TEST(AdviceText, ATrialThatCannotBeSimulatedIsNeverAtTheFloor) {
  Comparison comparison = comparison_of(fit_score(std::nan(""), 0.0));
  comparison.pooled[0].failed_trials = 1;
  comparison.trials[1].valid = false;
  comparison.trials[1].reason = "the hinge turns too fast";
  EXPECT_THAT(advice_text(comparison, "lacuna diagnose rig.toml"),
              AllOf(HasSubstr("1 of 2 trials cannot be simulated"), HasSubstr("chirp: the hinge turns too fast"),
                    Not(HasSubstr("noise floor"))));
}

TEST(AdviceText, AFloorThatIsNotKnownIsNotReached) {
  PooledScore score = fit_score(1e-3, 0.0);
  score.floor = score.times_floor = std::nan("");
  score.floor_origin = "no run could be simulated";
  EXPECT_EQ(advice_on(score), "the noise floor of angle is not known: no run could be simulated\n");
}

TEST(AdviceText, NothingScoredIsNoAgreement) {
  Comparison comparison = comparison_of(fit_score(1e-3, 0.0));
  comparison.pooled[0].held_out = true;
  EXPECT_THAT(advice_text(comparison, "lacuna diagnose rig.toml"), HasSubstr("no fit trial was scored"));
}

}  // namespace
}  // namespace lacuna

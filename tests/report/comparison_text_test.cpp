#include "report/text/comparison_text.h"

#include "report/json/comparison_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A comparison of one scored trial with a floor of 1 mrad.
Comparison one_trial(double from_start) {
  ChannelScore score;
  score.channel = "angle";
  score.unit = "rad";
  score.samples = 100;
  score.rmse = 2e-3;
  score.floor = 1e-3;
  score.times_floor = 2.0;
  score.max_error_time = 0.5;
  score.from_start = from_start;
  TrialComparison trial;
  trial.trial = "sine";
  trial.channels = {score};
  PooledScore pooled;
  pooled.channel = "angle";
  pooled.unit = "rad";
  pooled.samples = 100;
  pooled.floor = 1e-3;
  pooled.from_start = from_start;
  Comparison comparison;
  comparison.trials = {trial};
  comparison.pooled = {pooled};
  return comparison;
}

FitResult as_written_fit() {
  FittedValue value;
  value.address = "body.arm.mass";
  value.unit = "kg";
  value.start = value.value = 0.5;
  value.standard_error = value.lower_95 = value.upper_95 = std::nan("");
  FitResult fit;
  fit.values = {value};
  return fit;
}

TEST(ComparisonText, ShowsTheFloorOfAFileWhereItIsAnotherOne) {
  Comparison comparison = one_trial(0.0);
  EXPECT_THAT(comparison_text({}, comparison, {}), Not(HasSubstr(" of 1.00 mrad")));
  comparison.trials.push_back(comparison.trials.front());
  comparison.trials.back().held_out = true;
  comparison.trials.back().channels.front().floor = 5e-3;
  comparison.trials.back().channels.front().times_floor = 0.4;
  EXPECT_THAT(comparison_text({}, comparison, {}), HasSubstr("0.4 (floor 5.00 mrad)"));
}

TEST(ComparisonText, NamesTheShareOfTheStartWhereItMatters) {
  EXPECT_THAT(comparison_text({}, one_trial(4e-4), {}),
              HasSubstr("noise floor 1.00 mrad · effect of the initial-state uncertainty 400 µrad · numerical error"));
  EXPECT_THAT(comparison_text({}, one_trial(9e-5), {}), Not(HasSubstr("effect of the initial-state uncertainty")));
}

TEST(ComparisonText, NamesTheSetupsOfTheRecordings) {
  const std::vector<KnownSetup> loads = {{.recordings = {"bare.csv"}},
                                         {.names = {"heavy", "heavy-2"},
                                          .settings = {{"body.load.mass", 0.49, "kg"}, {"actuator.motor.kp", 400, "1"}},
                                          .recordings = {"heavy.csv", "heavy-2.csv"}}};
  ComparisonHeading heading;
  heading.setups = loads;
  const std::string lines =
      "no setup: values of the model · bare.csv\n"
      "setup heavy: body.load.mass = 0.49 kg, actuator.motor.kp = 400 · heavy.csv, heavy-2.csv\n";
  EXPECT_THAT(comparison_text(heading, one_trial(0.0), {}), HasSubstr(lines));
  EXPECT_THAT(comparison_json(heading, one_trial(0.0), {}, {}), HasSubstr("\"recordings\""));
  heading.setups = {{}};
  EXPECT_THAT(comparison_text(heading, one_trial(0.0), {}), Not(HasSubstr("setup")));
}

TEST(ComparisonText, AnUnscoredTrialHasNoWorstMoment) {
  Comparison comparison = one_trial(0.0);
  ChannelScore& score = comparison.trials[0].channels[0];
  score.samples = 0;
  score.rmse = score.times_floor = score.max_error = score.max_error_time = std::nan("");
  EXPECT_THAT(comparison_text({}, comparison, {}), Not(HasSubstr("nan")));
}

TEST(FitText, ValuesThatWereNotFittedHaveNoInterval) {
  EXPECT_THAT(fit_text(as_written_fit()), AllOf(HasSubstr("0.500"), Not(HasSubstr("nan")), Not(HasSubstr("["))));
}

TEST(ComparisonJson, HoldsTheShareOfTheStartAndFailedTrials) {
  const std::string text = comparison_json({}, one_trial(0.25), {}, {});
  EXPECT_THAT(text, HasSubstr("\"from_start\": 0.25"));
  EXPECT_THAT(text, HasSubstr("\"failed_trials\": 0"));
}

TEST(ComparisonCsv, HasAsManyValuesAsNames) {
  Comparison comparison = one_trial(0.0);
  comparison.trials[0].channels[0].parts.theil_u = 0.125;
  const std::string text = comparison_csv(comparison);
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find('\n'));
  EXPECT_EQ(std::count(text.begin(), end, ','), std::count(end, text.end(), ','));
  EXPECT_THAT(text, HasSubstr("theil_u"));
  EXPECT_THAT(text, HasSubstr(",0.125,"));
}

TEST(ComparisonCsv, QuotesNamesThatWouldBreakTheTable) {
  Comparison comparison = one_trial(0.0);
  comparison.trials[0].trial = "one, \"two\".csv";
  EXPECT_THAT(comparison_csv(comparison), HasSubstr("\n\"one, \"\"two\"\".csv\",0,"));
}

TEST(DataChecksText, NamesEachFaultAndWhatItMeans) {
  EXPECT_EQ(data_checks_text({}), "");
  EXPECT_EQ(data_checks_text({{Severity::fault, "sine.csv: angle does not move"},
                              {Severity::fault, "steps.csv: angle does not move"},
                              {Severity::note, "nothing is held out"}}),
            "data check failed: sine.csv: angle does not move\n"
            "data check failed: steps.csv: angle does not move\n"
            "correct the data first: the fitted values and the verdict of lacuna diagnose may be wrong\n");
}

/// A fall takes as long as it takes: nothing about it is to be corrected.
TEST(DataChecksText, NotesWhatLimitsTheDataAndAsksForNoCorrection) {
  EXPECT_EQ(data_checks_text({{Severity::too_little, "the fit files hold 0.64 s"}}),
            "note: the fit files hold 0.64 s\n");
}

}  // namespace
}  // namespace lacuna

#include "report/figures/learning_curves.h"

#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

PassRow pass_with(int number, double score, double mass_error) {
  PassRow pass;
  pass.number = number;
  pass.steps = 900;
  pass.test_steps = 100;
  pass.best_score = score;
  pass.objective = {{"torso", "kg", 9.0}, {"body.*.mass", "kg", mass_error}};
  return pass;
}

/// A run whose mass error is halved by each pass, from `first` on.
std::vector<PassRow> halving_run(double first, int passes) {
  std::vector<PassRow> run;
  for (int number = 1; number <= passes; ++number)
    run.push_back(pass_with(number, 0.5, first * std::pow(0.5, number - 1)));
  return run;
}

TEST(LearningCurves, KnowWhichErrorsAllRunsHave) {
  std::vector<std::vector<PassRow>> runs = {halving_run(1.0, 2), halving_run(2.0, 3)};
  EXPECT_THAT(errors_in(runs), ElementsAre("body.*.mass", "torso"));
  runs[1].back().objective.erase(runs[1].back().objective.begin());
  EXPECT_THAT(errors_in(runs), ElementsAre("body.*.mass"));
  EXPECT_TRUE(errors_in({}).empty());
}

TEST(LearningCurves, CountTrialsAndSteps) {
  std::vector<PassRow> run = {pass_with(0, NAN, NAN)};  // before the first trial
  for (PassRow& pass : halving_run(4.0, 2)) run.push_back(pass);
  const LearningCurve curve = learning_curve("masses", {run}, "body.*.mass");
  EXPECT_EQ(curve.unit, "kg");
  ASSERT_EQ(curve.runs[0].size(), 2U);
  EXPECT_EQ(curve.runs[0][0].trials, 1);
  EXPECT_EQ(curve.runs[0][0].steps, 2000.0);
  EXPECT_EQ(curve.runs[0][1].error, 2.0);
  EXPECT_EQ(learning_curve("masses", {run}, "").runs[0][0].error, 0.5) << "the score";
}

TEST(LearningCurves, TakeTheMeanOfLogarithmsWhereAllErrorsAreAboveZero) {
  const LearningCurve curve = learning_curve("masses", {halving_run(1.0, 2), halving_run(4.0, 2)}, "body.*.mass");
  const MeanError mean({curve});
  EXPECT_TRUE(mean.logarithmic());
  EXPECT_NEAR(mean.after(curve, 1).mean, 2.0, 1e-12);
  LearningCurve counted = curve;
  counted.runs[0][1].error = 0.0;
  const MeanError plain({counted});
  EXPECT_FALSE(plain.logarithmic());
  EXPECT_NEAR(plain.after(counted, 1).mean, 2.5, 1e-12);
  EXPECT_NEAR(plain.after(counted, 2).mean, 1.0, 1e-12);
}

TEST(LearningCurves, ARunThatStoppedKeepsItsLastError) {
  const LearningCurve curve = learning_curve("masses", {halving_run(1.0, 1), halving_run(1.0, 3)}, "body.*.mass");
  EXPECT_NEAR(MeanError({curve}).after(curve, 3).mean, 0.5, 1e-12);
}

TEST(LearningCurves, SayHowManyTrialsReachTheErrorOfAnother) {
  const LearningCurve slow = learning_curve("random", {halving_run(8.0, 6), halving_run(8.0, 6)}, "body.*.mass");
  const LearningCurve quick = learning_curve("chosen", {halving_run(1.0, 6), halving_run(1.0, 6)}, "body.*.mass");
  const MeanError mean({slow, quick});
  const TrialsNeeded needed = trials_needed(mean, quick, slow);  // 8 / 32 is 1 / 4
  EXPECT_EQ(needed.trials, 3);
  EXPECT_EQ(needed.lower, 3);
  EXPECT_EQ(needed.upper, 3);
  EXPECT_EQ(trials_needed(mean, slow, slow).trials, 6);
  EXPECT_EQ(trials_needed(mean, slow, quick).trials, std::nullopt);
  const std::string table = learning_table({slow, quick}, &slow);
  EXPECT_THAT(table, AllOf(HasSubstr("body.*.mass (kg)"), HasSubstr("trials to reach the final error of random"),
                           HasSubstr("3 [3, 3]"), HasSubstr("6e+03")));
  EXPECT_THAT(learning_table({slow, quick}, &quick), HasSubstr("more than 6"));
}

std::string drawn(const Figure& figure) {
  const TestFolder folder;
  write_svg(figure, folder / "curve.svg");
  std::stringstream text;
  text << std::ifstream(folder / "curve.svg").rdbuf();
  return text.str();
}

TEST(LearningCurves, AreDrawnOnLogarithmicAxes) {
  const LearningCurve curve = learning_curve("masses", {halving_run(1.0, 9), halving_run(4.0, 9)}, "body.*.mass");
  EXPECT_THAT(drawn(error_by_trials({curve})), AllOf(HasSubstr("trials of the target"), HasSubstr(">0.01<")));
  EXPECT_THAT(drawn(error_by_steps({curve})), AllOf(HasSubstr("simulated steps"), HasSubstr(">1000<")));
}

}  // namespace
}  // namespace lacuna

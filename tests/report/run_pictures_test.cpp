#include "report/figures/run_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lacuna {
namespace {

/// A run of one pass that hides one mass and finds another.
DrawnRun run_with(double hidden, double found) {
  DrawnRun run;
  run.record.free = {{"body.torso.mass", "kg", 1.0, 7.0, 1.0}};
  run.record.truth = {hidden};
  run.passes.push_back({.number = 1, .best_model = 3, .best_score = 0.1, .best_values = {found}});
  return run;
}

Panel mass_panel(const std::vector<DrawnRun>& runs) {
  for (const NamedFigure& named : run_figures(runs, "title"))
    if (named.name == "parameters_mass") return named.figure.panels.front();
  ADD_FAILURE() << "no picture of masses";
  return {};
}

double drawn(const Panel& panel, const std::string& label) {
  for (const Series& series : panel.series)
    if (series.label == label) return series.y.front();
  ADD_FAILURE() << label << " is not drawn";
  return 0.0;
}

TEST(RunPictures, ShowValuesBesideTheTruthThatAllRunsHave) {
  const Panel panel = mass_panel({run_with(3.0, 3.5), run_with(3.0, 4.5)});
  EXPECT_EQ(drawn(panel, "truth"), 3.0);
  EXPECT_EQ(drawn(panel, "models of the last pass"), 4.0);
}

TEST(RunPictures, SayWhatBandsAndBarsAre) {
  const std::vector<DrawnRun> runs = {run_with(3.0, 3.5), run_with(3.0, 4.5)};
  EXPECT_EQ(mass_panel(runs).series.front().label, "standard deviation between runs");
  EXPECT_EQ(run_figures(runs, "title").front().figure.panels.front().series.front().label, "95 % interval of the mean");
  EXPECT_EQ(mass_panel({run_with(3.0, 3.5)}).series.front().label, "") << "one run has no deviation";
}

TEST(RunPictures, ShowErrorsWhereEachRunHidesValuesOfItsOwn) {
  const Panel panel = mass_panel({run_with(2.0, 2.5), run_with(6.0, 7.5)});
  EXPECT_EQ(drawn(panel, "truth"), 0.0);
  EXPECT_EQ(drawn(panel, "models of the last pass"), 1.0) << "the mean of 0.5 and 1.5";
  EXPECT_EQ(panel.y_label, "mass, estimate minus hidden value (kg)");
}

TEST(RunPictures, LeaveOutWhatNoModelAndNoTargetHas) {
  for (const NamedFigure& named : run_figures({run_with(kNotKnown, kNotKnown)}, "title"))
    EXPECT_NE(named.name, "parameters_mass") << "the effect that has it is left out";
  const Panel truth_alone = mass_panel({run_with(2.0, kNotKnown)});
  ASSERT_EQ(truth_alone.series.size(), 1U);
  EXPECT_EQ(truth_alone.series[0].label, "truth");
}

}  // namespace
}  // namespace lacuna

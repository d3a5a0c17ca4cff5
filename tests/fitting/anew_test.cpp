#include "fitting/anew.h"

#include "fitting/made_problem.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::anew_test {
namespace {

using namespace lacuna::analytic;

constexpr double kSigma = 0.01;
const std::string kStage = "free run";

/// The last stage of a fit that has one candidate.
struct LastStage {
  LastStage(const FormulaModel::Formula& formula, std::vector<FreeValue> free, const std::vector<double>& truth,
            const std::vector<double>& candidate)
      : made(formula_problem(formula, std::move(free), {formula_trial(formula, truth, 4.0, 50.0, kSigma, 1)})) {
    candidates = {evaluate(made.problem, made.at(candidate), {loss})};
  }

  AnewTask task() { return {fit, made.space, loss, made.problem, meter, kStage}; }
  std::vector<double> best() const { return made.space.to_values(candidates.back().values); }

  MadeProblem made;
  const FitTask fit{made.definition, *made.model, made.predictor.trials(), {.starts = 4}, 1};
  const RobustLoss loss{3.0};
  const ProgressCallback nobody;
  ProgressMeter meter{nobody};
  std::vector<Candidate> candidates;
};

/// A frequency has many minima.
double wave(std::span<const double> p, double t) { return std::sin(p[0] * t); }

TEST(TryAllStarts, LeavesAMinimumThatIsNotTheBest) {
  LastStage stage(wave, {free_value("frequency", 2.9, 0.1, 20.0)}, {3.0}, {9.0});
  EXPECT_EQ(try_all_starts(stage.task(), stage.candidates), 4);
  ASSERT_GE(stage.candidates.size(), 2U);
  const Candidate& first = stage.candidates.front();
  for (std::size_t i = 1; i < stage.candidates.size(); ++i) EXPECT_LT(stage.candidates[i].objective, first.objective);
  EXPECT_NEAR(stage.made.space.to_values(stage.candidates[1].values)[0], 3.0, 0.01) << "from the model's own start";
}

TEST(TryAllStarts, AddsNothingToTheBest) {
  LastStage stage(wave, {free_value("frequency", 9.0, 8.0, 20.0)}, {3.0}, {8.0});
  stage.candidates.front().objective = -1e9;
  EXPECT_EQ(try_all_starts(stage.task(), stage.candidates), 4);
  EXPECT_EQ(stage.candidates.size(), 1U);
}

/// A line beside a wave of an effect; a diagnosis knows the size of the wave.
double line_and_wave(std::span<const double> p, double t) { return p[0] * t + p[1] * std::sin(2.0 * t); }
std::vector<FreeValue> known_wave(double size) {
  return {free_value("joint.hinge.damping", 0.0, -50.0, 50.0), free_value("effect.wave.size", size, -50.0, 50.0)};
}

TEST(TryKnownStarts, GoBackToAnEffectThatTheStagesHaveLost) {
  LastStage stage(line_and_wave, known_wave(2.0), {1.0, 2.0}, {1.5, 0.0});
  EXPECT_EQ(try_known_starts(stage.task(), stage.candidates), 1);
  ASSERT_EQ(stage.candidates.size(), 2U);
  EXPECT_NEAR(stage.best()[0], 1.0, 0.01);
  EXPECT_NEAR(stage.best()[1], 2.0, 0.01);
}

TEST(TryKnownStarts, TryNothingWhereTheValuesAreStillThere) {
  LastStage stage(line_and_wave, known_wave(2.0), {1.0, 2.0}, {1.5, 2.1});
  EXPECT_EQ(try_known_starts(stage.task(), stage.candidates), 0);
  EXPECT_EQ(stage.candidates.size(), 1U);
}

/// A start value of 0 is no knowledge, nor is one of the robot's own values.
TEST(TryKnownStarts, TryNothingWhereNothingIsKnown) {
  LastStage stage(line_and_wave, known_wave(0.0), {1.0, 2.0}, {1.5, 1.0});
  EXPECT_EQ(try_known_starts(stage.task(), stage.candidates), 0);
}

}  // namespace
}  // namespace lacuna::anew_test

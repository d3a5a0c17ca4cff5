#include "evaluation/scoring/model_scorer.h"

#include "plugins/built_catalog.h"
#include "support/robots.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr double kLagStep = 0.01;  // s
constexpr double kLongest = 0.2;   // s
constexpr double kTrueLag = 0.07;  // s

/// A body on a rail whose mass is known and whose sensor is late.
struct LateRig {
  explicit LateRig(DelayRounding rounding) {
    definition.structure.robot = one_joint(JointKind::slider, 1.0);
    const std::string delay = "sensor." + definition.structure.robot.sensors.front().name + ".delay";
    definition.free = {{{"body.body.mass", "kg", 0.5, 8.0, 1.0, Scale::linear}, ""},
                       {{delay, "s", 0.0, kLongest, 0.0, Scale::linear}, ""}};
    definition.structure.parameters = {{"body.body.mass", 0.5, 8.0}, {delay, 0.0, kLongest}};
    definition.engine.step = kLagStep;
    definition.engine.delay_rounding = rounding;
    model = compile(definition.structure, definition.engine);
  }

  /// Pushed to and fro, seconds of a trial.
  ScoredTrial trial(double mass, double lag, double frequency) const {
    ScoredTrial scored;
    CommandSeries commands;
    commands.series.channels = {{"motor", "N"}};
    commands.series.times = Eigen::VectorXd::LinSpaced(101, 0.0, 1.0);
    commands.series.samples = (commands.series.times * frequency * 6.0).array().cos().matrix();
    scored.test = {commands, 1.0, {}};
    SimulationOptions options;
    const std::vector<double> times(commands.series.times.begin(), commands.series.times.end());
    options.end_time = 1.0;
    options.output_times = times;
    SimulationResult result;
    model->simulate(std::vector<double>{mass, lag}, scored.test, options, *model->make_workspace(), result);
    scored.trial.name = "shaken";
    scored.trial.measured = result.readings;
    return scored;
  }

  std::vector<ScoredTrial> trials() const { return {trial(2.0, kTrueLag, 1.0), trial(2.0, kTrueLag, 2.3)}; }

  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
};

Chosen<FitnessMetric> mean_metric() {
  return {&built_catalog().get<FitnessMetric>("mean_absolute_difference"), {}, {"metric", "mean", "mean.so"}};
}

ModelScore profiled_score(const LateRig& rig, double mass, double lag_of_candidate) {
  const ModelScorer scorer(*rig.model, rig.trials(), mean_metric(), {1}, &rig.definition, {1});
  ModelScore score;
  scorer.score({{mass, lag_of_candidate}}, std::nullopt, 0, score);
  return score;
}

double simulated_score(const LateRig& rig, double mass, double lag) {
  const ModelScorer scorer(*rig.model, rig.trials(), mean_metric(), {1});
  ModelScore score;
  scorer.score({{mass, lag}}, std::nullopt, 0, score);
  return score.total;
}

TEST(LagProfile, FindsTheLagOfTheRightModelExactly) {
  const LateRig rig(DelayRounding::step);
  const ModelScore score = profiled_score(rig, 2.0, 0.0);
  EXPECT_NEAR(score.values.at(1), kTrueLag, 1e-12);
  EXPECT_NEAR(score.total, 0.0, 1e-12);
  EXPECT_EQ(score.values.at(0), 2.0);
}

TEST(LagProfile, ScoresAsASimulationWithThatLagDoesAndNoOtherLagIsBetter) {
  const LateRig rig(DelayRounding::step);
  const ModelScore score = profiled_score(rig, 3.0, 0.0);
  EXPECT_NEAR(score.total, simulated_score(rig, 3.0, score.values[1]), 1e-12);
  for (int k = 0; k <= 20; ++k) EXPECT_GE(simulated_score(rig, 3.0, k * kLagStep), score.total - 1e-12) << k;
}

TEST(LagProfile, BetweenWholeStepsWhereTheyMeanSomething) {
  const LateRig rig(DelayRounding::none);
  ModelScore score;
  const ModelScorer scorer(*rig.model, {rig.trial(2.0, 0.0637, 1.0)}, mean_metric(), {1}, &rig.definition, {1});
  scorer.score({{2.0, 0.0}}, std::nullopt, 0, score);
  EXPECT_NEAR(score.values.at(1), 0.0637, 1e-6);
}

TEST(LagProfile, WhatLagACandidateHasDoesNotMatter) {
  const LateRig rig(DelayRounding::step);
  EXPECT_EQ(profiled_score(rig, 3.0, 0.15).total, profiled_score(rig, 3.0, 0.0).total);
}

TEST(LagProfile, WhatWasNotMeasuredCountsForNothing) {
  const LateRig rig(DelayRounding::step);
  std::vector<ScoredTrial> trials = rig.trials();
  trials[0].trial.measured.samples.topRows(20).setConstant(std::nan(""));
  const ModelScorer scorer(*rig.model, trials, mean_metric(), {1}, &rig.definition, {1});
  ModelScore score;
  scorer.score({{2.0, 0.0}}, std::nullopt, 0, score);
  EXPECT_NEAR(score.values.at(1), kTrueLag, 1e-12);
}

}  // namespace
}  // namespace lacuna

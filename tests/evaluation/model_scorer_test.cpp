#include "evaluation/scoring/model_scorer.h"

#include "evaluation/scoring/model_evaluator.h"
#include "plugins/built_catalog.h"
#include "support/robots.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr double kStep = 0.01;     // s
constexpr double kDuration = 0.5;  // s
constexpr double kTrueMass = 2.0;  // kg

/// A body on a rail whose mass is free, pushed by a constant force of 1 N.
struct Rig {
  Rig() {
    definition.structure.robot = one_joint(JointKind::slider, 1.0);
    definition.free = {{{"body.body.mass", "kg", 0.5, 8.0, 1.0, Scale::linear}, ""}};
    definition.structure.parameters = {{"body.body.mass", 0.5, 8.0}};
    definition.engine.step = kStep;
    model = compile(definition.structure, definition.engine);
  }

  ScoredTrial trial(double mass) const {
    ScoredTrial scored;
    CommandSeries commands;
    commands.series.channels = {{"motor", "N"}};
    commands.series.times = Eigen::VectorXd::Zero(1);
    commands.series.samples = TimeSeries::Samples::Ones(1, 1);
    scored.test = {commands, kDuration, {}};
    std::vector<double> times;
    for (int i = 0; i * kStep <= kDuration + 1e-9; ++i) times.push_back(i * kStep);
    SimulationOptions options;
    options.end_time = times.back();
    options.output_times = times;
    SimulationResult result;
    model->simulate(std::vector<double>{mass}, scored.test, options, *model->make_workspace(), result);
    scored.trial.name = "pushed";
    scored.trial.measured = result.readings;
    return scored;
  }

  ModelDefinition definition;
  std::unique_ptr<CompiledModel> model;
};

Chosen<FitnessMetric> metric() {
  return {&built_catalog().get<FitnessMetric>("mean_absolute_difference"), {}, {"metric", "mean", "mean.so"}};
}

ModelScore score_of(const ModelScorer& scorer, double mass, std::optional<double> bar = {}) {
  ModelScore score;
  scorer.score({{mass}}, bar, 0, score);
  return score;
}

/// The mean over all samples and channels, computed apart from the scorer.
double mean_difference(const ScoredTrial& a, const ScoredTrial& b) {
  return (a.trial.measured.samples - b.trial.measured.samples).cwiseAbs().mean();
}

TEST(ModelScorer, ScoresEachTrialAndAllTogether) {
  const Rig rig;
  const ScoredTrial first = rig.trial(kTrueMass), second = rig.trial(3.0);
  const ModelScorer scorer(*rig.model, {first, second}, metric(), {1});
  const ModelScore score = score_of(scorer, kTrueMass);
  ASSERT_EQ(score.trials.size(), 2U);
  EXPECT_EQ(score.trials[0], 0.0);
  EXPECT_NEAR(score.trials[1], mean_difference(first, second), 1e-12);
  EXPECT_NEAR(score.total, 0.5 * score.trials[1], 1e-12);
  EXPECT_EQ(score.steps, 100U);
}

TEST(ModelScorer, SamplesBeforeTheFirstAreNotScored) {
  const Rig rig;
  ScoredTrial trial = rig.trial(kTrueMass);
  trial.trial.measured.samples.topRows(10).setConstant(1e6);
  trial.first_sample = 10;
  EXPECT_EQ(score_of(ModelScorer(*rig.model, {trial}, metric(), {1}), kTrueMass).total, 0.0);
}

TEST(ModelScorer, ABarEndsWhatCannotGetUnderIt) {
  const Rig rig;
  const ModelScorer scorer(*rig.model, {rig.trial(kTrueMass), rig.trial(kTrueMass)}, metric(), {1});
  const ModelScore whole = score_of(scorer, 4.0);
  const ModelScore cut = score_of(scorer, 4.0, 0.1 * whole.total);
  EXPECT_EQ(cut.kind, ScoreKind::abandoned);
  EXPECT_GT(cut.total, 0.1 * whole.total);
  EXPECT_LE(cut.total, whole.total);
  EXPECT_LT(cut.steps, whole.steps);
  EXPECT_EQ(score_of(scorer, 4.0, whole.total).kind, ScoreKind::full) << "a score that is just the bar counts";
}

/// Fails at a sample.
class Faulty : public FitnessMetric {
 public:
  std::string summary() const override { return ""; }
  std::unique_ptr<ScoreAccumulator> accumulator(const ComparisonShape&, std::span<const double>) const override {
    class Thrower : public ScoreAccumulator {
      void add(std::span<const double>, std::span<const double>) override { throw 7; }  // NOLINT: a careless plugin
      double bound() const override { return 0.0; }
      double score() const override { return 0.0; }
      void reset() override {}
    };
    return std::make_unique<Thrower>();
  }
};

TEST(ModelScorer, AMetricThatThrowsMakesTheEvaluationInvalidAndIsNamed) {
  const Rig rig;
  const Faulty faulty;
  const ModelScorer scorer(*rig.model, {rig.trial(kTrueMass)}, {&faulty, {}, {"metric", "faulty", "faulty.so"}}, {1});
  const ModelScore score = score_of(scorer, 1.0);
  EXPECT_EQ(score.kind, ScoreKind::invalid);
  EXPECT_EQ(score.total, kInfinity);
  EXPECT_THAT(score.reason, HasSubstr("faulty.so"));
}

/// Gives every candidate the same score.
class Constant : public FitnessMetric {
 public:
  explicit Constant(double score) : score_(score) {}
  std::string summary() const override { return ""; }
  std::unique_ptr<ScoreAccumulator> accumulator(const ComparisonShape&, std::span<const double>) const override {
    class Score : public ScoreAccumulator {
     public:
      explicit Score(double score) : score_(score) {}
      void add(std::span<const double>, std::span<const double>) override {}
      double bound() const override { return 0.0; }
      double score() const override { return score_; }
      void reset() override {}

     private:
      double score_;
    };
    return std::make_unique<Score>(score_);
  }

 private:
  double score_;
};

TEST(ModelScorer, AScoreOfFiniteReadingsThatIsNoNumberIsTheMetricsFaultNotTheModels) {
  const Rig rig;
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    const Constant constant(bad);
    const ModelScorer scorer(*rig.model, {rig.trial(kTrueMass)}, {&constant, {}, {"metric", "odd", "odd.so"}}, {1});
    const ModelScore score = score_of(scorer, 1.0);
    EXPECT_EQ(score.kind, ScoreKind::invalid);
    EXPECT_EQ(score.total, kInfinity) << "the worst, whatever the metric says";
    EXPECT_THAT(score.reason, testing::AllOf(HasSubstr("metric \"odd\" (odd.so): its score is "),
                                             testing::Not(HasSubstr("model predicts readings that are not"))));
  }
}

TEST(ModelScorer, WithoutAMeasuredValueBlamesNeitherMetricNorModel) {
  const Rig rig;
  ScoredTrial trial = rig.trial(kTrueMass);
  trial.trial.measured.samples.setConstant(std::nan(""));
  const ModelScore score = score_of(ModelScorer(*rig.model, {trial}, metric(), {1}), 1.0);
  EXPECT_EQ(score.kind, ScoreKind::invalid);
  EXPECT_THAT(score.reason, testing::StartsWith("no trial has a reading from which a score could be computed"));
}

TEST(ModelScorer, AValueOutOfBoundsIsInvalidWithItsReasonAndTheNextModelIsNot) {
  const Rig rig;
  const ModelScorer scorer(*rig.model, {rig.trial(kTrueMass)}, metric(), {1});
  const ModelScore bad = score_of(scorer, std::nan(""));
  EXPECT_EQ(bad.kind, ScoreKind::invalid);
  EXPECT_FALSE(bad.reason.empty());
  EXPECT_EQ(score_of(scorer, kTrueMass).total, 0.0);
}

/// Evaluates models of one value with a scorer.
std::vector<EvaluatedModel> evaluate(ModelEvaluator& evaluator, const ModelScorer& scorer,
                                     const std::vector<ModelProposal>& models, std::optional<double> bar) {
  return evaluator.evaluate(models, bar, [&](std::span<const std::size_t> fresh, std::optional<double> below) {
    std::vector<ModelScore> scores(fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i) scorer.score(models[fresh[i]], below, 0, scores[i]);
    return scores;
  });
}

TEST(ModelEvaluator, SimulatesIdenticalModelsOnce) {
  const Rig rig;
  const ModelScorer scorer(*rig.model, {rig.trial(kTrueMass)}, metric(), {2});
  ModelEvaluator evaluator(rig.definition, {});
  const auto first = evaluate(evaluator, scorer, {{{1.0}}, {{2.0}}, {{1.0}}}, std::nullopt);
  EXPECT_FALSE(first[0].reused);
  EXPECT_TRUE(first[2].reused);
  EXPECT_EQ(first[2].score.total, first[0].score.total);
  EXPECT_EQ(first[2].score.steps, 0U);
  EXPECT_TRUE(evaluate(evaluator, scorer, {{{2.0}}}, std::nullopt)[0].reused);
}

TEST(ModelEvaluator, WhatWasAbandonedIsSimulatedAgainWhereTheBarIsHigher) {
  const Rig rig;
  const ModelScorer scorer(*rig.model, {rig.trial(kTrueMass)}, metric(), {1});
  ModelEvaluator evaluator(rig.definition, {});
  const double whole = score_of(scorer, 6.0).total;
  EXPECT_EQ(evaluate(evaluator, scorer, {{{6.0}}}, 0.1 * whole)[0].score.kind, ScoreKind::abandoned);
  EXPECT_TRUE(evaluate(evaluator, scorer, {{{6.0}}}, 0.05 * whole)[0].reused) << "still above the bar";
  const EvaluatedModel again = evaluate(evaluator, scorer, {{{6.0}}}, std::nullopt)[0];
  EXPECT_FALSE(again.reused);
  EXPECT_EQ(again.score.total, whole);
}

}  // namespace
}  // namespace lacuna

#include "fitting/substeps.h"

#include "evaluation/prediction/trial_predictor.h"
#include "fitting/comparison.h"
#include "fitting/cross_check.h"
#include "fitting/fit.h"
#include "fitting/sprung_flywheel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace lacuna::substeps_test {
namespace {

using namespace lacuna::flywheel;

double change(const ModelDefinition& definition, const Trial& trial, int substeps) {
  const std::unique_ptr<CompiledModel> own = compiled(definition, substeps), fine = compiled(definition, 400);
  const TrialPredictor predictor(*own, {trial}, {1}), exact(*fine, {trial}, {1});
  Prediction a, b;
  predictor.predict(predictor.whole(0), {}, {{kStart}, {0.0}}, 0, a);
  exact.predict(exact.whole(0), {}, {{kStart}, {0.0}}, 0, b);
  return (a.samples - b.samples).norm() / std::sqrt(static_cast<double>(a.samples.rows()));
}

TEST(Substeps, AreAsFewAsKeepTheErrorSmallBesideTheNoise) {
  for (const double frequency : {2.0, 12.0, 40.0}) {
    const ModelDefinition definition = sprung(frequency);
    const Trial trial = recorded(definition);
    const Substeps found = sufficient_substeps(definition, {trial}, {}, {1});
    EXPECT_TRUE(found.enough) << frequency;
    EXPECT_NEAR(change(definition, trial, found.count), found.share * kDeviation, 0.2 * found.share * kDeviation)
        << frequency;
    EXPECT_LE(found.share, 0.05) << frequency;
    if (found.count > 2) {
      EXPECT_GT(change(definition, trial, found.count / 2), 0.05 * kDeviation) << frequency;
    }
  }
}

TEST(Substeps, AreMoreForAStifferSpring) {
  const auto count = [](double frequency) {
    const ModelDefinition definition = sprung(frequency);
    return sufficient_substeps(definition, {recorded(definition)}, {}, {2}).count;
  };
  EXPECT_EQ(count(1.0), 1);
  EXPECT_GT(count(40.0), count(12.0));
}

TEST(Substeps, KeepTheBiasOfAFittedValueSmallBesideItsInterval) {
  const ModelDefinition definition = with_free_spring(6.0);
  const std::vector<Trial> trials = {recorded(sprung(6.0))};
  const std::vector<double> start = {definition.free[0].start};
  const Substeps found = sufficient_substeps(definition, trials, start, {1});
  EXPECT_TRUE(found.enough);
  EXPECT_EQ(found.shift.address, "joint.joint.stiffness");
  EXPECT_LE(found.shift.share, 0.1);
  const FittedValue coarse = fitted_spring(definition, trials, 1), own = fitted_spring(definition, trials, found.count),
                    exact = fitted_spring(definition, trials, 64);
  const double half = 0.5 * (exact.upper_95 - exact.lower_95);
  EXPECT_GT(std::abs(coarse.value - exact.value), 0.3 * half);
  EXPECT_LT(std::abs(own.value - exact.value), 0.15 * half);
}

TEST(Substeps, AreTheSameForAnyNumberOfThreads) {
  const ModelDefinition definition = sprung(25.0);
  const std::vector<Trial> trials = {recorded(definition), recorded(definition), recorded(definition)};
  const Substeps one = sufficient_substeps(definition, trials, {}, {1}),
                 many = sufficient_substeps(definition, trials, {}, {3});
  EXPECT_EQ(one.count, many.count);
  EXPECT_EQ(one.share, many.share);
}

TEST(Substeps, AreOneOfAnEngineWhoseContactsDependOnThem) {
  const ModelDefinition definition = sprung(40.0, "ode");
  EXPECT_EQ(sufficient_substeps(definition, {recorded(definition)}, {}, {1}).count, 1);
}

TEST(Substeps, AreOneOfAModelThatCannotBeSimulated) {
  ModelDefinition definition = sprung(2.0);
  Trial trial = recorded(definition);
  definition.structure.robot.joints[0].force = 1e12;
  const Substeps found = sufficient_substeps(definition, {trial}, {}, {1});
  EXPECT_EQ(found.count, 1);
  EXPECT_FALSE(found.enough);
  EXPECT_TRUE(std::isinf(found.share));
}

TEST(CrossCheck, FindsTheEnginesOfOneMotionTogether) {
  ModelDefinition definition = sprung(12.0);
  definition.engine.substeps = 16;
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const std::vector<Trial> trials = {recorded(definition)};
  const NoiseSection noise;
  ComparisonTask task{.definition = definition, .model = *model, .trials = trials, .noise = noise, .values = {}};
  task.cross_check = true;
  const Comparison comparison = compare(task);
  ASSERT_TRUE(comparison.cross_check);
  EXPECT_EQ(comparison.cross_check->engine, "ode");
  ASSERT_EQ(comparison.cross_check->channels.size(), 1u);
  const EngineDistance& position = comparison.cross_check->channels[0];
  EXPECT_LT(position.apart, 0.05 * kDeviation);
  EXPECT_GT(position.apart, 0.0);
  EXPECT_NEAR(position.error, kDeviation, 0.2 * kDeviation);
}

TEST(CrossCheck, NeedsASecondEngine) {
  ModelDefinition definition = sprung(2.0, "ode");
  RobotSpec& robot = definition.structure.robot;
  robot.contact.ground = true;
  robot.bodies[0].shapes.push_back({.kind = ShapeKind::sphere, .size = {0.1, 0.0, 0.0}});
  robot.bodies[0].position.z() = 5.0;
  robot.joints[0].anchor.z() = 5.0;
  const std::unique_ptr<CompiledModel> model = compile(definition.structure, definition.engine);
  const std::vector<Trial> trials = {recorded(definition)};
  const NoiseSection noise;
  const ComparisonTask task{.definition = definition, .model = *model, .trials = trials, .noise = noise, .values = {}};
  EXPECT_THROW(cross_check(task, {}), Error);
}

}  // namespace
}  // namespace lacuna::substeps_test

#include "conformance/every_plugin.h"
#include "plugin_checks/metric_inputs.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

/// What holds for every metric, and for its accumulators.
namespace lacuna {
namespace {

std::unique_ptr<ScoreAccumulator> accumulator(const FitnessMetric& metric, const std::vector<double>& parameters) {
  return metric.accumulator({2, kComparedSamples, kComparedChannels}, parameters);
}

double score(ScoreAccumulator& accumulator, const std::vector<ComparedSample>& all) {
  for (const ComparedSample& sample : all) accumulator.add(sample.predicted, sample.measured);
  return accumulator.score();
}

TEST(MetricConformance, BoundsNeverFallAndNeverExceedTheScore) {
  on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
    const auto sums = accumulator(metric, parameters);
    double last = sums->bound();
    for (const ComparedSample& sample : compared_sines()) {
      sums->add(sample.predicted, sample.measured);
      EXPECT_GE(sums->bound(), last);
      last = sums->bound();
    }
    EXPECT_LE(last, sums->score() * (1.0 + kScoreRounding));
    EXPECT_TRUE(std::isfinite(sums->score()));
  });
}

/// Bounds after each sample, and the score.
std::vector<double> course(ScoreAccumulator& accumulator) {
  std::vector<double> values{accumulator.bound()};
  for (const ComparedSample& sample : compared_sines()) {
    accumulator.add(sample.predicted, sample.measured);
    values.push_back(accumulator.bound());
  }
  values.push_back(accumulator.score());
  return values;
}

TEST(MetricConformance, ResetBeginsAnew) {
  on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
    const auto sums = accumulator(metric, parameters);
    const std::vector<double> first = course(*sums);
    sums->reset();
    EXPECT_EQ(course(*sums), first);
  });
}

TEST(MetricConformance, WhatWasNotMeasuredCountsForNothing) {
  const std::vector<ComparedSample> other = sines_off_where_not_measured();
  on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
    EXPECT_EQ(score(*accumulator(metric, parameters), other),
              score(*accumulator(metric, parameters), compared_sines()));
  });
}

TEST(MetricConformance, AWorsePredictionScoresWorse) {
  const std::vector<ComparedSample> worse = worse_sines();
  std::vector<ComparedSample> exact = compared_sines();
  for (ComparedSample& sample : exact) sample.predicted = sample.measured;
  on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
    const double normal = score(*accumulator(metric, parameters), compared_sines());
    EXPECT_GT(score(*accumulator(metric, parameters), worse), normal);
    EXPECT_LT(score(*accumulator(metric, parameters), exact), normal);
  });
}

TEST(MetricConformance, PredictionsThatAreNoNumberAreInfinitelyBad) {
  for (const double bad : {kNotMeasured, std::numeric_limits<double>::infinity()}) {
    const std::vector<ComparedSample> broken = broken_sines(bad);
    on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
      EXPECT_EQ(score(*accumulator(metric, parameters), broken), std::numeric_limits<double>::infinity());
    });
  }
}

}  // namespace
}  // namespace lacuna

#include "conformance/every_plugin.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

/// What holds for every metric, and for its accumulators.
namespace lacuna {
namespace {

constexpr double kNanOfMetric = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSamples = 300, kChannels = 3;
constexpr double kRounding = 1e-12;  // share of a score

struct Samples {
  std::vector<double> predicted, measured;
};

/// Sine waves that agree better and better, with gaps in what is measured.
std::vector<Samples> comparison() {
  std::vector<Samples> all;
  for (std::size_t i = 0; i < kSamples; ++i) {
    Samples samples;
    for (std::size_t c = 0; c < kChannels; ++c) {
      const double t = 0.05 * static_cast<double>(i) + static_cast<double>(c);
      samples.predicted.push_back(std::sin(t));
      samples.measured.push_back((i + c) % 7 == 0 ? kNanOfMetric : std::sin(1.02 * t) + 0.3 / (1.0 + t));
    }
    all.push_back(samples);
  }
  return all;
}

std::unique_ptr<ScoreAccumulator> accumulator(const FitnessMetric& metric, const std::vector<double>& parameters) {
  return metric.accumulator({2, kSamples, kChannels}, parameters);
}

double score(ScoreAccumulator& accumulator, const std::vector<Samples>& all) {
  for (const Samples& samples : all) accumulator.add(samples.predicted, samples.measured);
  return accumulator.score();
}

TEST(MetricConformance, BoundsNeverFallAndNeverExceedTheScore) {
  on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
    const auto sums = accumulator(metric, parameters);
    double last = sums->bound();
    for (const Samples& samples : comparison()) {
      sums->add(samples.predicted, samples.measured);
      EXPECT_GE(sums->bound(), last);
      last = sums->bound();
    }
    EXPECT_LE(last, sums->score() * (1.0 + kRounding));
    EXPECT_TRUE(std::isfinite(sums->score()));
  });
}

/// Bounds after each sample, and the score.
std::vector<double> course(ScoreAccumulator& accumulator) {
  std::vector<double> values{accumulator.bound()};
  for (const Samples& samples : comparison()) {
    accumulator.add(samples.predicted, samples.measured);
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
  std::vector<Samples> other = comparison();
  for (Samples& samples : other)
    for (std::size_t c = 0; c < kChannels; ++c)
      if (std::isnan(samples.measured[c])) samples.predicted[c] = 1e6;
  on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
    EXPECT_EQ(score(*accumulator(metric, parameters), other), score(*accumulator(metric, parameters), comparison()));
  });
}

TEST(MetricConformance, AWorsePredictionScoresWorse) {
  std::vector<Samples> worse = comparison(), exact = comparison();
  for (Samples& samples : worse)
    for (double& value : samples.predicted) value += 5.0;
  for (Samples& samples : exact) samples.predicted = samples.measured;
  on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
    const double normal = score(*accumulator(metric, parameters), comparison());
    EXPECT_GT(score(*accumulator(metric, parameters), worse), normal);
    EXPECT_LT(score(*accumulator(metric, parameters), exact), normal);
  });
}

TEST(MetricConformance, PredictionsThatAreNoNumberAreInfinitelyBad) {
  for (const double bad : {kNanOfMetric, std::numeric_limits<double>::infinity()}) {
    std::vector<Samples> broken = comparison();
    broken[kSamples / 2].predicted.assign(kChannels, bad);
    on_every<FitnessMetric>([&](const FitnessMetric& metric, const std::vector<double>& parameters) {
      EXPECT_EQ(score(*accumulator(metric, parameters), broken), std::numeric_limits<double>::infinity());
    });
  }
}

}  // namespace
}  // namespace lacuna

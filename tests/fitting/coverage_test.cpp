#include "fitting/fit.h"

#include "fitting/analytic_models.h"
#include "fitting/numerics/correlation_time.h"
#include "fitting/numerics/seeded_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

using namespace lacuna::analytic;

constexpr int kRepeats = 200;
const std::vector<double> kLineTruth = {1.5, -0.7};

double line(std::span<const double> values, double t) {
  return values[0] * std::sin(2.0 * t) + values[1] * std::cos(0.9 * t);
}

/// The linear model in noise of first order: each sample remembers `memory` of the one before.
Trial noisy_line(double memory, std::uint64_t seed) {
  const FormulaModel model(line);
  Trial trial = record(model, kLineTruth, regular_times(600, 20.0), {}, {}, 0.0, seed);
  SeededNoise random(seed, 99);
  double noise = random.normal();
  for (Eigen::Index row = 0; row < trial.measured.samples.rows(); ++row) {
    trial.measured.samples(row, 0) += 0.3 * noise;
    noise = memory * noise + std::sqrt(1.0 - memory * memory) * random.normal();
  }
  trial.sensor_noise = {0.3};
  return trial;
}

struct Coverage {
  double share = 0.0;             ///< of intervals that hold the truth
  double mean_error_ratio = 0.0;  ///< stated standard error over the spread of the estimates, first value
};

Coverage coverage(double memory) {
  const FormulaModel model(line);
  const ModelDefinition definition = define({free_value("a", 1.0, -10.0, 10.0), free_value("b", 0.1, -10.0, 10.0)});
  FitSection options;
  options.starts = 1;
  int hits = 0;
  double squares = 0.0, stated = 0.0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const std::vector<Trial> trials = {noisy_line(memory, 1000 + static_cast<std::uint64_t>(repeat))};
    const FitResult result = fit({definition, model, trials, options});
    for (std::size_t i = 0; i < 2; ++i)
      if (result.values[i].lower_95 <= kLineTruth[i] && kLineTruth[i] <= result.values[i].upper_95) ++hits;
    squares += std::pow(result.values[0].value - kLineTruth[0], 2) / kRepeats;
    stated += result.values[0].standard_error / kRepeats;
  }
  return {hits / (2.0 * kRepeats), stated / std::sqrt(squares)};
}

// 400 intervals: the share of a true 95 % lies within ±2.2 % (two standard errors); blocks are few, so a
// little more is allowed below.
constexpr double kLeast = 0.91;
constexpr double kMost = 0.98;

TEST(Coverage, OfIntervalsInWhiteNoise) {
  const Coverage found = coverage(0.0);
  EXPECT_GE(found.share, kLeast);
  EXPECT_LE(found.share, kMost);
  EXPECT_NEAR(found.mean_error_ratio, 1.0, 0.15);
}

TEST(Coverage, OfIntervalsInCorrelatedNoise) {
  // Memory 0.8 triples the variance of slow averages: intervals that ignore it cover about two thirds.
  const Coverage found = coverage(0.8);
  EXPECT_GE(found.share, kLeast);
  EXPECT_LE(found.share, kMost);
}

TEST(CorrelationSamples, OfNoiseOfFirstOrder) {
  SeededNoise random(5, 5);
  std::vector<double> noise(20000);
  for (std::size_t i = 1; i < noise.size(); ++i) noise[i] = 0.8 * noise[i - 1] + random.normal();
  EXPECT_NEAR(correlation_samples(noise), 1.8 / 0.2, 1.5);  // (1 + a)/(1 − a), cut off below 0.1
  std::vector<double> white(20000);
  for (double& value : white) value = random.normal();
  EXPECT_EQ(correlation_samples(white), 1.0);
}

}  // namespace
}  // namespace lacuna

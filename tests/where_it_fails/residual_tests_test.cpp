#include "where_it_fails/residual_tests.h"

#include "fitting/numerics/seeded_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace lacuna {
namespace {

constexpr Eigen::Index kSamples = 1000;
constexpr int kRepeats = 400;
// 1 % of 400 are 4; of a binomial 12 and more come up once in a thousand. Slow features against a slow residual are
// allowed a little more than the nominal rate.
constexpr int kMostFalseAlarms = 12;

/// First-order noise that forgets over `memory` samples.
Eigen::VectorXd coloured(double memory, std::uint64_t seed, std::uint64_t stream) {
  SeededNoise random(seed, stream);
  const double kept = std::exp(-1.0 / memory);
  Eigen::VectorXd values(kSamples);
  double value = random.normal() / std::sqrt(1.0 - kept * kept);
  for (double& one : values) one = value = kept * value + random.normal();
  return values;
}

Eigen::VectorXd sine_of_period(double period) {
  return Eigen::VectorXd::NullaryExpr(kSamples, [period](Eigen::Index i) {
    return std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / period);
  });
}

int false_alarms(double memory, const std::function<IndependenceTest(const ResidualTester&, std::uint64_t)>& test) {
  int alarms = 0;
  for (std::uint64_t i = 0; i < kRepeats; ++i) {
    const IndependenceTest result = test(ResidualTester(coloured(memory, 1, i), {}, 1), i);
    EXPECT_TRUE(result.testable);
    EXPECT_EQ(result.p<0.01, result.statistic> result.critical);
    alarms += result.p < 0.01 ? 1 : 0;
  }
  return alarms;
}

TEST(ResidualTester, ColouredNoiseThatDependsOnNothingRaisesAsFewAlarmsAsPromised) {
  const Eigen::VectorXd position = sine_of_period(170.0);
  const Eigen::VectorXd direction = position.array().sign();
  for (const double memory : {0.1, 30.0}) {
    SCOPED_TRACE(memory);
    EXPECT_LE(false_alarms(memory, [&](const auto& tester, auto) { return tester.of(position); }), kMostFalseAlarms);
    EXPECT_LE(false_alarms(memory, [&](const auto& tester, auto) { return tester.of_classes(direction); }),
              kMostFalseAlarms);
    EXPECT_LE(false_alarms(memory, [](const auto& tester, auto) { return tester.of_mean(); }), kMostFalseAlarms);
  }
  const auto unrelated = [](const ResidualTester& tester, std::uint64_t i) { return tester.of(coloured(15.0, 2, i)); };
  EXPECT_LE(false_alarms(15.0, unrelated), 2 * kMostFalseAlarms);
}

/// Of a feature that is hardly more than a covariate, the slope beside it is large and uncertain.
TEST(ResidualTester, BandsHoldAnUncertainSlope) {
  int outside = 0, bins = 0;
  for (std::uint64_t i = 0; i < 50; ++i) {
    const Eigen::VectorXd covariate = sine_of_period(170.0);
    const Eigen::VectorXd feature =
        covariate + 0.15 * coloured(15.0, 2, i) / coloured(15.0, 2, i).norm() * covariate.norm();
    const IndependenceTest test = ResidualTester(coloured(15.0, 1, i), covariate, 1).of(feature);
    for (const ResidualBin& bin : test.bins) outside += std::abs(bin.mean) > bin.band, ++bins;
  }
  ASSERT_GT(bins, 400);
  EXPECT_LE(outside, bins / 20);
}

TEST(ResidualTester, SeesADependenceUnderColouredNoiseAndItsShare) {
  const Eigen::VectorXd velocity = sine_of_period(170.0);
  const Eigen::VectorXd direction = velocity.array().sign();
  constexpr double kSize = 12.0;
  const Eigen::VectorXd noise = coloured(10.0, 1, 7);
  const Eigen::VectorXd residual = noise + kSize * direction;
  const IndependenceTest test = ResidualTester(residual, {}, 20).of_classes(direction);
  EXPECT_GT(test.statistic, test.critical);
  const double share = kSize * kSize * static_cast<double>(kSamples) / residual.squaredNorm();
  EXPECT_NEAR(test.share, share, 0.05);
  ASSERT_EQ(test.bins.size(), 3u);  // sin 0 = 0 exactly once, at the first sample
  EXPECT_NEAR(test.bins.front().mean, -kSize, test.bins.front().band);
  EXPECT_NEAR(test.bins.back().mean, kSize, test.bins.back().band);
}

TEST(ResidualTester, WhatCovariatesExplainIsNoDependence) {
  const Eigen::VectorXd command = sine_of_period(170.0);
  const Eigen::VectorXd residual = 4.0 * command + coloured(5.0, 1, 3);
  EXPECT_LT(ResidualTester(residual, {}, 1).of(command).p, 1e-6);
  const ResidualTester beside(residual, command, 1);
  EXPECT_FALSE(beside.of_classes(command).testable);  // it adds nothing
  EXPECT_GT(beside.of(command.cwiseAbs()).p, 0.01);
}

TEST(ResidualTester, GapsAndConstantFeaturesAreNoEvidence) {
  Eigen::VectorXd residual = coloured(5.0, 1, 4);
  residual.segment(100, 200).setConstant(std::nan(""));
  const ResidualTester tester(residual, {}, 1);
  EXPECT_TRUE(std::isfinite(tester.of(sine_of_period(90.0)).statistic));
  EXPECT_FALSE(tester.of(Eigen::VectorXd::Constant(kSamples, 3.0)).testable);
}

TEST(Autocorrelation, OfFirstOrderNoiseFallsAsItShould) {
  constexpr double kMemory = 20.0, kInterval = 0.01;
  const Autocorrelation result = autocorrelation({coloured(kMemory, 1, 1), coloured(kMemory, 1, 2)}, kInterval);
  EXPECT_LT(result.p, 1e-6);
  EXPECT_NEAR(result.band, 2.576 / std::sqrt(2.0 * kSamples), 1e-4);
  ASSERT_GE(result.lags.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(result.values[i], std::exp(-result.lags[i] / (kMemory * kInterval)), 0.12) << result.lags[i];
}

TEST(Autocorrelation, OfWhiteNoiseStaysInItsBand) {
  int rejected = 0;
  double outside = 0.0;
  constexpr int kTrials = 100;
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    SeededNoise random(5, i);
    const Eigen::VectorXd white = Eigen::VectorXd::NullaryExpr(kSamples, [&] { return random.normal(); });
    const Autocorrelation result = autocorrelation({white}, 1.0);
    rejected += result.p < 0.01 ? 1 : 0;
    outside += result.share_outside / kTrials;
  }
  EXPECT_LE(rejected, 5);
  EXPECT_NEAR(outside, 0.01, 0.005);
}

TEST(Autocorrelation, OfNothingIsNothing) {
  EXPECT_TRUE(autocorrelation({Eigen::VectorXd::Zero(100)}, 1.0).lags.empty());
  EXPECT_TRUE(autocorrelation({}, 1.0).lags.empty());
}

}  // namespace
}  // namespace lacuna

#include "measurement/rest_noise.h"

#include "measurement/series/quantisation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRate = 1000.0;  // Hz

/// Standard normal numbers, the same on every machine (splitmix64, Box–Muller).
class Gauss {
 public:
  double operator()() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * kPi * uniform()); }

 private:
  double uniform() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (static_cast<double>((z ^ (z >> 31)) >> 11) + 0.5) * 0x1.0p-53;
  }
  std::uint64_t state_ = 7;
};

Trial trial_of(int samples, const std::function<double(double)>& value) {
  Trial trial;
  trial.measured.channels = {{"angle", "rad"}};
  trial.measured.times.resize(samples);
  trial.measured.samples.resize(samples, 1);
  for (int i = 0; i < samples; ++i) {
    trial.measured.times[i] = i / kRate;
    trial.measured.samples(i, 0) = value(i / kRate);
  }
  return trial;
}

double quantised(double value, double step) { return step * std::round(value / step); }

/// Still for a second, a swing of two seconds, still for a second.
double swing(double t) { return t < 1.0 ? 0.4 : t < 3.0 ? 0.4 + 0.5 * (1.0 - std::cos(kPi * (t - 1.0))) : 0.4; }

std::vector<double> values_of(const Trial& trial) {
  return {trial.measured.samples.data(), trial.measured.samples.data() + trial.measured.samples.size()};
}

TEST(QuantisationStep, IsFoundInAnEncoder) {
  const double step = 2.0 * kPi / 4096.0;
  const Trial trial = trial_of(4000, [&](double t) { return quantised(swing(t), step); });
  EXPECT_NEAR(quantisation_step(values_of(trial)), step, 1e-9 * step);
}

TEST(QuantisationStep, IsFoundThroughPrintedDigits) {
  const double step = 2.0 * kPi / 4096.0;
  const Trial trial = trial_of(4000, [&](double t) { return quantised(quantised(swing(t), step), 1e-5); });
  EXPECT_NEAR(quantisation_step(values_of(trial)), step, 1e-3 * step);
}

TEST(QuantisationStep, IsFoundInASparseGrid) {
  const std::vector<double> values = {0.0, 0.2, 0.5, 0.9, 1.1, 1.4, 2.0, 2.3, 2.7, 3.0, 3.4};
  EXPECT_NEAR(quantisation_step(values), 0.1, 1e-12);
}

TEST(QuantisationStep, IsZeroWithoutAGrid) {
  Gauss gauss;
  EXPECT_EQ(quantisation_step(values_of(trial_of(2000, [&](double) { return gauss(); }))), 0.0);
  EXPECT_EQ(quantisation_step(values_of(trial_of(2000, swing))), 0.0);
  EXPECT_EQ(quantisation_step(std::vector<double>{}), 0.0);
  EXPECT_EQ(quantisation_step(std::vector<double>(50, 3.0)), 0.0);
  EXPECT_EQ(quantisation_step(std::vector<double>{-1.0, 1.0, -1.0, 1.0, 0.0}), 0.0) << "a command of three levels";
}

TEST(FindRest, SeesTheStillPartsOfASwing) {
  Gauss gauss;
  const Trial trial = trial_of(4000, [&](double t) { return swing(t) + 1e-3 * gauss(); });
  const std::vector<RestStretch> rest = find_rest(trial.measured.times, values_of(trial), 0.0);
  Eigen::Index still = 0;
  for (const RestStretch& stretch : rest) {
    still += stretch.count;
    // After 0.1 s the swing has gone 24 mrad, 24 times the noise.
    EXPECT_TRUE(stretch.first + stretch.count <= 1100 || stretch.first >= 2900)
        << stretch.first << " " << stretch.count;
  }
  EXPECT_GT(still, 1600);
}

TEST(FindRest, SeesNoneInMotion) {
  Gauss gauss;
  const auto rest_of = [](const Trial& trial) { return find_rest(trial.measured.times, values_of(trial), 0.0).size(); };
  EXPECT_EQ(rest_of(trial_of(4000, [](double t) { return std::sin(2.0 * kPi * t); })), 0u) << "a smooth swing";
  EXPECT_EQ(rest_of(trial_of(4000, [](double t) { return std::sin(2.0 * kPi * 40.0 * t); })), 0u) << "a vibration";
  EXPECT_EQ(rest_of(trial_of(4000, [&](double t) { return 0.2 * t + 1e-3 * gauss(); })), 0u) << "a slow drift";
}

TEST(SensorNoise, IsTheScatterAtRest) {
  Gauss gauss;
  const double sigma = 2e-3;
  const Trial trial = trial_of(4000, [&](double t) { return swing(t) + sigma * gauss(); });
  const SensorNoise noise = estimate_sensor_noise({trial}, "angle");
  // About 2000 readings: the estimate itself scatters by sigma/√4000.
  EXPECT_NEAR(noise.standard_deviation, sigma, 4.0 * sigma / std::sqrt(4000.0));
  EXPECT_EQ(noise.quantum, 0.0);
  EXPECT_NEAR(noise.correlation, 0.0, 4.0 / std::sqrt(2000.0));
  EXPECT_NEAR(noise.rest_duration, 2.0, 0.3);
  EXPECT_THAT(noise.origin("rad"), testing::StartsWith("rest 2."));
}

TEST(SensorNoise, OfAQuietEncoderIsItsStepOverRootTwelve) {
  const double step = 1e-2;
  const Trial trial = trial_of(4000, [&](double t) { return quantised(swing(t), step); });
  const SensorNoise noise = estimate_sensor_noise({trial}, "angle");
  EXPECT_NEAR(noise.standard_deviation, step / std::sqrt(12.0), 1e-9);
  EXPECT_LT(noise.at_rest, 1e-12);
  EXPECT_EQ(noise.origin("rad"), "step 10.0 mrad/\u221a12; rest agrees");
}

TEST(SensorNoise, AddsToQuantisation) {
  Gauss gauss;
  const double step = 2e-3, sigma = 3e-3;
  const Trial trial = trial_of(20000, [&](double) { return quantised(0.1 + sigma * gauss(), step); });
  const SensorNoise noise = estimate_sensor_noise({trial}, "angle");
  EXPECT_NEAR(noise.standard_deviation, std::sqrt(sigma * sigma + step * step / 12.0), 0.03 * sigma);
  EXPECT_NEAR(noise.quantum, step, 1e-9);
}

TEST(SensorNoise, TellsTheCorrelationOfFilteredNoise) {
  Gauss gauss;
  double state = 0.0;
  const Trial trial = trial_of(20000, [&](double) { return state = 0.8 * state + 0.6e-3 * gauss(); });
  const SensorNoise noise = estimate_sensor_noise({trial}, "angle");
  EXPECT_NEAR(noise.correlation, 0.8, 0.05);
  EXPECT_NEAR(noise.standard_deviation, 1e-3, 1e-4);
}

TEST(SensorNoise, IsUnknownWhereNothingRestsAndNothingIsQuantised) {
  const Trial trial = trial_of(4000, [](double t) { return std::sin(2.0 * kPi * t); });
  const SensorNoise noise = estimate_sensor_noise({trial}, "angle");
  EXPECT_TRUE(std::isnan(noise.standard_deviation));
  EXPECT_THAT(noise.origin("rad"), testing::StartsWith("unknown"));
  EXPECT_TRUE(std::isnan(estimate_sensor_noise({trial}, "other").standard_deviation));
}

}  // namespace
}  // namespace lacuna

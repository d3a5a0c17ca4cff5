#include "oracle/kalman_whitener.h"

#include "hand_made_case.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hidden_effects {
namespace {

constexpr std::size_t kSamples = 400;
constexpr int kRepeats = 60;

/// What is left by the truth itself, whitened, of many noisy repeats of a case: moments over all numbers.
struct Moments {
  double mean_square = 0.0, correlation = 0.0, late_mean_square = 0.0;  ///< the last: of each trial's second half
  double error = 0.0;                                                   ///< standard error of the first
};

Whiten whitener_of(const MadeCase& made, const CaseNoise& noise) {
  std::vector<TrueTrial> trials;
  for (const MadeTrial& trial : made.trials)
    trials.push_back({trial.noise_free().excitation, {Coordinates::Zero(1), Coordinates::Zero(1)}});
  return kalman_whitener(made.truth, made.truth_values, trials, noise, 1e-3);
}

Eigen::MatrixXd left(const MadeCase& made, const MadeTrial& trial) {
  const FittedTrial fitted = trial.fitted();
  const Readings predicted =
      predict(made.truth, made.truth_values, fitted.excitation, {Coordinates::Zero(1), Coordinates::Zero(1)});
  Eigen::MatrixXd table(static_cast<Eigen::Index>(kSamples), 1);
  for (std::size_t k = 0; k < kSamples; ++k)
    table(static_cast<Eigen::Index>(k), 0) = fitted.readings[0][k] - predicted[0][k];
  return table;
}

Moments moments(MadeCase& made, const Whiten& whiten) {
  Moments of;
  double count = 0.0;
  for (int r = 0; r < kRepeats; ++r) {
    make_noisy(made, 1000 + static_cast<std::uint64_t>(r));
    for (std::size_t t = 0; t < made.trials.size(); ++t) {
      const Eigen::VectorXd white = whiten(t, left(made, made.trials[t]));
      of.mean_square += white.squaredNorm();
      of.late_mean_square += 2.0 * white.tail(kSamples / 2).squaredNorm();
      of.correlation += white.head(kSamples - 1).dot(white.tail(kSamples - 1));
      count += static_cast<double>(white.size());
    }
  }
  of.mean_square /= count;
  of.late_mean_square /= count;
  of.correlation /= count;
  of.error = std::sqrt(2.0 / count);
  return of;
}

TEST(KalmanWhitener, WhiteNoiseIsDividedByItsDeviation) {
  const MadeCase made = pendulum_case({}, white_noise(), 20);
  const Eigen::MatrixXd differences = Eigen::VectorXd::LinSpaced(20, -1.0, 1.0);
  EXPECT_TRUE(whitener_of(made, made.noise)(1, differences).isApprox(differences / 5e-4, 1e-12));
}

TEST(KalmanWhitener, SlowSensorNoiseHasTheInnovationsOfItsRecursion) {
  MadeCase made = pendulum_case({}, white_noise(), 20);
  made.noise.sensor_white = {0.0};
  made.noise.sensor_slow = {2e-3};
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(20, 1.0, 3.0).array().square();
  const Eigen::VectorXd white = whitener_of(made, made.noise)(0, x);
  const double memory = std::exp(-0.005 / made.noise.sensor_time);
  EXPECT_NEAR(white[0], x[0] / 2e-3, 1e-9);
  for (Eigen::Index k = 1; k < 20; ++k)
    EXPECT_NEAR(white[k], (x[k] - memory * x[k - 1]) / (2e-3 * std::sqrt(1.0 - memory * memory)), 1e-6);
}

TEST(KalmanWhitener, ColouredAndDisturbedNoiseComesOutWhite) {
  MadeCase made = pendulum_case({}, disturbed_noise(), kSamples);
  const Moments of = moments(made, whitener_of(made, made.noise));
  EXPECT_NEAR(of.mean_square, 1.0, 4.0 * of.error);
  EXPECT_NEAR(of.late_mean_square, 1.0, 4.0 * std::sqrt(2.0) * of.error);
  EXPECT_NEAR(of.correlation, 0.0, 4.0 * of.error / std::sqrt(2.0));
}

TEST(KalmanWhitener, SoItDoesBehindALagOfTheDrive) {
  MadeCase made = pendulum_case({{"actuator_lag", 0, {0.04}}}, disturbed_noise(), kSamples);
  made.noise.command = {0.1};  // so that it is more than the random torque's
  const Moments of = moments(made, whitener_of(made, made.noise));
  EXPECT_NEAR(of.mean_square, 1.0, 4.0 * of.error);
  EXPECT_NEAR(of.correlation, 0.0, 4.0 * of.error / std::sqrt(2.0));
}

TEST(KalmanWhitener, DryFrictionIsLinearisedClosely) {
  MadeCase made = pendulum_case({{"coulomb_friction", 0, {0.03}}}, disturbed_noise(), kSamples);
  EXPECT_NEAR(moments(made, whitener_of(made, made.noise)).mean_square, 1.0, 0.1);
}

TEST(KalmanWhitener, AWrongCovarianceShows) {
  MadeCase made = pendulum_case({}, disturbed_noise(), kSamples);
  CaseNoise less_force = made.noise, no_slow = made.noise, fast_force = made.noise;
  less_force.random_force = {0.005};
  no_slow.sensor_slow = {0.0};
  fast_force.force_time = 0.005;
  for (const CaseNoise& wrong : {less_force, no_slow, fast_force}) {
    const Moments of = moments(made, whitener_of(made, wrong));
    EXPECT_GT(std::abs(of.mean_square - 1.0), 8.0 * of.error);
  }
}

}  // namespace
}  // namespace hidden_effects

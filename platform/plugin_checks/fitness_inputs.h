#pragma once

#include <lacuna/test_fitness.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace lacuna {

/// A test and its predictions on which test fitnesses are tried, here and in the conformance tests.

inline constexpr Eigen::Index kReadings = 50;
inline constexpr double kReadingPeriod = 0.01;  ///< s

inline Test judged_test() {
  Test test;
  test.duration = kReadingPeriod * kReadings;
  return test;
}

/// What a model predicts that goes forward at a speed in m/s, with all that a fitness may ask for.
inline TestPrediction prediction_at(double speed) {
  TestPrediction prediction;
  prediction.sensors.channels = {{"touch", "1"}, {"angle", "rad"}};
  prediction.centre_of_mass.channels = {{"x", "m"}, {"y", "m"}, {"z", "m"}};
  prediction.sensors.times = Eigen::VectorXd::LinSpaced(kReadings, kReadingPeriod, kReadingPeriod * kReadings);
  prediction.centre_of_mass.times = prediction.sensors.times;
  prediction.sensors.samples.resize(kReadings, 2);
  prediction.centre_of_mass.samples.resize(kReadings, 3);
  for (Eigen::Index i = 0; i < kReadings; ++i) {
    const double t = prediction.sensors.times(i);
    prediction.sensors.samples.row(i) << (std::sin(30.0 * t * speed) > 0.0 ? 1.0 : -1.0), std::cos(speed * t);
    prediction.centre_of_mass.samples.row(i) << speed * t, 0.1 * t, 0.85;
  }
  prediction.noise = {0.5, 0.01};
  prediction.slopes = {TimeSeries::Samples::Constant(kReadings, 2, 0.1), 0.2 * prediction.sensors.samples};
  prediction.information = 12.0 * Eigen::MatrixXd::Identity(2, 2);
  return prediction;
}

/// Predictions of models that go forward at different speeds.
inline std::vector<TestPrediction> predictions_of(std::size_t models) {
  std::vector<TestPrediction> all;
  for (std::size_t m = 0; m < models; ++m) all.push_back(prediction_at(1.0 + static_cast<double>(m)));
  return all;
}

/// The same, the last of which breaks off before its last reading. At least one model.
inline std::vector<TestPrediction> predictions_broken_off(std::size_t models) {
  std::vector<TestPrediction> all = predictions_of(models);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  all.back().sensors.samples.bottomRows(1).setConstant(kNan);
  all.back().centre_of_mass.samples.bottomRows(1).setConstant(kNan);
  return all;
}

}  // namespace lacuna

#include "conformance/every_plugin.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

/// What holds for every test fitness.
namespace lacuna {
namespace {

constexpr Eigen::Index kReadings = 50;
constexpr double kPeriod = 0.01;  // s

/// Models that go forward at different speeds, with all that a fitness may ask for.
std::vector<TestPrediction> predictions(std::size_t models) {
  std::vector<TestPrediction> all;
  for (std::size_t m = 0; m < models; ++m) {
    TestPrediction prediction;
    prediction.sensors.channels = {{"touch", "1"}, {"angle", "rad"}};
    prediction.centre_of_mass.channels = {{"x", "m"}, {"y", "m"}, {"z", "m"}};
    prediction.sensors.times = Eigen::VectorXd::LinSpaced(kReadings, kPeriod, kPeriod * kReadings);
    prediction.centre_of_mass.times = prediction.sensors.times;
    prediction.sensors.samples.resize(kReadings, 2);
    prediction.centre_of_mass.samples.resize(kReadings, 3);
    for (Eigen::Index i = 0; i < kReadings; ++i) {
      const double t = prediction.sensors.times(i), speed = 1.0 + static_cast<double>(m);
      prediction.sensors.samples.row(i) << (std::sin(30.0 * t * speed) > 0.0 ? 1.0 : -1.0), std::cos(speed * t);
      prediction.centre_of_mass.samples.row(i) << speed * t, 0.1 * t, 0.85;
    }
    prediction.noise = {0.5, 0.01};
    prediction.slopes = {TimeSeries::Samples::Constant(kReadings, 2, 0.1), 0.2 * prediction.sensors.samples};
    prediction.information = 12.0 * Eigen::MatrixXd::Identity(2, 2);
    all.push_back(prediction);
  }
  return all;
}

TEST(TestFitnessConformance, JudgesTheSameTestTheSame) {
  on_every<TestFitness>([&](const TestFitness& fitness, const std::vector<double>& parameters) {
    EXPECT_FALSE(fitness.unit().empty());
    const std::vector<TestPrediction> all = predictions(fitness.models(parameters));
    lacuna::Test test;
    test.duration = kPeriod * kReadings;
    const double score = fitness.score(test, all, parameters);
    EXPECT_TRUE(std::isfinite(score));
    EXPECT_EQ(fitness.score(test, all, parameters), score);
  });
}

/// A test on which some model fails must not come out as the best of all.
TEST(TestFitnessConformance, APredictionThatIsNoNumberMakesNoBetterTest) {
  on_every<TestFitness>([&](const TestFitness& fitness, const std::vector<double>& parameters) {
    std::vector<TestPrediction> all = predictions(fitness.models(parameters));
    if (all.empty()) return;
    lacuna::Test test;
    test.duration = kPeriod * kReadings;
    const double score = fitness.score(test, all, parameters);
    all.back().sensors.samples.bottomRows(1).setConstant(std::numeric_limits<double>::quiet_NaN());
    all.back().centre_of_mass.samples.bottomRows(1).setConstant(std::numeric_limits<double>::quiet_NaN());
    const double broken = fitness.score(test, all, parameters);
    EXPECT_TRUE(!std::isfinite(broken) || broken <= score) << broken;
  });
}

}  // namespace
}  // namespace lacuna

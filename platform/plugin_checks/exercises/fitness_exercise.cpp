#include "plugin_checks/exercises/exercises.h"

#include <lacuna/error.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr Eigen::Index kReadings = 50;
constexpr double kReadingPeriod = 0.01;    // s
constexpr std::size_t kMostModels = 1000;  // that are predicted here

/// Predictions of models that move forward at different speeds, with everything that a fitness may ask for.
std::vector<TestPrediction> predictions(std::size_t models) {
  std::vector<TestPrediction> all;
  for (std::size_t m = 0; m < models; ++m) {
    TestPrediction prediction;
    prediction.sensors.channels = {{"touch", "1"}, {"angle", "rad"}};
    prediction.centre_of_mass.channels = {{"x", "m"}, {"y", "m"}, {"z", "m"}};
    prediction.sensors.times = Eigen::VectorXd::LinSpaced(kReadings, kReadingPeriod, kReadingPeriod * kReadings);
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

class FitnessExercise : public Exercise {
 public:
  explicit FitnessExercise(const TestFitness& fitness) : fitness_(fitness) {
    test_.duration = kReadingPeriod * kReadings;
  }

  ParameterDeclarations declared() const override { return fitness_.parameters(); }

  void go(const Setting& setting, Transcript& transcript) const override {
    const std::size_t models = fitness_.models(setting);
    transcript.add("models", static_cast<double>(models));
    if (models > kMostModels) return;
    transcript.add("score", fitness_.score(test_, predictions(models), setting));
  }

  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    if (fitness_.unit().empty()) broken.emplace_back("unit() is empty; return \"1\" where the score has none");
    const Setting setting = settings().front();
    std::vector<TestPrediction> all = predictions(std::min(fitness_.models(setting), kMostModels));
    if (all.empty()) return broken;
    const double score = fitness_.score(test_, all, setting);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    all.back().sensors.samples.bottomRows(1).setConstant(kNan);
    all.back().centre_of_mass.samples.bottomRows(1).setConstant(kNan);
    const double broken_off = fitness_.score(test_, all, setting);
    if (std::isfinite(broken_off) && broken_off > score)
      broken.emplace_back(
          "a prediction that breaks off raises the fitness of a test; return no number for such a test");
    return broken;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    const std::vector<TestPrediction> all = predictions(std::min(fitness_.models(setting), kMostModels));
    return {repeated_call("score", true, 20, [&] { fitness_.score(test_, all, setting); })};
  }

 private:
  const TestFitness& fitness_;
  Test test_;
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const TestFitness& fitness, const ExerciseInputs&) {
  return std::make_unique<FitnessExercise>(fitness);
}

}  // namespace lacuna

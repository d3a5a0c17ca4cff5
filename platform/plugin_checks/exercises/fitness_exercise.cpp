#include "plugin_checks/exercises/exercises.h"
#include "plugin_checks/fitness_inputs.h"

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

constexpr std::size_t kMostModels = 1000;  // that are predicted here

class FitnessExercise : public Exercise {
 public:
  explicit FitnessExercise(const TestFitness& fitness) : fitness_(fitness) {}

  ParameterDeclarations declared() const override { return fitness_.parameters(); }

  void go(const Setting& setting, Transcript& transcript) const override {
    const std::size_t models = fitness_.models(setting);
    transcript.add("models", static_cast<double>(models));
    if (models > kMostModels) return;
    transcript.add("score", fitness_.score(test_, predictions_of(models), setting));
  }

  std::vector<std::string> broken_promises() const override {
    std::vector<std::string> broken;
    if (fitness_.unit().empty()) broken.emplace_back("unit() is empty; return \"1\" where the score has none");
    const Setting setting = settings().front();
    const std::size_t models = std::min(fitness_.models(setting), kMostModels);
    if (models == 0) return broken;
    const double score = fitness_.score(test_, predictions_of(models), setting);
    const double broken_off = fitness_.score(test_, predictions_broken_off(models), setting);
    if (std::isfinite(broken_off) && broken_off > score)
      broken.emplace_back(
          "a prediction that breaks off raises the fitness of a test; return no number for such a test");
    return broken;
  }

  std::vector<RepeatedCall> repeated_calls() const override {
    const Setting setting = settings().front();
    const std::vector<TestPrediction> all = predictions_of(std::min(fitness_.models(setting), kMostModels));
    return {repeated_call("score", true, 20, [&] { fitness_.score(test_, all, setting); })};
  }

 private:
  const TestFitness& fitness_;
  const Test test_ = judged_test();
};

}  // namespace

std::unique_ptr<Exercise> exercise_of(const TestFitness& fitness, const ExerciseInputs&) {
  return std::make_unique<FitnessExercise>(fitness);
}

}  // namespace lacuna

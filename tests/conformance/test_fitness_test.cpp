#include "conformance/every_plugin.h"
#include "plugin_checks/fitness_inputs.h"

#include <gmock/gmock.h>

#include <cmath>

/// What holds for every test fitness.
namespace lacuna {
namespace {

TEST(TestFitnessConformance, JudgesTheSameTestTheSame) {
  on_every<TestFitness>([&](const TestFitness& fitness, const std::vector<double>& parameters) {
    EXPECT_FALSE(fitness.unit().empty());
    const std::vector<TestPrediction> all = predictions_of(fitness.models(parameters));
    const lacuna::Test test = judged_test();
    const double score = fitness.score(test, all, parameters);
    EXPECT_TRUE(std::isfinite(score));
    EXPECT_EQ(fitness.score(test, all, parameters), score);
  });
}

/// A test on which some model fails must not come out as the best of all.
TEST(TestFitnessConformance, APredictionThatIsNoNumberMakesNoBetterTest) {
  on_every<TestFitness>([&](const TestFitness& fitness, const std::vector<double>& parameters) {
    const std::size_t models = fitness.models(parameters);
    if (models == 0) return;
    const double score = fitness.score(judged_test(), predictions_of(models), parameters);
    const double broken = fitness.score(judged_test(), predictions_broken_off(models), parameters);
    EXPECT_TRUE(!std::isfinite(broken) || broken <= score) << broken;
  });
}

}  // namespace
}  // namespace lacuna

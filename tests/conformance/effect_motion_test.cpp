#include "conformance/effect_rig.h"

#include "support/tolerances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

/// What every physical effect does to a motion, at the values of its README and on the way to its neutral ones.
namespace lacuna {
namespace {

std::vector<double> defaults_of(const PhysicalEffect& effect) {
  std::vector<double> values;
  for (const ParameterDeclaration& declaration : effect.describe().parameters)
    values.push_back(declaration.default_value);
  return values;
}

double largest_difference(const TimeSeries::Samples& a, const TimeSeries::Samples& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

TEST(EffectConformance, ChangesNothingAtItsNeutralValues) {
  on_every_effect([](const std::string& name, const PhysicalEffect& effect) {
    if (!effect.describe().neutral.empty()) return;  // below
    const ModelDefinition model = readme_model(name);
    EXPECT_LE(largest_difference(readings(moving_with(model, defaults_of(effect))), readings(moving_without(model))),
              kRounding);
  });
}

/// A value the given share of the way from its default to the neutral one.
std::vector<double> on_the_way(const PhysicalEffect& effect, double share) {
  const EffectDescription description = effect.describe();
  std::vector<double> values = defaults_of(effect);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double neutral = description.neutral.at(i);
    if (description.parameters[i].scale == Scale::logarithmic)
      values[i] *= std::pow(neutral / values[i], share);
    else
      values[i] += share * (neutral - values[i]);
  }
  return values;
}

/// Readings but those of touch sensors, which jump.
TimeSeries::Samples smooth_readings(SimulationRun run) {
  std::erase_if(run.structure.robot.sensors, [](const SensorSpec& sensor) { return sensor.kind == SensorKind::touch; });
  return readings(run);
}

constexpr double kFaded = 1e-4;  // rad, m, ...: far below what an encoder tells

TEST(EffectConformance, FadesOnTheWayToNeutralValuesThatAreBounds) {
  on_every_effect([](const std::string& name, const PhysicalEffect& effect) {
    if (effect.describe().neutral.empty()) return;
    ASSERT_EQ(effect.describe().neutral.size(), effect.describe().parameters.size());
    const ModelDefinition model = readme_model(name);
    const TimeSeries::Samples absent = smooth_readings(moving_without(model));
    const double shown = largest_difference(smooth_readings(moving(model)), absent);
    const double halfway = largest_difference(smooth_readings(moving_with(model, on_the_way(effect, 0.5))), absent);
    const double faded = largest_difference(smooth_readings(moving_with(model, on_the_way(effect, 1.0))), absent);
    EXPECT_LE(faded, kFaded);
    EXPECT_LE(faded, halfway + 0.1 * kFaded);
    EXPECT_LT(halfway, shown);
  });
}

TEST(EffectConformance, ShowsAtTheValuesOfItsReadme) {
  on_every_effect([](const std::string& name, const PhysicalEffect&) {
    const ModelDefinition model = readme_model(name);
    EXPECT_GT(largest_difference(readings(moving(model)), readings(moving_without(model))), 1e-6);
  });
}

TEST(EffectConformance, GivesTheSameBitsEveryTime) {
  on_every_effect([](const std::string& name, const PhysicalEffect&) {
    const SimulationRun run = moving(readme_model(name));
    EXPECT_TRUE((readings(run).array() == readings(run).array()).all());
  });
}

}  // namespace
}  // namespace lacuna

#include "conformance/effect_rig.h"

#include "foundation/placement_unit.h"
#include "foundation/unit.h"
#include "support/allocation_counter.h"
#include "support/reference_integration.h"
#include "support/tolerances.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

/// What holds for every physical effect, at the values of its README.
namespace lacuna {
namespace {

using testing::Not;

std::vector<double> defaults_of(const PhysicalEffect& effect) {
  std::vector<double> values;
  for (const ParameterDeclaration& declaration : effect.describe().parameters)
    values.push_back(declaration.default_value);
  return values;
}

double largest_difference(const TimeSeries::Samples& a, const TimeSeries::Samples& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

TEST(EffectConformance, DeclaresWhatItIs) {
  on_every_effect([](const std::string&, const PhysicalEffect& effect) {
    const EffectDescription description = effect.describe();
    for (const std::string& text :
         {description.summary, description.equation, description.literature, description.regime})
      EXPECT_THAT(text, Not(testing::IsEmpty()));
    EXPECT_FALSE(description.look_alikes.empty());
    EXPECT_FALSE(description.placements.empty());
    EXPECT_FALSE(description.parameters.empty());
  });
}

TEST(EffectConformance, ItsParametersHaveUnitsBoundsAndADefaultWithin) {
  on_every_effect([](const std::string&, const PhysicalEffect& effect) {
    for (const ParameterDeclaration& parameter : effect.describe().parameters) {
      EXPECT_THAT(parameter.description, Not(testing::IsEmpty())) << parameter.name;
      EXPECT_THAT(unit_in_words(parameter.unit), Not(testing::IsEmpty())) << parameter.name;
      EXPECT_LT(parameter.lower, parameter.upper) << parameter.name;
      EXPECT_GE(parameter.default_value, parameter.lower) << parameter.name;
      EXPECT_LE(parameter.default_value, parameter.upper) << parameter.name;
      EXPECT_TRUE(std::isfinite(parameter.lower) && std::isfinite(parameter.upper)) << parameter.name;
      if (parameter.scale == Scale::logarithmic) {
        EXPECT_GT(parameter.lower, 0.0) << parameter.name;
      }
    }
  });
}

TEST(EffectConformance, ItsLookAlikesAreEffectsToo) {
  const std::vector<std::string> names = every_effect();
  const std::set<std::string> known(names.begin(), names.end());
  on_every_effect([&](const std::string& name, const PhysicalEffect& effect) {
    for (const std::string& other : effect.describe().look_alikes) {
      EXPECT_NE(other, name);
      EXPECT_TRUE(known.contains(other)) << other;
    }
  });
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

TEST(EffectConformance, GoesOnFromASavedStateWithTheSameBits) {
  on_every_effect([](const std::string& name, const PhysicalEffect&) {
    expect_same_bits_after_restore(moving(readme_model(name)), evenly_spaced(0.8, 40), 17);
  });
}

/// Allocations of a simulation of `duration` in a workspace and a result that were used before.
long allocations_of(const SimulationRun& run, double duration) {
  const auto model = compile(run.structure, run.engine);
  const auto workspace = model->make_workspace();
  const std::vector<double> times = {0.0, 0.5 * duration, duration};
  SimulationOptions options;
  options.start = run.test.start;
  options.end_time = duration;
  options.output_times = times;
  options.imperfections = run.imperfections;
  SimulationResult result;
  model->simulate(run.parameters, run.test, options, *workspace, result);
  const long before = allocations();
  model->simulate(run.parameters, run.test, options, *workspace, result);
  EXPECT_EQ(result.ending, Ending::completed) << result.reason;
  return allocations() - before;
}

TEST(EffectConformance, AllocatesNothingInAStep) {
  if (!kCountsAllocations) GTEST_SKIP() << kOwnAllocator;
  on_every_effect([](const std::string& name, const PhysicalEffect&) {
    const SimulationRun run = moving(readme_model(name));
    EXPECT_EQ(allocations_of(run, 0.1), allocations_of(run, 0.8));
  });
}

}  // namespace
}  // namespace lacuna

#include "conformance/effect_rig.h"

#include "foundation/placement_unit.h"
#include "foundation/unit.h"
#include "support/allocation_counter.h"
#include "support/reference_integration.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

/// What holds for every physical effect, at the values of its README.
namespace lacuna {
namespace {

using testing::Not;

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

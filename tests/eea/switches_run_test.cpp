#include "eea/same_rows.h"
#include "eea/small_run.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

/// The algorithm with effects as switches: rival hypotheses in one population.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A cart with a pole on a rail that has dry friction. Its models may have that, a viscous friction or a spring.
constexpr const char* kStickyCart = R"([experiment]
name = "sticky_cart"
passes = 3

[target]
kind = "simulated"
file = "robots/cart-pole.toml"
effects = [{ id = "stick", effect = "coulomb_friction", where = "joint.rail", start = { torque = 1.5 } }]
hidden = { "body.cart.mass" = { uniform = [0.8, 1.5] } }

[model]
file = "robots/cart-pole.toml"
encoding = "parameters_and_effects"
encoding_parameters = { at_most = 1 }
free = { "body.cart.mass" = [0.5, 2.0] }
effects = [
  { id = "grease", effect = "viscous_friction", where = "joint.rail", range = { damping = [0, 5] }, optional = true },
  { id = "hose", effect = "joint_spring", where = "joint.rail", range = { stiffness = [0, 20], rest = [-1, 1] }, optional = true },
  { id = "stick", effect = "coulomb_friction", where = "joint.rail", range = { torque = [0, 4] }, optional = true },
]

[engine]
step = 0.01

[test]
encoding = "command_series"
parameters = { lowest_frequency = 0.5, highest_frequency = 4.0 }
duration = 0.8

[estimation]
objective = "parameter_error"
parameters = { population = 40, keep = 20, generations = 20 }

[exploration]
fitness = "random"
parameters = { population = 2, keep = 1, generations = 1 }
)";

std::size_t index_of(const EeaDefinition& definition, const std::string& address) {
  const std::vector<FreeValue>& free = definition.model.free;
  const auto found =
      std::find_if(free.begin(), free.end(), [&](const FreeValue& value) { return value.address == address; });
  return static_cast<std::size_t>(found - free.begin());
}

double objective(const PassRow& pass, const std::string& name) {
  for (const ObjectiveRow& row : pass.objective)
    if (row.name == name) return row.value;
  return NAN;
}

TEST(SwitchesRun, FindsWhichEffectThereIsTogetherWithItsParameter) {
  const auto bench = small_bench({}, kStickyCart);
  const EeaDefinition& definition = bench->definition();
  const MemoryJournal journal = run(*bench);
  ASSERT_EQ(journal.passes.size(), 3U);
  const PassRow& last = journal.passes.back();
  EXPECT_EQ(definition.decode_model(journal.models[*last.best_model].genome).structure, "stick");
  ASSERT_EQ(last.best_values.size(), definition.model.free.size());
  EXPECT_NEAR(last.best_values[index_of(definition, "effect.stick.torque")], 1.5, 0.3);
  EXPECT_TRUE(std::isnan(last.best_values[index_of(definition, "effect.grease.damping")]));
  EXPECT_EQ(objective(last, "effects"), 0.0);
  EXPECT_LT(objective(last, "effect.stick.torque"), 0.3);
}

TEST(SwitchesRun, RivalsShareAPopulation) {
  const auto bench = small_bench({"experiment.passes=1", "model.encoding_parameters.at_most=2"}, kStickyCart);
  const MemoryJournal journal = run(*bench);
  std::vector<std::string> structures;
  for (const ModelRow& row : journal.models)
    if (row.generation == 0) structures.push_back(bench->definition().decode_model(row.genome).structure);
  for (const char* rival : {"no optional effect", "stick", "grease", "hose", "hose + grease", "stick + grease"})
    EXPECT_THAT(structures, testing::Contains(rival));
}

TEST(SwitchesRun, AnyNumberOfThreadsGivesTheSameRows) {
  const auto bench = small_bench({}, kStickyCart);
  expect_same_models(run(*bench, 1).models, run(*bench, 2).models);
}

/// From a checkpoint of each phase of each pass.
TEST(SwitchesRun, GoesOnWithTheSameRows) {
  const auto bench = small_bench({"experiment.passes=2", "estimation.parameters.generations=5"}, kStickyCart);
  const MemoryJournal whole = run(*bench);
  for (const std::vector<double>& checkpoint : whole.checkpoints) {
    EeaState state = state_at(*bench, whole, checkpoint);
    if (state.phase != Phase::estimation) continue;
    const std::uint64_t before = state.models;
    MemoryJournal rest;
    run(*bench, rest, state);
    expect_same_models(rest.models, {whole.models.begin() + static_cast<std::ptrdiff_t>(before), whole.models.end()});
    EXPECT_TRUE(same(rest.passes.back().best_values, whole.passes.back().best_values));
  }
}

TEST(SwitchesRun, AnEncodingWithoutSwitchesTakesAllEffects) {
  const auto bench =
      small_bench({"experiment.passes=1", "model.encoding=parameters", "model.encoding_parameters={}"}, kStickyCart);
  const MemoryJournal journal = run(*bench);
  EXPECT_EQ(bench->definition().estimation.layout().size(), bench->definition().model.free.size());
  for (const double value : journal.passes[0].best_values) EXPECT_TRUE(std::isfinite(value));
}

TEST(SwitchesRun, ValuesKeepTheirPlacesWhereDelaysAreNoGenes) {
  const auto bench = small_bench({"experiment.passes=1", "model.free.'sensor.*.delay'=[0,0.1]",
                                  "estimation.profiled=['sensor.*.delay']", "estimation.replay=true"},
                                 kStickyCart);
  const EeaDefinition& definition = bench->definition();
  const MemoryJournal journal = run(*bench);
  const PassRow& pass = journal.passes.front();
  const ModelProposal best = definition.decode_model(journal.models[*pass.best_model].genome);
  for (std::size_t i = 0; i < definition.model.free.size(); ++i) {
    const std::string& address = definition.model.free[i].address;
    const bool absent = address.starts_with("effect.") && !address.starts_with("effect." + best.structure + ".");
    EXPECT_EQ(std::isnan(pass.best_values[i]), absent) << address;
  }
}

TEST(SwitchesRun, AModelWithoutAnOptionalEffectIsAMistakeOfTheFile) {
  EXPECT_THAT([] { small_bench({"model.encoding=parameters_and_effects"}); },
              ThrowsMessage<BadInput>(AllOf(HasSubstr("model.encoding"), HasSubstr("write optional = true"))));
}

/// Leaves out what it is told to.
class OtherSwitches : public ModelEncoding {
 public:
  std::string summary() const override { return "wrong"; }
  GenomeLayout layout(const ModelSpace&, std::span<const double>) const override { return {}; }
  ModelProposal decode(const ModelSpace& space, std::span<const double>, std::span<const double>) const override {
    ModelProposal model;
    model.values.assign(space.free.size(), 1.0);
    model.without = without;
    return model;
  }
  std::vector<std::size_t> without;
};

TEST(SwitchesRun, SetsOfEffectsThatCannotBeAreAFaultOfThePlugin) {
  const auto bench =
      small_bench({"model.effects[2].optional=false"}, kStickyCart);  // stick, of which canonically first
  EeaDefinition definition(bench->opened().experiment, *bench->opened().catalog, bench->opened().definition, true);
  OtherSwitches switches;
  definition.model_encoding.component = &switches;
  const auto says = [&](const std::vector<std::size_t>& without, const char* what) {
    switches.without = without;
    EXPECT_THAT([&] { definition.decode_model({}); },
                ThrowsMessage<Error>(AllOf(HasSubstr(what), HasSubstr("fault of the plugin"))));
  };
  says({0}, "the effect \"stick\", which is not optional");
  says({3}, "effect 3 of a model that has 3");
  says({2, 1}, "ascending");
  says({1, 1}, "ascending");
  switches.without = {1, 2};
  EXPECT_TRUE(std::isnan(definition.decode_model({}).values[index_of(definition, "effect.grease.damping")]));
}

}  // namespace
}  // namespace lacuna

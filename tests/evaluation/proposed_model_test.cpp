#include "evaluation/model/proposed_model.h"

#include "evaluation/scoring/candidate_simulator.h"
#include "evaluation/scoring/model_evaluator.h"
#include "plugins/built_catalog.h"
#include "support/robots.h"

#include <gmock/gmock.h>

#include <memory>

/// Models that do without some of the effects.
namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kInertia = 1.5;  // kg·m²
constexpr double kPush = 2.0;     // N·m, above all dry friction here

/// A body on a hinge, its armature free, with optional effects: "a" to "f", each of a law of its own.
class ProposedModel : public testing::Test {
 protected:
  ProposedModel() {
    experiment_.file = "rig.toml";
    experiment_.model.robot = "declared";
    experiment_.model.declared = one_joint(JointKind::hinge, 1.0);
    experiment_.model.free = {{"joint.joint.armature", 0.1, 2.0, 0.5}};
    experiment_.engine.step = 0.01;
    add("f", "viscous_friction", {{"damping", 0.3}});
    add("a", "armature", {{"inertia", 0.4}});
    add("e", "joint_spring", {{"stiffness", 3.0}, {"rest", 0.1}});
    add("b", "coulomb_friction", {{"torque", 0.5}});
    add("d", "joint_offset_torque", {{"torque", 0.2}});
    add("c", "cubic_stiffness", {{"stiffness", 5.0}, {"rest", 0.0}});
    definition_ = define();
    shared_ = compile(definition_.structure, definition_.engine);
  }

  void add(const std::string& id, const std::string& effect, const std::map<std::string, double>& start) {
    experiment_.model.effects.push_back({id, effect, {"joint.joint"}, start, {}});
    experiment_.model.effects.back().optional = id != "f";
  }
  ModelDefinition define() const { return define_model(experiment_, built_catalog()); }

  /// At its start values, without the effects of the bits that are not set.
  ModelProposal proposal(unsigned effects = ~0U) const {
    ModelProposal model;
    model.values = definition_.start_values();
    for (std::size_t i = 0; i < definition_.effects.size(); ++i)
      if ((effects >> i & 1U) == 0) model.without.push_back(i);
    return model;
  }
  ModelProposal without(const std::string& id) const {
    for (std::size_t i = 0; i < definition_.effects.size(); ++i)
      if (definition_.effects[i].id == id) return proposal(~(1U << i));
    throw Error("no effect " + id);
  }

  static lacuna::Test push() {
    CommandSeries commands;
    commands.series.channels = {{"motor", "N*m"}};
    commands.series.times = Eigen::VectorXd::Zero(1);
    commands.series.samples = TimeSeries::Samples::Constant(1, 1, kPush);
    return {commands, 0.3, {}};
  }
  static SimulationOptions options() {
    static const std::vector<double> kTimes = {0.0, 0.1, 0.2, 0.3};
    SimulationOptions options;
    options.end_time = kTimes.back();
    options.output_times = kTimes;
    return options;
  }
  static TimeSeries::Samples readings(CandidateSimulator& simulator, const ModelProposal& candidate) {
    SimulationResult result;
    simulator.take(candidate);
    simulator.simulate(push(), options(), result);
    EXPECT_EQ(result.ending, Ending::completed) << result.reason;
    return result.readings.samples;
  }

  Experiment experiment_;
  ModelDefinition definition_;
  std::unique_ptr<CompiledModel> shared_;
};

TEST_F(ProposedModel, EffectsStandInCanonicalOrderWithTheirFreeParameters) {
  const std::vector<ModelEffect> effects = model_effects(definition_);
  std::vector<std::string> ids;
  for (const ModelEffect& effect : effects) {
    ids.push_back(effect.id);
    for (const std::size_t value : effect.values)
      EXPECT_THAT(definition_.free.at(value).address, testing::StartsWith("effect." + effect.id + "."));
  }
  EXPECT_THAT(ids, ElementsAre("a", "b", "c", "d", "e", "f")) << "sorted by the effects' names";
  EXPECT_EQ(effects[2].values.size(), 2U);
  EXPECT_TRUE(effects[0].optional);
  EXPECT_FALSE(effects[5].optional);
}

/// Bit for bit.
TEST_F(ProposedModel, WithoutAnEffectItIsTheModelThatNeverHadIt) {
  CandidateSimulator simulator(*shared_, &definition_);
  for (const char* id : {"a", "b", "c", "d", "e", "f"}) {
    Experiment fewer = experiment_;
    std::erase_if(fewer.model.effects, [&](const EffectEntry& entry) { return entry.id == id; });
    const ModelDefinition never = define_model(fewer, built_catalog());
    SimulationResult expected;
    const auto model = compile(never.structure, never.engine);
    model->simulate(never.start_values(), push(), options(), *model->make_workspace(), expected);
    EXPECT_EQ(readings(simulator, without(id)), expected.readings.samples) << id;
    EXPECT_NE(readings(simulator, proposal()), expected.readings.samples) << id;
  }
}

TEST_F(ProposedModel, ItsStructureAndTheValuesOfThatAreWhatADeskSimulates) {
  CandidateSimulator simulator(*shared_, &definition_);
  const ModelProposal candidate = proposal(0b101010U);
  const ModelStructure structure = structure_of(candidate, definition_);
  EXPECT_EQ(structure.effects.size(), 3U);
  const auto compiled = compile(structure, definition_.engine);
  SimulationResult result;
  compiled->simulate(structure_values(candidate, definition_), push(), options(), *compiled->make_workspace(), result);
  EXPECT_EQ(result.readings.samples, readings(simulator, candidate));
  EXPECT_EQ(structure_values(proposal(), definition_), definition_.start_values());
}

/// More sets than stay compiled, each twice, in another order than a desk that has seen nothing else.
TEST_F(ProposedModel, WhatCameBeforeChangesNothing) {
  CandidateSimulator used(*shared_, &definition_);
  for (int time = 0; time < 2; ++time)
    for (unsigned effects = 0; effects < 64; ++effects) {
      CandidateSimulator fresh(*shared_, &definition_);
      EXPECT_EQ(readings(used, proposal(effects)), readings(fresh, proposal(effects))) << effects;
    }
}

TEST_F(ProposedModel, ARobotOfItsOwnMayDoWithoutEffectsToo) {
  CandidateSimulator simulator(*shared_, &definition_, 2);
  ModelProposal own = without("b"), shared = without("b");
  auto heavier = std::make_shared<RobotSpec>(definition_.structure.robot);
  heavier->bodies[0].inertia.yy = kInertia;
  own.robot = heavier;
  const TimeSeries::Samples first = readings(simulator, own);
  EXPECT_NE(first, readings(simulator, shared));
  own.without.clear();
  EXPECT_NE(first, readings(simulator, own)) << "the same robot with all effects";
  own.without = shared.without;
  EXPECT_EQ(first, readings(simulator, own));
}

TEST_F(ProposedModel, WithoutADefinitionAllEffectsStay) {
  CandidateSimulator simulator(*shared_, nullptr);
  EXPECT_THAT([&] { simulator.take(without("a")); }, ThrowsMessage<Error>(HasSubstr("without some of the effects")));
  readings(simulator, proposal());
}

class ProposedModelEvaluation : public ProposedModel {
 protected:
  ProposedModelEvaluation() {
    ScoredTrial scored;
    scored.test = push();
    SimulationResult result;
    shared_->simulate(definition_.start_values(), scored.test, options(), *shared_->make_workspace(), result);
    scored.trial.name = "pushed";
    scored.trial.measured = result.readings;
    const Chosen<FitnessMetric> metric{&built_catalog().get<FitnessMetric>("mean_absolute_difference"), {}, {}};
    scorer_ = std::make_unique<ModelScorer>(*shared_, std::vector{scored}, metric, Work{2}, &definition_);
  }

  std::unique_ptr<ModelScorer> scorer_;
};

TEST_F(ProposedModelEvaluation, ValuesOfEffectsThatAreLeftOutAreNoOtherModel) {
  ModelEvaluator evaluator(definition_, {});
  const auto evaluate = [&](const std::vector<ModelProposal>& models) {
    return evaluator.evaluate(models, std::nullopt, [&](std::span<const std::size_t> fresh, std::optional<double> bar) {
      std::vector<ModelScore> scores(fresh.size());
      for (std::size_t i = 0; i < fresh.size(); ++i) scorer_->score(models[fresh[i]], bar, 1, scores[i]);
      return scores;
    });
  };
  ModelProposal one = without("b"), other = one, whole = proposal();
  const std::vector<ModelEffect> effects = model_effects(definition_);
  for (const std::size_t value : effects[1].values) other.values[value] += 1.0;
  ModelProposal less = proposal(~0b11U), third = without("a");
  const auto evaluated = evaluate({one, other, whole, less, third});
  EXPECT_TRUE(evaluated[1].reused);
  EXPECT_EQ(evaluated[1].score.total, evaluated[0].score.total);
  for (const std::size_t i : {2U, 3U, 4U}) EXPECT_FALSE(evaluated[i].reused) << i;
  EXPECT_EQ(evaluated[2].score.total, 0.0);
  EXPECT_EQ(evaluated[0].score.kind, ScoreKind::full);
  EXPECT_GT(evaluated[0].score.total, 0.0);
  EXPECT_TRUE(evaluate({third})[0].reused);
}

}  // namespace
}  // namespace lacuna

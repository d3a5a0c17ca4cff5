#include "candidates/hypothesis.h"

#include "candidates/augmented_model.h"
#include "config/experiment_reader.h"
#include "plugins/built_catalog.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace lacuna {
namespace {

using testing::ElementsAre;

/// A pendulum with a motor and an encoder, three of whose values are free.
class CandidatesOfPendulum : public testing::Test {
 protected:
  CandidatesOfPendulum() : experiment_(read_experiment(LACUNA_SOURCE_DIRECTORY "/experiments/first-steps.toml")) {
    experiment_.model.effects = {};
  }

  std::vector<Hypothesis> listed(const std::vector<std::string>& among) {
    return list_hypotheses(experiment_, built_catalog(), define_model(experiment_, built_catalog()), among,
                           untestable_);
  }
  std::vector<std::string> names(const std::vector<std::string>& among) {
    std::vector<std::string> all;
    for (const Hypothesis& one : listed(among)) all.push_back(member_name(one.entry));
    return all;
  }
  static EffectEntry friction() {
    EffectEntry entry;
    entry.effect = "coulomb_friction";
    entry.where = {"joint.hinge"};
    return entry;
  }

  Experiment experiment_;
  std::vector<Untestable> untestable_;
};

TEST_F(CandidatesOfPendulum, StandAtEveryPlaceThatTakesThem) {
  EXPECT_THAT(names({"coulomb_friction", "sensor_offset"}),
              testing::UnorderedElementsAre("coulomb_friction @ joint.hinge", "sensor_offset @ sensor.angle"));
}

TEST_F(CandidatesOfPendulum, AreNotListedWhereTheModelHasThem) {
  experiment_ = with_effect(experiment_, friction());
  EXPECT_THAT(names({"coulomb_friction"}), ElementsAre());
}

TEST_F(CandidatesOfPendulum, HaveTheirValuesBesideTheModels) {
  const std::vector<Hypothesis> all = listed({"coulomb_friction"});
  ASSERT_EQ(all.size(), 1U);
  const Hypothesis& one = all[0];
  ASSERT_EQ(one.base.size(), 3U);
  ASSERT_EQ(one.own.size(), 1U);
  EXPECT_EQ(one.definition.free.size(), 4U);
  EXPECT_EQ(one.neutral[0], 0.0) << "friction of nothing";
  EXPECT_TRUE(one.definition.free[one.own[0]].address.ends_with(".torque"));
  const std::vector<double> values = one.values({1.0, 2.0, 3.0}, {9.0});
  EXPECT_EQ(values[one.own[0]], 9.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(values[one.base[i]], static_cast<double>(i) + 1.0);
}

TEST_F(CandidatesOfPendulum, AreRefusedUnderANameThatNoPluginHas) { EXPECT_THROW(listed({"no_such_effect"}), Error); }

TEST_F(CandidatesOfPendulum, GetAnUnusedId) {
  const Experiment twice = with_effect(with_effect(experiment_, friction()), friction());
  ASSERT_EQ(twice.model.effects.size(), 2U);
  EXPECT_EQ(twice.model.effects[0].id, "coulomb_friction");
  EXPECT_NE(twice.model.effects[1].id, "coulomb_friction");
}

RobotSpec robot_of(std::size_t joints) {
  RobotSpec robot;
  for (std::size_t i = 0; i < joints; ++i) robot.joints.push_back({.name = "j" + std::to_string(i)});
  return robot;
}

EffectEntry on(const std::string& place) {
  EffectEntry entry;
  entry.id = "friction";
  entry.effect = "coulomb_friction";
  entry.where = {place};
  return entry;
}

TEST(PlacedEntries, HaveAValueForEachOfManyJoints) {
  const std::vector<EffectEntry> placed = placed_entries(on("joint.*"), robot_of(4));
  ASSERT_EQ(placed.size(), 4U);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_THAT(placed[i].where, ElementsAre("joint.j" + std::to_string(i)));
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(placed[i].id, placed[j].id);
  }
}

TEST(PlacedEntries, ShareOneValueOnFewJointsAndOnOtherElements) {
  EXPECT_EQ(placed_entries(on("joint.*"), robot_of(3)).size(), 1U);
  EXPECT_EQ(placed_entries(on("joint.j2"), robot_of(4)).size(), 1U);
  EXPECT_EQ(placed_entries(on("sensor.*"), robot_of(4)).size(), 1U);
}

/// Friction in four joints is one law with four values.
TEST(HypothesesOfManyJoints, CountTheValuesOfOneJoint) {
  Hypothesis every;
  every.placed = placed_entries(on("joint.*"), robot_of(4));
  for (const EffectEntry& one : every.placed) {
    every.own.push_back(every.definition.free.size());
    every.definition.free.push_back({{"effect." + one.id + ".torque", "N*m", 0.0, 9.0, 0.0, Scale::linear}, ""});
  }
  EXPECT_EQ(every.parameters(), 1U);
  EXPECT_THAT(every.own_names(),
              ElementsAre("coulomb_friction @ joint.j0.torque", "coulomb_friction @ joint.j1.torque",
                          "coulomb_friction @ joint.j2.torque", "coulomb_friction @ joint.j3.torque"));
}

TEST(MemberNames, SayWhatStandsWhere) {
  EffectEntry entry;
  entry.effect = "slope";
  EXPECT_EQ(member_name(entry), "slope @ world");
  entry.where = {"joint.hinge"};
  EXPECT_EQ(member_name(entry), "slope @ joint.hinge");
}

TEST(Places, AreThreeLengthsThatMayHaveEitherSign) {
  Hypothesis hypothesis;
  hypothesis.definition.free = {{{"effect.load.mass", "kg", 0.0, 9.0, 0.0, Scale::linear}, ""},
                                {{"effect.load.x", "m", -1.0, 1.0, 0.0, Scale::linear}, ""},
                                {{"effect.load.y", "m", -1.0, 1.0, 0.0, Scale::linear}, ""},
                                {{"effect.load.z", "m", -1.0, 1.0, 0.0, Scale::linear}, ""}};
  hypothesis.own = {0, 1, 2, 3};
  EXPECT_TRUE(has_place(hypothesis));
  hypothesis.definition.free[3].scale = Scale::logarithmic;
  EXPECT_FALSE(is_length(hypothesis.definition.free[3]));
  EXPECT_FALSE(has_place(hypothesis));
}

TEST(WithoutProbes, SaysThatTheEffectChangesNoPrediction) {
  Hypothesis hypothesis;
  hypothesis.entry.effect = "slope";
  const Untestable untestable = without_probes(hypothesis, "the joint's position is not finite");
  EXPECT_EQ(untestable.effect, "slope");
  EXPECT_EQ(untestable.where, "world");
  EXPECT_THAT(untestable.reason, testing::HasSubstr("changes the predictions"));
  EXPECT_FALSE(untestable.failed) << "no plugin is to blame";
}

/// The model as it is, and with friction and a spring.
class AugmentedModels : public CandidatesOfPendulum {
 protected:
  AugmentedModels()
      : plain_(plain(experiment_, built_catalog(), define_model(experiment_, built_catalog()).start_values())) {}

  AugmentedModel with_both() const {
    EffectEntry one = friction(), other = friction();
    one.id = "first";
    other.id = "second";
    other.effect = "joint_spring";
    AugmentedModel both = with_effects(plain_, {one, other}, {}, built_catalog());
    both.values = both.definition.start_values();
    for (std::size_t i = 0; i < both.values.size(); ++i)
      if (both.definition.free[i].address.starts_with("effect.second.")) both.values[i] = 0.125;
    return both;
  }

  AugmentedModel plain_;
};

TEST_F(AugmentedModels, HaveTheEffectsAndTheirValues) {
  const AugmentedModel both = with_both();
  EXPECT_EQ(both.added.size(), 2U);
  EXPECT_EQ(both.definition.structure.effects.size(), 2U);
  EXPECT_GT(both.definition.free.size(), plain_.definition.free.size());
  EXPECT_EQ(plain_.definition.structure.effects.size(), 0U);
}

TEST_F(AugmentedModels, LoseOneEffectAndKeepTheOthersValues) {
  const AugmentedModel both = with_both(), less = without(both, 0, plain_, built_catalog());
  ASSERT_EQ(less.added.size(), 1U);
  EXPECT_EQ(less.added[0].effect, "joint_spring");
  ASSERT_EQ(less.values.size(), less.definition.free.size());
  for (std::size_t i = 0; i < less.values.size(); ++i) {
    const std::string& address = less.definition.free[i].address;
    EXPECT_FALSE(address.starts_with("effect.first.")) << address;
    EXPECT_EQ(less.values[i], address.starts_with("effect.second.") ? 0.125 : plain_.values[i]) << address;
  }
}

}  // namespace
}  // namespace lacuna

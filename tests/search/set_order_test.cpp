#include "search/set_order.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr Eigen::Index kBlocks = 30;

std::vector<EffectEntry> entries(const std::vector<std::string>& effects) {
  std::vector<EffectEntry> added;
  for (const std::string& effect : effects) {
    EffectEntry entry;
    entry.effect = effect;
    entry.where = {"joint.hinge"};
    added.push_back(entry);
  }
  return added;
}

/// Sets of a model with one value, each fitted to all segments: what they cost, and how many values they have more.
class Sets {
 public:
  Sets() { add({}, 0.0, 0); }

  std::string add(const std::vector<std::string>& effects, double cost, std::size_t more, std::size_t untold = 0) {
    FittedSet set;
    set.model.added = entries(effects);
    set.model.values.assign(1 + more, 0.0);
    set.few.errors.valid = set.all.fit.errors.valid = true;
    set.few.errors.cost = set.all.cross.cost = cost;
    set.all.cross.told = static_cast<int>(1 + more - untold);
    set.all.cross.by_block = Eigen::VectorXd::Zero(kBlocks);
    std::string name = name_of_set(set.model.added);
    sets_[name] = std::move(set);
    return name;
  }

  FittedSet& at(const std::string& name) { return sets_.at(name); }
  SetOrder order() const { return {sets_, Segments::all}; }
  std::string first() const { return order().ordered().front(); }

 private:
  FittedSets sets_;
};

TEST(SetOrder, AValueMustEarnATenthOfWhatTheBestSetGains) {
  Sets sets;
  const std::string friction = sets.add({"coulomb_friction"}, -1.0, 1);
  const std::string both = sets.add({"coulomb_friction", "quadratic_drag"}, -1.09, 2);
  EXPECT_EQ(sets.first(), friction);
  sets.at(both).all.cross.cost = -1.15;
  EXPECT_EQ(sets.first(), both);
}

TEST(SetOrder, AValueThatTheDataDoNotTellMustEarnATenthOfThat) {
  Sets sets;
  sets.add({"coulomb_friction"}, -1.0, 1);
  const std::string richer = sets.add({"stribeck_friction"}, -1.05, 3);
  EXPECT_NE(sets.first(), richer);
  sets.add({"stribeck_friction"}, -1.05, 3, 2);
  EXPECT_EQ(sets.first(), richer);
}

TEST(SetOrder, LeavesOutSetsWithMoreValuesThanTheDataTell) {
  Sets sets;
  const std::string most = sets.add({"cogging"}, -2.0, 12);
  const std::string few = sets.add({"coulomb_friction"}, -1.0, 1);
  EXPECT_EQ(sets.first(), few);
  EXPECT_EQ(sets.order().best_among({most}, 1).size(), 0U);
}

TEST(SetOrder, OfSetsThatCostTheSameOneStands) {
  Sets sets;
  sets.add({"coulomb_friction"}, -1.0, 1);
  sets.add({"hysteresis"}, -1.0, 1);
  EXPECT_EQ(sets.order().best_of(1, 9).size(), 1U);
}

TEST(SetOrder, TheModelAsItIsComesFirstWhereNothingLowersTheCost) {
  Sets sets;
  sets.add({"coulomb_friction"}, 0.01, 1);
  EXPECT_EQ(sets.first(), "");
  EXPECT_EQ(sets.order().largest_gain(), 0.0);
}

TEST(DoesTheSame, OneOtherEffectThatCostsNoMore) {
  Sets sets;
  const std::string answer = sets.add({"coulomb_friction", "quadratic_drag"}, -1.0, 2);
  const std::string same = sets.add({"coulomb_friction", "linear_drag"}, -0.995, 2);
  const std::string worse = sets.add({"coulomb_friction", "cogging"}, -0.9, 2);
  const std::string fewer = sets.add({"coulomb_friction"}, -1.0, 1);
  const std::string other = sets.add({"hysteresis", "cogging"}, -1.0, 2);
  EXPECT_TRUE(does_the_same(sets.at(same), sets.at(answer)));
  for (const std::string& name : {worse, fewer, other, answer})
    EXPECT_FALSE(does_the_same(sets.at(name), sets.at(answer))) << name;
}

}  // namespace
}  // namespace lacuna

#include "search/spread.h"

#include "search/recorded_arm.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using Members = std::set<std::string>;

std::string friction_at(const std::string& place) { return "coulomb_friction @ " + place; }

/// An arm with this dry friction, N·m by joint, for which a search has named friction at one place.
class NamedFriction {
 public:
  NamedFriction(const std::vector<double>& friction, const std::string& place)
      : arm_(friction, friction.size() > 3 ? 1.5 : 3.0) {
    models_.fit({}, std::vector<NamedValues>(1));
    const AugmentedModel& plain = arm_.data().plain();
    look_.hypotheses =
        list_hypotheses(plain.experiment, built_catalog(), plain.definition, {"coulomb_friction"}, look_.untestable);
    EffectEntry entry;
    entry.effect = "coulomb_friction";
    entry.where = {place};
    NamedValues start;
    for (const EffectEntry& placed : placed_entries(entry, plain.definition.structure.robot))
      start[member_name(placed) + ".torque"] = 0.01;
    answer_ = models_.fit({entry}, {start});
  }

  std::optional<FittedModel> spread() {
    const double gain = models_.base().judged.cost.cost - answer_->judged.cost.cost;
    return spread_over_places(models_, look_, FittedModel(*answer_), gain);
  }
  const FittedModel& answer() const { return *answer_; }

 private:
  const ArmData arm_;
  KeptFits kept_;
  FittedModels models_{arm_.data(), arm_.data().deciding(), kept_};
  EffectLook look_;
  const FittedModel* answer_ = nullptr;
};

/// The dry friction of a joint, N·m.
double torque_at(const FittedModel& model, const std::string& place) {
  return model.values.at(friction_at(place) + ".torque");
}

TEST(Spread, OfAllJointsBecomesOneForEach) {
  NamedFriction arm({0.09, 0.03}, "joint.*");
  const std::optional<FittedModel> spread = arm.spread();
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->judged.members, (Members{friction_at("joint.j1"), friction_at("joint.j2")}));
  EXPECT_NEAR(torque_at(*spread, "joint.j1"), 0.09, 0.009);
  EXPECT_NEAR(torque_at(*spread, "joint.j2"), 0.03, 0.003);
  EXPECT_LT(spread->judged.cost.cost, arm.answer().judged.cost.cost);
}

TEST(Spread, OfAllJointsIsOfTheOneThatHasIt) {
  const std::optional<FittedModel> spread = NamedFriction({0.0, 0.05}, "joint.*").spread();
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->judged.members, Members{friction_at("joint.j2")});
  EXPECT_NEAR(torque_at(*spread, "joint.j2"), 0.05, 0.005);
}

TEST(Spread, OfOneJointGoesToTheOtherThatHasItToo) {
  const std::optional<FittedModel> spread = NamedFriction({0.09, 0.03}, "joint.j1").spread();
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->judged.members, (Members{friction_at("joint.j1"), friction_at("joint.j2")}));
}

TEST(Spread, IsNothingWhereOneJointAloneHasIt) { EXPECT_FALSE(NamedFriction({0.09, 0.0}, "joint.j1").spread()); }

TEST(Spread, IsNothingWhereOneValueForAllJointsIsEnough) {
  EXPECT_FALSE(NamedFriction({0.05, 0.05}, "joint.*").spread());
}

/// On more than three joints the effect has a value for each from the beginning.
TEST(Spread, OfManyJointsLeavesOutThoseWithout) {
  const std::optional<FittedModel> spread = NamedFriction({0.09, 0.06, 0.0, 0.03}, "joint.*").spread();
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->judged.members,
            (Members{friction_at("joint.j1"), friction_at("joint.j2"), friction_at("joint.j4")}));
}

TEST(Spread, OfManyJointsThatAllHaveItStaysAsItIs) {
  EXPECT_FALSE(NamedFriction({0.09, 0.06, 0.04, 0.03}, "joint.*").spread());
}

}  // namespace
}  // namespace lacuna

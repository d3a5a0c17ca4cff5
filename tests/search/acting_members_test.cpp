#include "search/acting_members.h"

#include "search/recorded_arm.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr const char* kOnFirst = "coulomb_friction @ joint.j1";
constexpr const char* kOnSecond = "coulomb_friction @ joint.j2";

EffectEntry friction_on(const std::string& place) {
  EffectEntry entry;
  entry.effect = "coulomb_friction";
  entry.where = {place};
  return entry;
}

/// Dry friction fitted to both joints of an arm whose first joint alone has some.
class ActingMembers : public testing::Test {
 protected:
  ActingMembers() {
    const AugmentedModel& plain = arm_.data().plain();
    models_.fit({}, std::vector<NamedValues>(1));
    look_.hypotheses =
        list_hypotheses(plain.experiment, built_catalog(), plain.definition, {"coulomb_friction"}, look_.untestable);
    both_ = models_.fit({friction_on("joint.j1"), friction_on("joint.j2")},
                        {{{std::string(kOnFirst) + ".torque", 0.05}, {std::string(kOnSecond) + ".torque", 0.01}}});
  }

  const CellLayout& layout() const { return models_.ladder().layout; }

  const ArmData arm_{{0.09, 0.0}};
  KeptFits kept_;
  FittedModels models_{arm_.data(), arm_.data().deciding(), kept_};
  EffectLook look_;
  const FittedModel* both_ = nullptr;
};

TEST_F(ActingMembers, AreThoseWhoseIntervalExcludesNoEffect) {
  ASSERT_NE(both_, nullptr);
  EXPECT_TRUE(acts(friction_on("joint.j1"), *both_, layout(), look_));
  EXPECT_FALSE(acts(friction_on("joint.j2"), *both_, layout(), look_));
  EXPECT_EQ(idle_members(*both_, layout(), look_), std::set<std::string>{kOnSecond});
}

/// Both at the value at which they do nothing.
TEST_F(ActingMembers, AreNoneAtTheValuesWithoutEffect) {
  ASSERT_NE(both_, nullptr);
  FittedModel still = *both_;
  still.fit.point.values.setZero();
  EXPECT_EQ(idle_members(still, layout(), look_), (std::set<std::string>{kOnFirst, kOnSecond}));
}

}  // namespace
}  // namespace lacuna

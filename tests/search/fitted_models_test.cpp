#include "search/fitted_models.h"

#include "residual_law/pendulum_data.h"
#include "search/nesting.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace lacuna {
namespace {

constexpr double kDry = 0.04;           // N·m, of the recordings
constexpr double kCarriedOver = 1e-12;  // relative, of a value that is carried over
const std::vector<NamedValues> kAsItIs(1);
const std::string kTorque = "coulomb_friction @ joint.hinge.torque";

/// "effect" on the hinge or on the arm.
std::vector<EffectEntry> set_of(const std::string& effect, const std::string& where = "joint.hinge") {
  EffectEntry entry;
  entry.id = entry.effect = effect;
  entry.where = {where};
  return {entry};
}

/// A start with this dry friction.
std::vector<NamedValues> friction_of(double torque) { return {{{kTorque, torque}}}; }

/// Sets beside the pendulum that has dry friction, on the lengths that decide.
class FittedModelsTest : public testing::Test {
 protected:
  FittedModelsTest() { models_.fit({}, kAsItIs); }

  const FittedModel* fit_friction(double from = 0.01) { return models_.fit(kFriction, friction_of(from)); }

  const std::vector<EffectEntry> kFriction = set_of("coulomb_friction");
  const PendulumData pendulum_{two_recordings({.damping = 0.02, .friction = kDry})};
  KeptFits kept_;
  FittedModels models_{pendulum_.data(), pendulum_.data().deciding(), kept_};
};

TEST_F(FittedModelsTest, FindTheFrictionOfTheRecordings) {
  const double before = models_.base().judged.cost.cost;
  const FittedModel* friction = fit_friction();
  ASSERT_TRUE(friction);
  EXPECT_NEAR(friction->values.at(kTorque), kDry, 0.1 * kDry);
  EXPECT_LT(friction->judged.cost.cost, before);
  EXPECT_EQ(friction->judged.members, std::set<std::string>{"coulomb_friction @ joint.hinge"});
  EXPECT_EQ(friction->judged.told, 1);
  EXPECT_EQ(friction->judged.values, 1);
  EXPECT_EQ(models_.find(friction->judged.members), friction);
}

TEST_F(FittedModelsTest, RefineASetToNoHigherCostThanThatOfThePartFromWhichItBegins) {
  const FittedModel part = *fit_friction();
  std::vector<EffectEntry> both = kFriction;
  both.push_back(set_of("joint_offset_torque").front());
  const FittedModel* set = models_.refine(both, part.values);
  ASSERT_TRUE(set);
  EXPECT_LE(set->fit.cost, part.fit.cost + kNested);
  EXPECT_LE(part.fit.cost, models_.base().fit.cost + kNested);
}

/// With 5 N·m the pendulum sticks, whatever else it has.
TEST_F(FittedModelsTest, TakeTheCheapestOfSeveralStarts) {
  const FittedModel* friction = models_.fit(kFriction, {{{kTorque, 5.0}}, {{kTorque, 0.01}}});
  ASSERT_TRUE(friction);
  EXPECT_NEAR(friction->values.at(kTorque), kDry, 0.1 * kDry);
}

TEST_F(FittedModelsTest, KeepTheCheaperOfTwoFitsOfASet) {
  const FittedModel first = *fit_friction();
  const FittedModel* again = models_.refine(kFriction, friction_of(5.0).front());
  ASSERT_TRUE(again);
  EXPECT_EQ(again->fit.cost, first.fit.cost);
  EXPECT_EQ(again->values, first.values);
}

/// From acceleration steps, in which no error grows, the fit finds its way where a stuck pendulum shows none.
TEST_F(FittedModelsTest, BeginFromAccelerationStepsWhereTheStartsAreWorse) {
  const FittedModel* friction = models_.fit(kFriction, friction_of(5.0), friction_of(1e-3));
  ASSERT_TRUE(friction);
  EXPECT_NEAR(friction->values.at(kTorque), kDry, 0.1 * kDry);
}

TEST_F(FittedModelsTest, LeaveOutASetThatGainsTooSmallAShareOfTheBest) {
  ASSERT_TRUE(fit_friction());
  const std::vector<EffectEntry> offset = set_of("joint_offset_torque");
  EXPECT_FALSE(models_.fit(offset, kAsItIs, {}, 0.5));
  EXPECT_FALSE(models_.find(members_of(offset)));
  EXPECT_TRUE(models_.fit(offset, kAsItIs)) << "where any share is enough";
}

TEST_F(FittedModelsTest, RestoreAKeptFitToTheSameCostWithoutAFurtherFit) {
  const FittedModel friction = *fit_friction();
  EXPECT_THAT(kept_, testing::Contains(testing::Key("3 lengths: coulomb_friction @ joint.hinge")));
  const PendulumData later(pendulum_.trials(), {.known = &kept_});
  KeptFits kept_later;
  FittedModels models(later.data(), later.data().deciding(), kept_later);
  models.fit({}, kAsItIs);
  const int fits = models.fits();
  const FittedModel* restored = models.fit(kFriction, friction_of(5.0));
  ASSERT_TRUE(restored);
  EXPECT_EQ(models.fits(), fits);
  EXPECT_NEAR(restored->fit.cost, friction.fit.cost, 0.1 * kNested);
  for (const auto& [name, value] : friction.values)
    EXPECT_NEAR(restored->values.at(name), value, kCarriedOver * std::abs(value)) << name;
}

/// Its initial states belong to other stretches.
TEST_F(FittedModelsTest, FitAnewWhereTheKeptFitIsOfOtherStretches) {
  fit_friction();
  KeptFits other = kept_;
  for (auto& [name, fit] : other) fit.starts.pop_back();
  const PendulumData later(pendulum_.trials(), {.known = &other});
  FittedModels models(later.data(), later.data().deciding(), kept_);
  models.fit({}, kAsItIs);
  const int fits = models.fits();
  EXPECT_TRUE(models.fit(kFriction, friction_of(0.01)));
  EXPECT_GT(models.fits(), fits);
}

/// Eight readings for each value: 31 are too few for four values.
TEST(FittedModels, FitNoMoreValuesThanTheReadingsTell) {
  const PendulumData pendulum({recorded({.inertia = kModelInertia, .friction = kDry}, "one.csv", multisine, 0.3, 3)});
  KeptFits kept;
  FittedModels models(pendulum.data(), pendulum.data().deciding(), kept);
  EXPECT_TRUE(models.fit({}, kAsItIs));
  EXPECT_FALSE(models.fit(set_of("coulomb_friction"), friction_of(0.01)));
}

/// The pendulum is damped more than its model may be, and a drag does the rest. Readings tell the product of its area
/// and density alone, so the density goes back to that of the file, and the area takes over its factor.
TEST(FittedModels, HoldOneOfTwoRedundantValuesAndKeepTheirProduct) {
  constexpr double kDensity = 1.2;  // kg/m³, of the effect's declaration
  const std::string drag = "quadratic_drag @ body.arm";
  std::vector<double> products, densities;  // of each fit
  const auto note = [&](const KeptFits& kept) {
    const auto found = kept.find("3 lengths: " + drag);
    if (found == kept.end()) return;
    const NamedValues& values = found->second.values;
    const auto density = values.find(drag + ".density");
    densities.push_back(density == values.end() ? kDensity : density->second);
    products.push_back(values.at(drag + ".area") * densities.back());
  };
  const PendulumData pendulum(two_recordings({.damping = 0.22}), {.keep = note});
  KeptFits kept;
  FittedModels models(pendulum.data(), pendulum.data().deciding(), kept);
  models.fit({}, kAsItIs);
  const FittedModel* found = models.fit(set_of("quadratic_drag", "body.arm"), {{{drag + ".area", 5.0}}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->model.added.front().fixed, std::vector<std::string>{"density"});
  EXPECT_FALSE(found->values.contains(drag + ".density"));
  EXPECT_EQ(found->judged.values, 1);
  ASSERT_GE(products.size(), 2U) << "with the density, and without";
  EXPECT_GT(std::abs(densities.front() - kDensity), 0.1 * kDensity);
  EXPECT_NEAR(products.back(), products.front(), 0.03 * products.front());
}

TEST(NamedValuesOf, NameTheMemberOfAnEffectsValueAndTheTimingLast) {
  AugmentedModel model;
  model.placed = set_of("coulomb_friction");
  model.definition.free = {{{"joint.hinge.damping", "N*m*s/rad", 0.0, 1.0, 0.1}},
                           {{"effect.coulomb_friction.torque", "N*m", 0.0, 1.0, 0.0}}};
  EXPECT_EQ(named_values(model, {0.2, 0.3}), (NamedValues{{"joint.hinge.damping", 0.2}, {kTorque, 0.3}}));
  EXPECT_EQ(named_values(model, {0.2, 0.3, -0.4}),
            (NamedValues{{"joint.hinge.damping", 0.2}, {kTorque, 0.3}, {"timing", -0.4}}));
}

}  // namespace
}  // namespace lacuna

#include "answer/fitted_values.h"

#include "answer/found_pendulum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lacuna {
namespace {

const FoundParameter& named(const std::vector<FoundParameter>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const FoundParameter& one) { return one.name == name; });
}

/// Four standard errors to either side.
void expect_told(const FoundParameter& parameter, double truth) {
  const double error = (parameter.upper_95 - parameter.lower_95) / 3.92;
  EXPECT_GT(error, 0.0) << parameter.name;
  EXPECT_NEAR(parameter.value, truth, 4.0 * error) << parameter.name;
  EXPECT_LT(error, 0.2 * truth) << parameter.name;
}

TEST(FittedValuesTest, AreTheModelsOwnWithIntervalsAboutTheTruth) {
  const FoundPendulum pendulum(two_recordings({.damping = 0.02}));
  const std::vector<FoundParameter> own = FittedValues(pendulum.found, pendulum.found.sets[0]).own();
  ASSERT_EQ(own.size(), 3U);
  expect_told(named(own, "body.arm.mass"), 0.5);
  expect_told(named(own, "joint.hinge.damping"), 0.02);
  EXPECT_EQ(named(own, "joint.hinge.damping").unit, "N*m*s/rad");
  EXPECT_FALSE(named(own, "joint.hinge.damping").at_bound);
}

/// The model's damping ends at 0.2 N·m·s/rad.
TEST(FittedValuesTest, HaveNoIntervalAtABound) {
  const FoundPendulum pendulum(two_recordings({.damping = 0.4}));
  const FittedValues values(pendulum.found, pendulum.found.sets[0]);
  const FoundParameter damping = named(values.own(), "joint.hinge.damping");
  EXPECT_EQ(damping.value, 0.2);
  EXPECT_TRUE(damping.at_bound);
  EXPECT_TRUE(std::isnan(damping.lower_95));
  EXPECT_TRUE(std::isnan(damping.upper_95));
  const std::vector<FreeValue>& free = pendulum.data.data().plain().definition.free;
  const auto at = std::find_if(free.begin(), free.end(),
                               [](const FreeValue& one) { return one.address == "joint.hinge.damping"; }) -
                  free.begin();
  EXPECT_TRUE(values.covariance().row(at).isZero());
}

TEST(FittedValuesTest, AreThoseOfTheAddedEffectBesideTheModels) {
  constexpr double kFriction = 0.05;  // N·m
  const FoundPendulum pendulum(two_recordings({.damping = 0.02, .friction = kFriction}), {"coulomb_friction"});
  const FittedValues values(pendulum.found, pendulum.found.sets[1]);
  ASSERT_EQ(values.effects().size(), 1U);
  const FoundEffect friction = values.effects()[0];
  EXPECT_EQ(friction.effect, "coulomb_friction");
  EXPECT_EQ(friction.where, "joint.hinge");
  const FoundParameter torque = named(friction.parameters, "torque");
  EXPECT_EQ(torque.unit, "N*m");
  EXPECT_NEAR(torque.value, kFriction, 0.1 * kFriction);
  EXPECT_LT(torque.lower_95, torque.value);
  EXPECT_GT(torque.upper_95, torque.value);
  EXPECT_EQ(values.own().size(), 3U) << "the effect's is not the model's own";
  EXPECT_EQ(values.values().size(), 3U + friction.parameters.size());
}

/// Commands are held from sample to sample as recorded: half an interval would be seen.
TEST(FittedValuesTest, SayWhenTheCommandsAct) {
  const FoundPendulum pendulum(two_recordings({.damping = 0.02}));
  const FittedValues values(pendulum.found, pendulum.found.sets[0]);
  ASSERT_TRUE(values.timing());
  EXPECT_NEAR(*values.timing(), 0.0, 0.1);
  const auto free = static_cast<Eigen::Index>(pendulum.data.data().plain().definition.free.size());
  EXPECT_EQ(values.covariance().rows(), free + 1) << "the offset last";
}

TEST(FittedValuesTest, DoNotKnowWhenCommandsActWhereThereAreNone) {
  std::vector<Trial> trials;
  for (const double angle : {1.0, -1.5})
    trials.push_back(recorded({.inertia = kModelInertia, .damping = 0.02}, "swing.csv", [](double) { return 0.0; }, 3.0,
                              1, {.angle = angle}));
  for (Trial& trial : trials) trial.commands = {};
  const FoundPendulum pendulum(trials);
  const FittedValues values(pendulum.found, pendulum.found.sets[0]);
  EXPECT_FALSE(values.timing());
  EXPECT_FALSE(values.timing_is_told());
}

}  // namespace
}  // namespace lacuna

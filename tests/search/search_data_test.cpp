#include "search/search_data.h"

#include "residual_law/pendulum_data.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

std::vector<Trial> with_held_out() {
  std::vector<Trial> trials = two_recordings({.damping = 0.02});
  trials.push_back(recorded({.inertia = kModelInertia}, "held.csv", sine, 3.0, 5));
  trials.back().held_out = true;
  return trials;
}

TEST(SearchDataTest, CountsTheReadingsThatAreFitted) {
  std::vector<Trial> trials = with_held_out();
  trials[0].measured.samples(7, 0) = std::nan("");
  const PendulumData pendulum(trials);
  EXPECT_EQ(pendulum.data().readings(), 601.0) << "301 of either recording, one of which is missing";
  EXPECT_TRUE(pendulum.data().tells(75.0));
  EXPECT_FALSE(pendulum.data().tells(76.0)) << "eight readings for each value";
}

TEST(SearchDataTest, DecidesByTheThreeShortestOfFiveLengths) {
  const PendulumData pendulum(two_recordings({.damping = 0.02}));
  const PredictionLadder &all = pendulum.data().ladder(), &deciding = pendulum.data().deciding();
  ASSERT_EQ(all.lengths.size(), 5U);
  ASSERT_EQ(deciding.lengths.size(), 3U);
  EXPECT_EQ(deciding.lengths[2], all.lengths[2]);
  double weight = 0.0;
  for (const Cell& cell : deciding.layout.cells) weight += cell.weight;
  EXPECT_NEAR(weight, 1.0, 1e-12);
}

TEST(SearchDataTest, ReadsHeldOutRecordingsApart) {
  const PendulumData pendulum(with_held_out());
  for (const PredictedStretch& one : pendulum.data().ladder().stretches) EXPECT_NE(one.stretch.trial, 2U);
  const PredictionLadder held_out = pendulum.data().held_out();
  ASSERT_FALSE(held_out.stretches.empty());
  for (const PredictedStretch& one : held_out.stretches) EXPECT_EQ(one.stretch.trial, 2U);
  EXPECT_EQ(held_out.lengths, pendulum.data().ladder().lengths);
}

TEST(SearchDataTest, HasNoHeldOutStretchesWhereNothingIsHeldOut) {
  EXPECT_TRUE(PendulumData(two_recordings({})).data().held_out().stretches.empty());
}

TEST(SearchDataTest, FitsWhenCommandsActWhereThereAreCommands) {
  EXPECT_TRUE(PendulumData(two_recordings({})).data().timing());
  std::vector<Trial> free = {
      recorded({.inertia = kModelInertia}, "free.csv", [](double) { return 0.0; }, 3.0, 1, {.angle = 1.0})};
  free[0].commands = {};
  EXPECT_FALSE(PendulumData(free).data().timing());
}

TEST(SearchDataTest, RefusesRecordingsThatAreTooShort) {
  const std::vector<Trial> trials = {recorded({.inertia = kModelInertia}, "blink.csv", sine, 0.01, 1)};
  EXPECT_THROW(PendulumData pendulum(trials), Error);
}

TEST(ChangesReadings, IsTrueOfEffectsAndFreeValuesOfSensors) {
  ModelDefinition definition;
  EXPECT_FALSE(changes_readings(definition));
  definition.free = {{{"joint.hinge.damping", "N*m*s/rad", 0.0, 1.0, 0.1}}};
  EXPECT_FALSE(changes_readings(definition));
  ModelDefinition of_value = definition, of_effect = definition;
  of_value.free.push_back({{"sensor.angle.offset", "rad", -1.0, 1.0, 0.0}});
  EXPECT_TRUE(changes_readings(of_value));
  EffectEntry entry;
  entry.where = {"joint.hinge"};
  of_effect.effects = {entry};
  EXPECT_FALSE(changes_readings(of_effect));
  entry.where = {"sensor.angle"};
  of_effect.effects.push_back(entry);
  EXPECT_TRUE(changes_readings(of_effect));
}

TEST(ModelContextTest, HasTheOffsetOfTheCommandsAsItsLastValue) {
  const PendulumData pendulum(two_recordings({}));
  const ModelContext context = pendulum.data().bench_for(pendulum.data().plain());
  const auto free = static_cast<Eigen::Index>(pendulum.data().plain().definition.free.size());
  ASSERT_EQ(context.space().size(), free + 1);
  EXPECT_EQ(context.space().lower()(free), -0.5);
  EXPECT_EQ(context.space().upper()(free), 0.0);
  EXPECT_TRUE(context.predictor().fits_timing());
}

}  // namespace
}  // namespace lacuna

#include "where_it_fails/state_features.h"

#include "where_it_fails/wheel_rig.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

double nothing_missing(double, double, double) { return 0.0; }

FeatureTable features_of(const Rig& rig, std::size_t rows = 6000) {
  return state_features({rig.definition, *rig.model, rig.trials, {}, rig.comparison}, rows);
}

std::vector<std::string> names_of(const FeatureTable& table) {
  std::vector<std::string> names;
  for (const StateFeature& feature : table.features) names.push_back(feature.full_name());
  return names;
}

Eigen::VectorXd column_of(const FeatureTable& table, FeatureKind kind) {
  for (std::size_t f = 0; f < table.features.size(); ++f)
    if (table.features[f].kind == kind) return table.values.col(static_cast<Eigen::Index>(f));
  return {};
}

/// rad/s, of the wheel with its 1 kg·m² under the commands.
double speed_at(double t) {
  return 1.5 * std::sin(2.0 * t) + 2.0 / 5.1 * (std::sin(5.1 * t + 0.4) - std::sin(0.4)) +
         1.5 / 3.3 * std::sin(3.3 * t);
}

/// The load is the motor's torque, which repeats the command from the second sample on.
TEST(StateFeatures, AreThoseOfJointsCommandsAndTimeWithoutRepetitions) {
  Rig rig = rig_lacking(nothing_missing);
  rig.comparison.trials[0].first_scored = 1;
  const FeatureTable table = features_of(rig);
  EXPECT_THAT(names_of(table),
              testing::ElementsAre("position", "velocity", "|velocity|", "direction of motion",
                                   "time since the last reversal", "command", "time", "accumulated work"));
  EXPECT_EQ(table.values.cols(), 8);
  EXPECT_TRUE(table.values.allFinite());
}

/// Commands are held for 4 ms, which moves the velocity by up to 0.02 rad/s.
TEST(StateFeatures, AreTheStateOfAModelThatFollows) {
  const FeatureTable table = features_of(rig_lacking(nothing_missing));
  const Eigen::VectorXd times = column_of(table, FeatureKind::time);
  const Eigen::VectorXd velocity = column_of(table, FeatureKind::velocity);
  ASSERT_EQ(times.size(), kReadings);
  for (Eigen::Index i = 0; i < times.size(); i += 50) EXPECT_NEAR(velocity(i), speed_at(times(i)), 0.03) << times(i);
}

/// The wheel is 10 rad/s faster than its model in the end.
TEST(StateFeatures, AreMeasuredWhereTheModelDoesNotFollow) {
  const FeatureTable table = features_of(rig_lacking([](double, double, double) { return 1.0; }));
  const Eigen::VectorXd times = column_of(table, FeatureKind::time);
  const Eigen::VectorXd velocity = column_of(table, FeatureKind::velocity);
  for (Eigen::Index i = 50; i < times.size(); i += 50)
    EXPECT_NEAR(velocity(i), speed_at(times(i)) + times(i), 0.15) << times(i);
}

TEST(StateFeatures, KnowTheDirectionOfMotionAndTheCommand) {
  const FeatureTable table = features_of(rig_lacking(nothing_missing));
  const Eigen::VectorXd times = column_of(table, FeatureKind::time);
  const Eigen::VectorXd direction = column_of(table, FeatureKind::direction);
  const Eigen::VectorXd command = column_of(table, FeatureKind::command);
  for (Eigen::Index i = 0; i < times.size(); i += 50) {
    EXPECT_NEAR(command(i), command_at(times(i)), 1e-9);
    const double speed = speed_at(times(i));
    if (std::abs(speed) < 0.3) continue;
    EXPECT_EQ(direction(i), std::copysign(1.0, speed));
  }
}

TEST(StateFeatures, ComeFromAtMostSoManySamplesEvenlySpaced) {
  const FeatureTable table = features_of(rig_lacking(nothing_missing), 500);
  ASSERT_EQ(table.sample.size(), 500U);
  for (std::size_t i = 0; i < table.sample.size(); ++i) EXPECT_EQ(table.sample[i], static_cast<Eigen::Index>(5 * i));
}

TEST(StateFeatures, ComeFromTheScoredTimeAlone) {
  Rig rig = rig_lacking(nothing_missing);
  rig.comparison.trials[0].first_scored = 13;
  EXPECT_EQ(features_of(rig).sample.front(), 13);
}

TEST(StateFeatures, HaveNoRowsOfTrialsThatDoNotCount) {
  Rig held_out = rig_lacking(nothing_missing), failed = rig_lacking(nothing_missing),
      without_floor = rig_lacking(nothing_missing);
  held_out.comparison.trials[0].held_out = true;
  failed.comparison.trials[0].valid = false;
  without_floor.comparison.trials[0].channels[0].floor = std::nan("");
  EXPECT_TRUE(features_of(held_out).trial.empty());
  EXPECT_TRUE(features_of(failed).trial.empty());
  EXPECT_TRUE(features_of(without_floor).trial.empty());
}

}  // namespace
}  // namespace lacuna

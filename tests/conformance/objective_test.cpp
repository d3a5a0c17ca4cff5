#include "conformance/every_plugin.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

/// What holds for every objective metric.
namespace lacuna {
namespace {

constexpr double kNanOfObjective = std::numeric_limits<double>::quiet_NaN();

class ObjectiveConformance : public testing::Test {
 protected:
  ObjectiveConformance() {
    space_.free = {{"body.torso.mass", "kg", 1.0, 7.0, 2.0, Scale::linear},
                   {"body.leg.mass", "kg", 1.0, 7.0, 2.0, Scale::linear},
                   {"contact.friction", "1", 0.0, 2.0, 1.0, Scale::linear},
                   {"sensor.t1.delay", "s", 0.0, 0.2, 0.0, Scale::linear}};
    for (const char* name : {"torso", "leg"}) {
      BodySpec body;
      body.name = name;
      body.shapes = {{.kind = ShapeKind::cylinder, .size = {0.1, 1.0, 0.0}}};
      robot_.bodies.push_back(body);
    }
    robot_.joints.emplace_back().parent = "torso";
    robot_.joints.back().child = "leg";
    robot_.joints.back().anchor = {0.0, 0.0, 0.5};
  }
  HiddenTruth hidden(const std::vector<double>& values) const { return {values, robot_}; }
  /// Other values, and a robot whose leg is elsewhere.
  ModelProposal other() const {
    RobotSpec robot = robot_;
    robot.bodies[1].position.x() += 0.2;
    return {{3.0, 2.0, 1.0, 0.1}, std::make_shared<RobotSpec>(robot)};
  }

  RobotSpec robot_;
  ModelSpace space_{robot_, {}};
  const std::vector<double> truth_ = {2.5, 1.0, 0.8, 0.07};
};

TEST_F(ObjectiveConformance, TheTruthItselfHasNoError) {
  on_every<ObjectiveMetric>([&](const ObjectiveMetric& metric, const std::vector<double>& parameters) {
    const auto scores = metric.score(space_, {truth_}, hidden(truth_), parameters);
    EXPECT_FALSE(scores.empty());
    for (const ObjectiveScore& score : scores) EXPECT_EQ(score.value, 0.0) << score.name;
  });
}

TEST_F(ObjectiveConformance, AnotherModelHasSomeAndNoneBelowZero) {
  on_every<ObjectiveMetric>([&](const ObjectiveMetric& metric, const std::vector<double>& parameters) {
    double most = 0.0;
    std::set<std::string> names;
    for (const ObjectiveScore& score : metric.score(space_, other(), hidden(truth_), parameters)) {
      EXPECT_GE(score.value, 0.0) << score.name;
      EXPECT_FALSE(score.unit.empty()) << score.name;
      EXPECT_TRUE(names.insert(score.name).second) << score.name << " stands twice";
      most = std::max(most, score.value);
    }
    EXPECT_GT(most, 0.0);
  });
}

TEST_F(ObjectiveConformance, WhatTheTargetDoesNotHaveIsNoError) {
  const std::vector<double> partly = {2.5, kNanOfObjective, 0.8, kNanOfObjective};
  on_every<ObjectiveMetric>([&](const ObjectiveMetric& metric, const std::vector<double>& parameters) {
    for (const ObjectiveScore& score : metric.score(space_, {{2.5, 6.0, 0.8, 0.1}}, hidden(partly), parameters))
      EXPECT_EQ(score.value, 0.0) << score.name;
  });
}

TEST_F(ObjectiveConformance, ValuesOfEffectsThatTheModelDoesWithoutDoNotCount) {
  space_.free.push_back({"effect.grease.damping", "N*m*s/rad", 0.0, 2.0, 0.5, Scale::linear});
  space_.effects = {{"grease", true, {4}}};
  std::vector<double> truth = truth_;
  truth.push_back(kNanOfObjective);
  ModelProposal model{truth};
  model.without = {0};
  on_every<ObjectiveMetric>([&](const ObjectiveMetric& metric, const std::vector<double>& parameters) {
    const auto scores = metric.score(space_, model, hidden(truth), parameters);
    EXPECT_FALSE(scores.empty());
    for (const ObjectiveScore& score : scores) EXPECT_EQ(score.value, 0.0) << score.name;
  });
}

}  // namespace
}  // namespace lacuna

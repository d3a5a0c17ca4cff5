#include "diagnosis/recorded_pendulum.h"
#include "diagnosis/rounds/segment_lengths.h"

#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <limits>

namespace lacuna {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

FoundEffect effect(const std::string& name, const std::string& parameter, double value, double half) {
  return {name, "joint.hinge", {{parameter, "N*m", value, value - half, value + half}}};
}

/// Found over 0.5 s, then over 0.1 and over 3.2 s, where the deviance grows by `against` with the values found first.
LengthVerdict judged(const FoundEffect& found, const FoundEffect& shorter, const FoundEffect& longer,
                     double against = 100.0) {
  return judge_lengths({found}, 0.5, {{0.1, {shorter}, against}, {3.2, {longer}, against}}, built_catalog());
}

LengthVerdict judged_as(const std::string& name, const std::string& parameter, double value, double shorter,
                        double longer, double half = 0.001) {
  return judged(effect(name, parameter, value, half), effect(name, parameter, shorter, half),
                effect(name, parameter, longer, half));
}

TEST(SegmentLengths, AnEffectOfTheSameSizeSurvivesAndIsShownAtEachLength) {
  const LengthVerdict verdict = judged_as("coulomb_friction", "torque", 0.2, 0.18, 0.22);
  EXPECT_TRUE(verdict.survives);
  ASSERT_EQ(verdict.findings.size(), 1U);
  EXPECT_THAT(verdict.findings[0], testing::HasSubstr("torque 0.18 at 0.1 s, 0.2 at 0.5 s, 0.22 at 3.2 s (N*m)"));
}

TEST(SegmentLengths, OneOfAnotherSizeDoesNot) {
  const LengthVerdict verdict = judged_as("coulomb_friction", "torque", 0.2, 0.19, 0.05);
  EXPECT_FALSE(verdict.survives);
  EXPECT_THAT(verdict.findings.at(0), testing::HasSubstr("does not survive"));
}

TEST(SegmentLengths, OneOfAnotherSignDoesNot) {
  EXPECT_FALSE(judged_as("joint_offset_torque", "torque", 0.1, 0.1, -0.1).survives);
}

TEST(SegmentLengths, WhatIsNotToldAtOneLengthContradictsNothing) {
  FoundEffect wide = effect("coulomb_friction", "torque", 0.02, 0.3);
  EXPECT_TRUE(judged(effect("coulomb_friction", "torque", 0.2, 0.01), wide, wide).survives);
}

/// A size at its bound has no interval: an effect that vanishes does not survive.
TEST(SegmentLengths, OneThatVanishesDoesNot) {
  const FoundEffect gone{"coulomb_friction", "joint.hinge", {{"torque", "N*m", 0.0, kNone, kNone}}};
  EXPECT_FALSE(judged(effect("coulomb_friction", "torque", 0.2, 0.01), gone, gone).survives);
}

/// Over 0.1 s a small effect tells nothing, wherever its fit ends: 3.84 is what noise reaches in one of 20, of one
/// value.
TEST(SegmentLengths, OneThatVanishesWhereNothingTellsItContradictsNothing) {
  const FoundEffect gone{"coulomb_friction", "joint.hinge", {{"torque", "N*m", 0.0, kNone, kNone}}};
  const FoundEffect found = effect("coulomb_friction", "torque", 0.2, 0.01);
  EXPECT_TRUE(judged(found, gone, gone, 3.6).survives);
  EXPECT_FALSE(judged(found, gone, gone, 4.0).survives);
}

/// A gain is as large as its distance from 1.
TEST(SegmentLengths, SizeIsTheDistanceFromDoingNothing) {
  EXPECT_TRUE(judged_as("torque_gain", "gain", 1.10, 1.11, 1.09).survives);
  EXPECT_FALSE(judged_as("torque_gain", "gain", 1.10, 1.11, 1.01).survives);
}

/// Of a stiffness, which does nothing where it is infinite, it is the stiffness.
TEST(SegmentLengths, AStiffnessMustStayAsStiff) {
  EXPECT_TRUE(judged_as("joint_compliance", "stiffness", 1000.0, 1200.0, 900.0, 1.0).survives);
  EXPECT_FALSE(judged_as("joint_compliance", "stiffness", 1000.0, 1000.0, 100.0, 1.0).survives);
}

TEST(SegmentLengths, AShapeMayMove) {
  const auto stribeck = [](double velocity) {
    FoundEffect one = effect("stribeck_friction", "coulomb", 0.2, 0.01);
    one.parameters.push_back({"velocity", "rad/s", velocity, 0.99 * velocity, 1.01 * velocity});
    return one;
  };
  EXPECT_TRUE(judged(stribeck(0.05), stribeck(0.5), stribeck(0.01)).survives);
}

TEST(SegmentLengths, WithoutOtherLengthsNothingIsSaid) {
  const LengthVerdict verdict =
      judge_lengths({effect("coulomb_friction", "torque", 0.2, 0.01)}, 0.5, {}, built_catalog());
  EXPECT_TRUE(verdict.survives);
  EXPECT_TRUE(verdict.findings.empty());
}

/// Sampled every 4 ms, so that it ends a sample early.
Trial trial_of(const std::string& name, double seconds, bool held_out) {
  Trial trial;
  trial.name = name;
  trial.held_out = held_out;
  trial.measured.times = Eigen::VectorXd::LinSpaced(2, 0.0, seconds - 0.004);
  return trial;
}

TEST(SegmentLengths, OneLongerThanEveryFitTrialIsRefused) {
  const std::vector<Trial> trials = {trial_of("sine.csv", 4.0, false), trial_of("steps.csv", 2.0, false),
                                     trial_of("long.csv", 60.0, true)};
  EXPECT_NO_THROW(check_segment(4.0, trials));
  EXPECT_THAT([&] { check_segment(20.0, trials); },
              testing::ThrowsMessage<BadInput>("diagnosis.segment is 20.0 s, but no fit trial is that long: sine.csv "
                                               "4.00 s, steps.csv 2.00 s; choose at most 4.00 s"));
  EXPECT_NO_THROW(check_segment(0.0, {trial_of("short.csv", 0.3, false)}));  // nobody asked for a length
  EXPECT_THAT([&] { check_segment(0.02, trials); },
              testing::ThrowsMessage<BadInput>(
                  "diagnosis.segment is 20.0 ms; choose at least 50.0 ms, or 0 for the usual length"));
}

/// With steps so small that they do not show over 5 s.
double usual_length(RecordedPendulum rig) {
  rig.definition.engine.substeps = 100;
  rig.model = compile(rig.definition.structure, rig.definition.engine);
  return cut_trials({.definition = rig.definition, .model = *rig.model, .trials = rig.trials, .values = rig.values})
      .segment;
}

TEST(SegmentLengths, TheUsualOneIsAboutFiveSecondsOrTheLongestTrial) {
  EXPECT_DOUBLE_EQ(usual_length(RecordedPendulum{}), 6.0);  // trials of 6 s are not cut
  RecordedPendulum rig;
  rig.trials = {recorded({}, "short.csv", multisine, 2.0, 1)};
  EXPECT_DOUBLE_EQ(usual_length(std::move(rig)), 2.0);
}

/// A pendulum that is kept on its head by its motor: under the recorded commands what is uncertain of a start grows by
/// 500 a second.
TEST(SegmentLengths, TheUsualOneIsShorterWhereAStartIsSoonForgotten) {
  RecordedPendulum rig({.gravity = -0.981, .damping = 0.1, .feedback = 3.0});
  rig.definition.structure.robot.bodies.front().com = {0.0, 0.0, 0.2};
  const double length = usual_length(std::move(rig));
  EXPECT_GE(length, 1.0);
  EXPECT_LT(length, 2.5);
}

/// Dry friction of a fifth of the motor's torque that the model does not have.
TEST(SegmentLengths, TheUsualOneIsShortWhereTheModelLacksMuch) {
  EXPECT_LT(usual_length(RecordedPendulum({.friction = 0.05})), 2.5);
}

}  // namespace
}  // namespace lacuna

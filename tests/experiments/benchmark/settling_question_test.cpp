#include "runs/settling_question.h"

#include "experiments/benchmark/small_results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

DiagnosisRecord answered(const std::vector<EffectAt>& effects, const std::vector<EffectAt>& look_alikes) {
  DiagnosisRecord diagnosis = small_diagnosis(1, "effect_found", 0.9, effects, look_alikes);
  diagnosis.next_test = "triangle motor 0.3 N*m 0.1 Hz 20 s";
  return diagnosis;
}

const SettlingQuestion kOpen = {kCoulomb, kStribeck, {}};

TEST(SettlingQuestion, IsBetweenTheLastEffectAndItsClosestLookAlike) {
  const auto question = question_of(answered({kSpring, kCoulomb}, {kStribeck, {"hysteresis", "joint.hinge"}}));
  ASSERT_TRUE(question.has_value());
  EXPECT_EQ(question->answer, kCoulomb);
  EXPECT_EQ(question->rival, kStribeck);
  EXPECT_THAT(question->among, testing::ElementsAre("joint_spring", "coulomb_friction", "stribeck_friction"));
}

TEST(SettlingQuestion, IsNoneWithoutAFindingALookAlikeOrATest) {
  DiagnosisRecord other_verdict = answered({kCoulomb}, {kStribeck}), no_test = other_verdict;
  other_verdict.verdict = "not_in_library";
  no_test.next_test.clear();
  EXPECT_FALSE(question_of(other_verdict).has_value());
  EXPECT_FALSE(question_of(no_test).has_value());
  EXPECT_FALSE(question_of(answered({kCoulomb}, {})).has_value());
}

TEST(SettlingQuestion, IsSettledWhenOneIsNamedWithoutTheOther) {
  EXPECT_EQ(remaining(kOpen, answered({kCoulomb}, {})), kCoulomb);
  EXPECT_EQ(remaining(kOpen, answered({kStribeck}, {})), kStribeck);
  EXPECT_EQ(remaining(kOpen, answered({kSpring}, {kStribeck})), kStribeck);
}

TEST(SettlingQuestion, IsOpenWhenBothOrNeitherAreNamed) {
  EXPECT_EQ(remaining(kOpen, answered({kCoulomb}, {kStribeck})), EffectAt());
  EXPECT_EQ(remaining(kOpen, answered({kStribeck}, {kCoulomb})), EffectAt());
  EXPECT_EQ(remaining(kOpen, answered({kCoulomb, kStribeck}, {})), EffectAt());
  EXPECT_EQ(remaining(kOpen, answered({{"coulomb_friction", "joint.elbow"}}, {})), EffectAt());
  EXPECT_EQ(remaining(kOpen, small_diagnosis(1, "nothing_missing", 0.9, {kCoulomb})), EffectAt());
}

}  // namespace
}  // namespace hidden_effects

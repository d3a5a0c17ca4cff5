#include "figures/dirty_scores.h"

#include "experiments/benchmark/small_results.h"
#include "figures/dirty_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hidden_effects {
namespace {

using testing::HasSubstr;

const EffectAt kDrag{"quadratic_drag", "body.arm"};

DirtyEffectRecord dry(double share, bool library_form = true) {
  return {"smooth_dry_friction",
          kCoulomb,
          "main",
          library_form,
          share,
          {"coulomb_friction @ joint.hinge", "stribeck_friction @ joint.hinge"},
          {}};
}

DirtyEffectRecord drag(double share) {
  return {"quadratic_drag", kDrag, "main", true, share, {"quadratic_drag @ body.arm"}, {}};
}

CaseResult result_of(const std::vector<DirtyEffectRecord>& effects, const std::string& verdict,
                     const std::vector<EffectAt>& named = {}, const std::vector<EffectAt>& alike = {}) {
  CaseResult result = small_case(0, "free_pendulum", {}, 10.0);
  result.dirty = effects;
  result.diagnoses = {small_diagnosis(1, verdict, 0.95, named, alike)};
  return result;
}

TEST(DirtyScores, NamingAllThatIsNeededIsRight) {
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {kCoulomb})), DirtyGrade::right);
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {kStribeck})), DirtyGrade::right);
  EXPECT_EQ(grade_of(result_of({dry(0.5), drag(0.5)}, "effect_found", {kCoulomb, kDrag})), DirtyGrade::right);
}

TEST(DirtyScores, AnEffectOnAllJointsStandsOnEach) {
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {{"coulomb_friction", "joint.*"}})), DirtyGrade::right);
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {{"coulomb_friction", "joint.other"}})), DirtyGrade::wrong);
}

TEST(DirtyScores, ALookAlikeNamesAndExcusesItsStandIn) {
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {kSpring}, {kCoulomb})), DirtyGrade::right);
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {kDrag, kSpring}, {kCoulomb})), DirtyGrade::right);
}

TEST(DirtyScores, OneStrangerIsAllowedAndTwoAreNot) {
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {kCoulomb, kSpring})), DirtyGrade::right);
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "effect_found", {kCoulomb, kSpring, kDrag})), DirtyGrade::half);
  // What explains two per cent is no stranger.
  EXPECT_EQ(grade_of(result_of({dry(0.9), drag(0.03)}, "effect_found", {kCoulomb, kSpring, kDrag})), DirtyGrade::right);
}

TEST(DirtyScores, OneOfTwoIsHalf) {
  EXPECT_EQ(grade_of(result_of({dry(0.5), drag(0.5)}, "effect_found", {kCoulomb})), DirtyGrade::half);
  EXPECT_EQ(grade_of(result_of({dry(0.5), drag(0.5)}, "effect_found", {kSpring})), DirtyGrade::wrong);
}

TEST(DirtyScores, WhereNothingIsNeededNothingIsMissing) {
  EXPECT_EQ(grade_of(result_of({dry(0.1)}, "nothing_missing")), DirtyGrade::right);
  EXPECT_EQ(grade_of(result_of({dry(0.1)}, "effect_found", {kCoulomb})), DirtyGrade::wrong);
  CaseResult quiet = result_of({dry(0.9)}, "nothing_missing");
  quiet.about.strength = 0.5;  // of the noise: a share of nearly nothing
  EXPECT_EQ(grade_of(quiet), DirtyGrade::right);
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "nothing_missing")), DirtyGrade::wrong);
}

TEST(DirtyScores, VerdictsWithoutAnEffect) {
  EXPECT_EQ(grade_of(result_of({dry(0.9)}, "cannot_tell")), DirtyGrade::undecided);
  EXPECT_EQ(grade_of(result_of({}, "cannot_tell")), DirtyGrade::undecided);
  EXPECT_EQ(grade_of(result_of({dry(0.9, false)}, "not_in_library")), DirtyGrade::half);
  EXPECT_EQ(grade_of(result_of({dry(0.9, true)}, "not_in_library")), DirtyGrade::wrong);
  CaseResult failed = result_of({dry(0.9)}, "effect_found", {kCoulomb});
  failed.failure = "took longer than 5 s";
  EXPECT_EQ(grade_of(failed), DirtyGrade::failed);
}

TEST(DirtyScores, BrierIsBesideThatOfAConstant) {
  const std::vector<CaseResult> results = {result_of({dry(0.9)}, "effect_found", {kCoulomb}),
                                           result_of({dry(0.9)}, "effect_found", {kSpring})};
  const BrierScores scores = brier_of(results);
  EXPECT_EQ(scores.count, 2);
  EXPECT_NEAR(scores.stated, 0.5 * (0.05 * 0.05 + 0.95 * 0.95), 1e-12);
  EXPECT_NEAR(scores.constant, 0.25, 1e-12);
}

TEST(DirtyScores, TheConstantAnswerSaysTheCommonestEffect) {
  const std::vector<CaseResult> results = {result_of({dry(0.9)}, "cannot_tell"), result_of({dry(0.5), drag(0.5)}, ""),
                                           result_of({}, "")};
  EXPECT_EQ(commonest_effect(results), "coulomb_friction");
  EXPECT_EQ(grade_of_constant(results[0], "coulomb_friction"), DirtyGrade::right);
  EXPECT_EQ(grade_of_constant(results[1], "coulomb_friction"), DirtyGrade::half);
  EXPECT_EQ(grade_of_constant(results[2], "coulomb_friction"), DirtyGrade::wrong);
}

TEST(DirtyTable, CountsGradesAndListsCases) {
  const std::string text =
      dirty_tables({result_of({dry(0.9)}, "effect_found", {kCoulomb}), result_of({dry(0.9)}, "effect_found", {kSpring}),
                    result_of({dry(0.9)}, "cannot_tell")});
  EXPECT_THAT(text, HasSubstr("| all | 3 | 1 | 0 | 1 | 1 | 0 | 1 |"));
  EXPECT_THAT(text, HasSubstr("smooth_dry_friction @ joint.hinge 90 %"));
  EXPECT_THAT(text, HasSubstr("| joint_spring @ joint.hinge | 0.95 | wrong |"));
}

}  // namespace
}  // namespace hidden_effects

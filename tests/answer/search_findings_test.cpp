#include "answer/search_findings.h"

#include "answer/errors_by_length.h"
#include "answer/found_pendulum.h"

#include <gmock/gmock.h>

#include <cmath>

namespace lacuna {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Stopped by the time limit, which leaves the laws of the residual unasked.
SearchResult stopped(SearchResult found) {
  found.stopped = true;
  return found;
}

const FoundPendulum& with_friction() {
  static const FoundPendulum one(two_recordings({.damping = 0.02, .friction = 0.05}),
                                 {"coulomb_friction", "joint_spring"});
  return one;
}

TEST(SearchFindings, NameTheAnswerFirstWithItsGainAndErrors) {
  const SearchResult found = stopped(with_friction().decided(1));
  const Diagnosis diagnosis = findings_of(found);
  EXPECT_EQ(diagnosis.verdict, Verdict::effect_found);
  ASSERT_EQ(diagnosis.ranking.size(), 2U);
  const RankedModel& answer = diagnosis.ranking[0];
  EXPECT_EQ(answer.effects[0].effect, "coulomb_friction");
  EXPECT_EQ(answer.gain.value, found.decision.gain.nats);
  EXPECT_NEAR(answer.gain.upper_95 - answer.gain.value, 1.96 * found.decision.gain.error, 1e-3);
  EXPECT_EQ(diagnosis.answer_gain, answer.gain);
  EXPECT_NEAR(answer.times_floor, 1.0, 0.2);
  EXPECT_GT(diagnosis.base_times_floor, 3.0);
  EXPECT_EQ(diagnosis.p_by_chance, 0.001);
  EXPECT_TRUE(std::isnan(diagnosis.probability)) << "that is the calibration's";
}

/// The answer comes before a set that gains more: it has fewer values.
TEST(SearchFindings, RankTheOtherSetsByTheirGain) {
  SearchResult found = stopped(with_friction().decided(2));
  const Diagnosis diagnosis = findings_of(found);
  ASSERT_EQ(diagnosis.ranking.size(), 2U);
  EXPECT_EQ(diagnosis.ranking[0].effects[0].effect, "joint_spring");
  EXPECT_EQ(diagnosis.ranking[1].effects[0].effect, "coulomb_friction");
  EXPECT_GT(diagnosis.ranking[1].gain.value, diagnosis.ranking[0].gain.value);
}

TEST(SearchFindings, NameLookAlikes) {
  SearchResult found = stopped(with_friction().decided(1));
  found.decision.alike = {2};
  EXPECT_THAT(findings_of(found).ranking[0].look_alikes, testing::ElementsAre("joint_spring @ joint.hinge"));
}

/// Friction that the damping had to imitate.
TEST(SearchFindings, SayWhichValuesHadAbsorbedTheEffect) {
  EXPECT_THAT(findings_of(stopped(with_friction().decided(1))).findings,
              Contains(testing::AllOf(HasSubstr("joint.hinge.damping ("), HasSubstr("had absorbed the effect"))));
}

TEST(SearchFindings, SayWhereOnlyLongPredictionsShowTheEffect) {
  SearchResult found = stopped(with_friction().decided(1));
  EXPECT_THAT(findings_of(found).findings, Not(Contains(HasSubstr("only the longest predictions"))));
  found.by_all_lengths = true;
  EXPECT_THAT(findings_of(found).findings, Contains(HasSubstr("only the longest predictions")));
}

TEST(SearchFindings, CannotTellWhereTheSearchWasStoppedWithoutAnAnswer) {
  EXPECT_EQ(findings_of(stopped(with_friction().decided(0))).verdict, Verdict::cannot_tell);
}

TEST(SearchFindings, MissNothingWhereTheModelIsRight) {
  const FoundPendulum right(two_recordings({.damping = 0.02}), {"coulomb_friction"});
  const Diagnosis diagnosis = findings_of(right.decided(0));
  EXPECT_EQ(diagnosis.verdict, Verdict::nothing_missing);
  EXPECT_FALSE(diagnosis.answer_gain);
  EXPECT_FALSE(diagnosis.unexplained);
  EXPECT_NEAR(diagnosis.base_times_floor, 1.0, 0.2);
  EXPECT_EQ(diagnosis.values.size(), 3U);
}

/// A cubic spring, of which friction takes nothing.
TEST(SearchFindings, SayThatNoEffectDescribesAForce) {
  const FoundPendulum lacking(two_recordings({.damping = 0.02, .cubic = 0.5}), {"coulomb_friction"});
  const Diagnosis diagnosis = findings_of(lacking.decided(0));
  EXPECT_EQ(diagnosis.verdict, Verdict::not_in_library);
  ASSERT_TRUE(diagnosis.unexplained);
  EXPECT_EQ(diagnosis.unexplained->joint, "hinge");
  EXPECT_THAT(diagnosis.findings,
              Contains(HasSubstr("no effect of the library describes the missing force on joint.hinge")));
  EXPECT_FALSE(diagnosis.residual_force.empty());
}

}  // namespace
}  // namespace lacuna

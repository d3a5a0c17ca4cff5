#include "diagnosis/verdict/verdict_figures.h"

#include "diagnosis/rounds/round.h"
#include "diagnosis/rounds/selection.h"

#include <gmock/gmock.h>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

VerdictFigure as_it_is(double value) { return {value, value, value}; }

/// Effects that gain `answer` nats, and a force of any form that would gain `rest` more, beyond chance.
VerdictFigures found(double answer, double rest) {
  VerdictFigures figures;
  figures.has_answer = true;
  figures.answer_share = share_with_range(answer, rest);
  figures.structure_p = as_it_is(0.0005);
  figures.structure_gain = lower_with_range({rest, 0.05 * rest, 0.9 * rest, 1.1 * rest});
  figures.answer_gain = with_range(answer);
  figures.answer_lower = lower_with_range({answer, 0.05 * answer, 0.9 * answer, 1.1 * answer});
  figures.chance_p = as_it_is(0.3);
  return figures;
}

/// Nothing was found, and the best score is as likely by chance as `p` says.
VerdictFigures nothing(const VerdictFigure& p) {
  VerdictFigures figures;
  figures.structure_p = as_it_is(0.4);
  figures.chance_p = p;
  return figures;
}

TEST(VerdictFigures, TellTheVerdict) {
  EXPECT_EQ(verdict_of(found(1000.0, 10.0)), Verdict::effect_found);
  EXPECT_EQ(verdict_of(found(1000.0, 500.0)), Verdict::not_in_library);
  EXPECT_EQ(verdict_of(nothing(as_it_is(0.3))), Verdict::nothing_missing);
  EXPECT_EQ(verdict_of(nothing(as_it_is(0.01))), Verdict::cannot_tell);
  VerdictFigures weak = found(1.0, 0.0);
  EXPECT_EQ(verdict_of(weak), Verdict::cannot_tell);
}

TEST(VerdictFigures, AreAtNoThresholdFarFromAll) {
  EXPECT_THAT(at_thresholds(found(1000.0, 10.0)), IsEmpty());
  EXPECT_THAT(at_thresholds(found(1000.0, 500.0)), IsEmpty());
  EXPECT_THAT(at_thresholds(nothing({0.3, 0.28, 0.32})), IsEmpty());
}

/// 95 % of what is to be gained, but for the last digits: either side says so, and names the other verdict.
TEST(VerdictFigures, NameTheShareAtItsThresholdFromEitherSide) {
  const std::vector<AtThreshold> above = at_thresholds(found(95.01, 4.99)), below = at_thresholds(found(94.95, 5.05));
  ASSERT_THAT(above, SizeIs(1));
  EXPECT_THAT(above[0].figure, HasSubstr("of all that is to be gained"));
  EXPECT_EQ(above[0].other, Verdict::not_in_library);
  EXPECT_NEAR(above[0].value, 0.9501, 1e-12);
  EXPECT_EQ(above[0].threshold, 0.95);
  ASSERT_THAT(below, SizeIs(1));
  EXPECT_EQ(below[0].other, Verdict::effect_found);
}

/// A share just below the threshold is no matter where no structure is left.
TEST(VerdictFigures, AreAtNoThresholdThatDoesNotTurnTheVerdict) {
  VerdictFigures figures = found(94.95, 5.05);
  figures.structure_p = as_it_is(0.4);
  EXPECT_EQ(verdict_of(figures), Verdict::effect_found);
  EXPECT_THAT(at_thresholds(figures), IsEmpty());
}

TEST(VerdictFigures, NameAChanceAtItsLevel) {
  const std::vector<AtThreshold> near = at_thresholds(nothing({0.052, 0.049, 0.055}));
  ASSERT_THAT(near, SizeIs(1));
  EXPECT_EQ(near[0].unit, FigureUnit::chance);
  EXPECT_EQ(near[0].other, Verdict::cannot_tell);
}

TEST(VerdictFigures, NameMotionThatIsNearlyMissed) {
  VerdictFigures figures = found(1000.0, 10.0);
  figures.missed_motion = with_range(0.995, kLastDigitsOfError);
  const std::vector<AtThreshold> near = at_thresholds(figures);
  ASSERT_THAT(near, SizeIs(1));
  EXPECT_EQ(near[0].other, Verdict::cannot_tell);
}

TEST(VerdictFigures, NameAFormThatNearlyIsOne) {
  VerdictFigures figures = found(100.0, 1.0);
  figures.may_be_form = true;
  figures.form_share = with_range(0.0505);
  figures.base_error = with_range(1.1, kLastDigitsOfError);
  EXPECT_EQ(verdict_of(figures), Verdict::effect_found);
  const std::vector<AtThreshold> near = at_thresholds(figures);
  ASSERT_THAT(near, SizeIs(1));
  EXPECT_EQ(near[0].other, Verdict::nothing_missing);
}

}  // namespace
}  // namespace lacuna

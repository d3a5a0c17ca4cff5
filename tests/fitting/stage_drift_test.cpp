#include "fitting/stage_drift.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace lacuna {
namespace {

FittedValue fitted(double value, double half) {
  FittedValue result;
  result.address = "body.arm.mass";
  result.value = value;
  result.lower_95 = value - half;
  result.upper_95 = value + half;
  return result;
}

std::vector<FitStage> stages(double over_half_a_second) {
  FitStage segments, whole;
  segments.segment = 0.5;
  segments.values = {over_half_a_second};
  whole.values = {0.0};
  return {segments, whole};
}

const std::vector<FreeValue> kMass = {{{.address = "body.arm.mass", .unit = "kg", .lower = 0.0, .upper = 50.0}}};

TEST(DriftSentences, NameAValueThatMovesWithTheLengthOfSegments) {
  EXPECT_THAT(
      drift_sentences(stages(2.0), {fitted(1.0, 0.1)}, kMass),
      testing::ElementsAre("body.arm.mass is 2.00 kg over 0.5 s but 1.00 kg over whole trials: with a complete model "
                           "the value does not depend on the length"));
}

TEST(DriftSentences, AreSilentWithinTheIntervalAndAboutSmallChanges) {
  EXPECT_THAT(drift_sentences(stages(2.0), {fitted(1.0, 0.6)}, kMass), testing::IsEmpty());
  EXPECT_THAT(drift_sentences(stages(1.1), {fitted(1.0, 0.01)}, kMass), testing::IsEmpty());
}

TEST(DriftSentences, NameAValueThatEndedAtItsBound) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(drift_sentences(stages(2.0), {fitted(0.0, nothing)}, kMass), testing::SizeIs(1));
}

TEST(DriftSentences, AreSilentAboutAValueThatShortSegmentsDoNotTell) {
  EXPECT_THAT(drift_sentences(stages(50.0), {fitted(1.0, 0.1)}, kMass), testing::IsEmpty());
  EXPECT_THAT(drift_sentences(stages(0.0), {fitted(1.0, 0.1)}, kMass), testing::SizeIs(1));
}

TEST(DriftSentences, NeedTwoStages) {
  EXPECT_THAT(drift_sentences({stages(2.0).back()}, {fitted(1.0, 0.1)}, kMass), testing::IsEmpty());
}

TEST(Moved, CountsAFifthOfTheLargerValue) {
  EXPECT_FALSE(moved({1.0, 5.0}, {1.2, 5.0}));
  EXPECT_TRUE(moved({1.0, 5.0}, {1.3, 5.0}));
  EXPECT_TRUE(moved({0.0}, {1e-9}));
  EXPECT_FALSE(moved({0.0}, {0.0}));
}

}  // namespace
}  // namespace lacuna

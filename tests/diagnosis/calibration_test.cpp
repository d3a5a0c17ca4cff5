#include "diagnosis/verdict/calibration.h"
#include "diagnosis/verdict/evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

VerdictCalibration some() { return {-1.0, {{"log_lead", 2.0, 0.0, 3.0}, {"unsteady", -1.0, 0.0, 1.0}}}; }

double odds(double probability) { return std::log(probability / (1.0 - probability)); }

TEST(Calibration, IsALogisticRegression) {
  EXPECT_NEAR(odds(some().probability({{"log_lead", 1.5}, {"unsteady", 1.0}})), -1.0 + 3.0 - 1.0, 1e-12);
}

TEST(Calibration, GoesNoFurtherThanTheCasesThatItIsFittedTo) {
  EXPECT_NEAR(odds(some().probability({{"log_lead", 50.0}, {"unsteady", 0.0}})), -1.0 + 6.0, 1e-12);
}

TEST(Calibration, TakesTheMiddleOfWhatIsNotKnown) {
  EXPECT_NEAR(odds(some().probability({{"log_lead", 1.0}})), -1.0 + 2.0 - 0.5, 1e-12);
}

TEST(Calibration, IsReadAsItWasWritten) {
  const ShippedCalibration written{{{"effect_found", some()}}, {{"cart_pole", {{"nothing_missing", {0.5, {}}}}}}};
  const ShippedCalibration read = read_calibration(calibration_json(written, "a test"));
  const Evidence evidence = {{"log_lead", 1.0}, {"unsteady", 1.0}};
  EXPECT_DOUBLE_EQ(read.all.at("effect_found").probability(evidence), some().probability(evidence));
  EXPECT_NEAR(odds(read.without.at("cart_pole").at("nothing_missing").probability({})), 0.5, 1e-12);
}

TEST(Calibration, DoesNotCoverRobotsThatItsCasesDoNotHold) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::nothing_missing;
  diagnosis.probability = 0.7;
  tell_probability(diagnosis, evidence_of(diagnosis, true), false);
  EXPECT_FALSE(diagnosis.calibrated);
  EXPECT_DOUBLE_EQ(diagnosis.probability, 0.7);
  EXPECT_TRUE(diagnosis.evidence.contains("surprise"));
}

/// Ahead of the best that is not named beside it.
TEST(Evidence, LeadIsThatOverModelsThatTheDataTellApart) {
  Diagnosis diagnosis;
  const auto model = [](const char* effect, double gain) {
    RankedModel one;
    one.effects = {{effect, "joint.hinge", {}}};
    one.gain.value = gain;
    return one;
  };
  diagnosis.ranking = {model("coulomb_friction", 100.0), model("stribeck_friction", 99.0), model("cogging", 1.0)};
  diagnosis.ranking.front().look_alikes = {"stribeck_friction @ joint.hinge"};
  tell_probability(diagnosis, evidence_of(diagnosis, true), false);
  EXPECT_NEAR(diagnosis.evidence.at("log_lead"), 2.0, 1e-12);
  EXPECT_DOUBLE_EQ(diagnosis.evidence.at("look_alikes"), 1.0);
}

}  // namespace
}  // namespace lacuna

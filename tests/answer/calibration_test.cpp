#include "answer/calibration.h"

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

TEST(Calibration, StatesNoProbabilityOfAVerdictThatItDoesNotHold) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::cannot_tell;
  tell_probability(diagnosis, {{"surprise", 1.0}});
  EXPECT_FALSE(diagnosis.calibrated);
  EXPECT_TRUE(std::isnan(diagnosis.probability));
  EXPECT_TRUE(diagnosis.evidence.contains("surprise"));
}

}  // namespace
}  // namespace lacuna

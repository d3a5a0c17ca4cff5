#include "calibration/calibrate.h"
#include "calibration/logistic_regression.h"
#include "plant/draw.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hidden_effects {
namespace {

TEST(LogisticFit, FindsTheOddsThatMadeTheCases) {
  constexpr Eigen::Index kCases = 20000;
  Draw draw(1, 0);
  Eigen::MatrixXd rows(kCases, 2);
  Eigen::VectorXd right(kCases);
  for (Eigen::Index i = 0; i < kCases; ++i) {
    rows(i, 0) = 4.0 * draw.uniform();
    rows(i, 1) = draw.uniform() < 0.3 ? 1.0 : 0.0;
    right(i) = draw.uniform() < logistic(-1.0 + 0.8 * rows(i, 0) - 1.5 * rows(i, 1)) ? 1.0 : 0.0;
  }
  const LogisticFit fit = fit_logistic(rows, right);
  EXPECT_NEAR(fit.intercept, -1.0, 0.1);  // its standard error is 0.03
  EXPECT_NEAR(fit.weights(0), 0.8, 0.06);
  EXPECT_NEAR(fit.weights(1), -1.5, 0.12);
}

TEST(LogisticFit, StaysFiniteWhereAllAreRight) {
  const LogisticFit fit = fit_logistic(Eigen::MatrixXd(20, 0), Eigen::VectorXd::Ones(20));
  EXPECT_NEAR(logistic(fit.intercept), 20.5 / 21.0, 1e-6);
}

/// Two columns say the same; by chance the second speaks against what it must speak for.
TEST(LogisticFit, GivesNoWeightTheSignThatItCannotHave) {
  Eigen::MatrixXd rows(6, 2);
  rows << 0, 0, 0, 1, 1, 1, 1, 0, 2, 1, 2, 2;
  Eigen::VectorXd right(6);
  right << 0, 0, 0, 1, 1, 1;
  ASSERT_LT(fit_logistic(rows, right, 0.1).weights(1), 0.0);
  const LogisticFit fit = fit_logistic(rows, right, 0.1, Eigen::VectorXd::Ones(2));
  EXPECT_GT(fit.weights(0), 0.0);
  EXPECT_DOUBLE_EQ(fit.weights(1), 0.0);
}

JudgedVerdict verdict(const char* rig, double lead, bool right) {
  return {rig, "effect_found", {{"least_part", lead}}, right ? 1.0 : 0.0};
}

TEST(Calibrate, TellsSureVerdictsFromOthersAndLeavesRigsOut) {
  std::vector<JudgedVerdict> verdicts;
  for (int i = 0; i < 40; ++i) {
    verdicts.push_back(verdict("servo_pendulum", 2.0, i % 10 != 0));
    verdicts.push_back(verdict("servo_pendulum", 0.0, i % 10 < 3));
    verdicts.push_back(verdict("cart_pole", 1.0, false));
  }
  for (const char* rare : {"nothing_missing", "not_in_library"}) {
    for (int i = 0; i < 3; ++i) {
      verdicts.push_back(verdict("cart_pole", 1.0, i > 0));
      verdicts.back().verdict = rare;
    }
  }
  verdicts.pop_back();
  const lacuna::ShippedCalibration calibration = calibrate_and_leave_out(verdicts);
  EXPECT_FALSE(calibration.all.contains("not_in_library")) << "two are too few";
  EXPECT_NEAR(calibration.all.at("nothing_missing").probability({}), 2.5 / 4.0, 1e-6) << "two of three were right";
  const auto without = calibration.without.at("cart_pole").at("effect_found");
  EXPECT_NEAR(without.probability({{"least_part", 2.0}}), 0.9, 0.03);
  EXPECT_NEAR(without.probability({{"least_part", 0.0}}), 0.3, 0.03);
  EXPECT_LT(calibration.all.at("effect_found").probability({{"least_part", 1.0}}), 0.5);
  EXPECT_LT(calibration.without.at("servo_pendulum").at("effect_found").probability({{"least_part", 1.0}}), 0.05);
}

/// A figure that speaks for one thing on one rig and for the other on the next is worth nothing on a third.
TEST(Calibrate, WeighsLittleWhatDoesNotHoldFromRigToRig) {
  std::vector<JudgedVerdict> verdicts;
  for (int i = 0; i < 40; ++i) {
    const double lead = i % 2;
    verdicts.push_back(verdict("servo_pendulum", lead, i % 8 != 0 && (lead > 0.5 || i % 4 == 0)));
    verdicts.push_back(verdict("cart_pole", lead, lead < 0.5 || i % 5 == 0));
  }
  const auto found = calibrate(verdicts).at("effect_found");
  EXPECT_NEAR(found.probability({{"least_part", 0.0}}), found.probability({{"least_part", 1.0}}), 0.05);
}

}  // namespace
}  // namespace hidden_effects

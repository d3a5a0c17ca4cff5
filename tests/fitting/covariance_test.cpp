#include "fitting/intervals/covariance.h"

#include "fitting/made_problem.h"
#include "fitting/intervals/identifiability.h"
#include "fitting/numerics/seeded_noise.h"
#include "foundation/statistics.h"

#include <Eigen/LU>
#include <gmock/gmock.h>

#include <cmath>

namespace lacuna::covariance_test {
namespace {

using namespace lacuna::analytic;

constexpr double kSigma = 0.1;  // of a reading
constexpr double kRate = 20.0;  // Hz
constexpr Eigen::Index kReadings = 601;

double line(std::span<const double> p, double t) { return p[0] + p[1] * t; }
double product(std::span<const double> p, double t) { return p[0] * p[1] * std::sin(t); }

/// A linear model's values and their uncertainty, at the truth.
struct KnownLine {
  explicit KnownLine(double memory = 0.0, const std::vector<bool>& at_bound = {false, false},
                     const FormulaModel::Formula& formula = line)
      : made(formula_problem(formula, {free_value("a", 1.0, -100.0, 100.0), free_value("b", 2.0, -100.0, 100.0)},
                             {disturbed(formula, memory)})) {
    point = made.problem.start(made.at({1.0, 2.0}));
    const std::vector<Eigen::VectorXd> residuals = made.residuals_at({1.0, 2.0});
    std::vector<SegmentJacobian> jacobians;
    made.problem.linearize_finely(point, residuals, jacobians);
    known = uncertainty(made.problem, made.space, point, residuals, jacobians, {}, at_bound);
  }
  /// Each error has `memory` of the one before.
  static Trial disturbed(const FormulaModel::Formula& formula, double memory) {
    Trial trial = formula_trial(formula, {1.0, 2.0}, 30.0, kRate, 0.0, 1);
    SeededNoise random(7, 7);
    double error = random.normal();
    for (double& reading : trial.measured.samples.reshaped()) {
      reading += kSigma * error;
      error = memory * error + std::sqrt(1.0 - memory * memory) * random.normal();
    }
    trial.sensor_noise = {kSigma};
    return trial;
  }
  MadeProblem made;
  FitPoint point;
  Uncertainty known;
};

/// σ² (XᵀX)⁻¹ of the line.
Eigen::Matrix2d textbook() {
  Eigen::MatrixXd regressors(kReadings, 2);
  regressors << Eigen::VectorXd::Ones(kReadings), regular_times(kReadings, kRate);
  return kSigma * kSigma * (regressors.transpose() * regressors).inverse();
}

TEST(Uncertainty, OfALineInWhiteNoiseIsThatOfTheTextbook) {
  const Uncertainty known = KnownLine().known;
  EXPECT_TRUE(known.inverse_information.isApprox(textbook(), 1e-4));
  for (const Eigen::Index j : {0, 1})  // 40 blocks know a variance to about a quarter
    EXPECT_NEAR(known.covariance(j, j), textbook()(j, j), 0.6 * textbook()(j, j)) << j;
  EXPECT_EQ(known.determined, (std::vector<bool>{true, true}));
  EXPECT_TRUE(known.undetermined.empty());
  EXPECT_EQ(known.correlation_time, 1.0 / kRate);
  EXPECT_FALSE(known.few_blocks);
  EXPECT_EQ(known.quantile, within_95_of_students_t(known.blocks - 2));
}

/// Errors that remember 0.9 of the one before count as a nineteenth of their number.
TEST(Uncertainty, IsLargerInErrorsThatAreCorrelatedInTime) {
  const Uncertainty white = KnownLine().known, slow = KnownLine(0.9).known;
  EXPECT_GT(slow.correlation_time, 5.0 / kRate);
  EXPECT_GT(slow.covariance(1, 1), 5.0 * white.covariance(1, 1));
  EXPECT_TRUE(slow.inverse_information.isApprox(white.inverse_information, 1e-3));
  EXPECT_LT(slow.blocks, white.blocks);
}

TEST(Uncertainty, SaysHowMuchDataBlocksOfIndependentErrorsNeed) {
  const Uncertainty known = KnownLine(0.995).known;
  EXPECT_TRUE(known.few_blocks);
  EXPECT_GT(known.enough_data, 30.0);
}

TEST(Uncertainty, IsNoneOfAValueAtItsBoundAndSmallerBesideIt) {
  const Uncertainty known = KnownLine(0.0, {true, false}).known;
  EXPECT_TRUE(std::isnan(known.covariance(0, 0)));
  EXPECT_TRUE(known.determined[0]);
  const double alone = kSigma * kSigma / regular_times(kReadings, kRate).squaredNorm();
  EXPECT_NEAR(known.inverse_information(1, 1), alone, 1e-3 * alone);
  EXPECT_EQ(known.inverse_information(0, 0), 0.0);
}

TEST(Uncertainty, IsNoneOfTwoValuesThatActByTheirProductAlone) {
  const KnownLine line(0.0, {false, false}, product);
  EXPECT_EQ(line.known.determined, (std::vector<bool>{false, false}));
  EXPECT_TRUE(std::isnan(line.known.covariance(1, 1)));
  ASSERT_EQ(line.known.undetermined.size(), 1U);
  const Eigen::VectorXd& direction = line.known.undetermined[0];
  EXPECT_NEAR(direction(0), -direction(1), 1e-3) << "one by as many per cent up as the other goes down";
  EXPECT_THAT(undetermined_sentences(line.known, line.point, line.made.space, line.made.definition.free),
              testing::ElementsAre("the data cannot tell a from b (only their product)"));
}

}  // namespace
}  // namespace lacuna::covariance_test

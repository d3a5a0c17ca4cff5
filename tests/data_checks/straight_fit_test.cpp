#include "data_checks/straight_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

TEST(StraightFit, FindsALineThatTheValuesLieOn) {
  const Eigen::MatrixXd columns{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}, {1.0, 3.0}};
  const StraightFit fit = straight_fit(columns, Eigen::Vector4d(1.0, 3.0, 5.0, 7.0));
  EXPECT_NEAR(fit.coefficients(0), 1.0, 1e-12);
  EXPECT_NEAR(fit.coefficients(1), 2.0, 1e-12);
  EXPECT_NEAR(fit.squares, 0.0, 1e-20);
}

/// A mean of four readings is known to half their noise.
TEST(StraightFit, TakesItsDeviationsFromTheNoiseWhereTheResidualIsSmaller) {
  const StraightFit fit = straight_fit(Eigen::MatrixXd::Ones(4, 1), Eigen::Vector4d::Constant(3.0));
  EXPECT_NEAR(fit.deviations(0), 0.5, 1e-12);
}

TEST(StraightFit, TakesItsDeviationsFromTheResidualWhereThatIsLarger) {
  const StraightFit fit = straight_fit(Eigen::MatrixXd::Ones(4, 1), Eigen::Vector4d(10.0, -10.0, 10.0, -10.0));
  EXPECT_NEAR(fit.squares, 400.0, 1e-9);
  EXPECT_NEAR(fit.deviations(0), 0.5 * std::sqrt(400.0 / 3.0), 1e-9);
}

TEST(StraightFit, DoesNotDependOnTheUnitOfAColumn) {
  const Eigen::MatrixXd columns{{1.0, 0.0}, {1.0, 1e9}, {1.0, 2e9}, {1.0, 4e9}};
  const StraightFit fit = straight_fit(columns, Eigen::Vector4d(1.0, 3.0, 5.0, 9.0));
  EXPECT_NEAR(fit.coefficients(1), 2e-9, 1e-20);
  EXPECT_TRUE(std::isfinite(fit.deviations(1)));
}

TEST(StraightFit, SharesTheCoefficientAmongEqualColumnsAndKnowsNoneOfThem) {
  const Eigen::MatrixXd columns{{1.0, 1.0, 1.0}, {2.0, 2.0, -1.0}, {3.0, 3.0, 0.5}};
  const StraightFit fit = straight_fit(columns, Eigen::Vector3d(4.0, 8.0, 12.0));
  EXPECT_NEAR(fit.coefficients(0), 2.0, 1e-9);
  EXPECT_NEAR(fit.coefficients(1), 2.0, 1e-9);
  EXPECT_TRUE(std::isinf(fit.deviations(0)));
  EXPECT_TRUE(std::isinf(fit.deviations(1)));
  EXPECT_TRUE(std::isfinite(fit.deviations(2)));
}

TEST(StraightFit, GivesAColumnOfZerosNoCoefficient) {
  const Eigen::MatrixXd columns{{1.0, 0.0}, {2.0, 0.0}};
  const StraightFit fit = straight_fit(columns, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(fit.coefficients(1), 0.0);
  EXPECT_TRUE(std::isinf(fit.deviations(1)));
}

}  // namespace
}  // namespace lacuna

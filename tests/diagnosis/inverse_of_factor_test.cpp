#include "diagnosis/inverse_of_factor.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kRounding = 1e-10;

/// Correlated as exp(−|a − b|/20), which has an inverse of moderate size.
Eigen::MatrixXd correlation(Eigen::Index rows) {
  Eigen::MatrixXd matrix(rows, rows);
  for (Eigen::Index a = 0; a < rows; ++a)
    for (Eigen::Index b = 0; b < rows; ++b) matrix(a, b) = std::exp(-static_cast<double>(std::abs(a - b)) / 20.0);
  return matrix;
}

class InverseOfFactor : public testing::TestWithParam<Eigen::Index> {};

INSTANTIATE_TEST_SUITE_P(Sizes, InverseOfFactor, testing::Values(1, 7, 33, 130, 257));

TEST_P(InverseOfFactor, IsTheInverseAndReadsTheLowerHalfAlone) {
  const Eigen::MatrixXd matrix = correlation(GetParam());
  Eigen::MatrixXd factor = matrix.llt().matrixL();
  factor.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
  const Eigen::MatrixXd inverse = inverse_of_factor(factor).selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd product = matrix * inverse;
  EXPECT_LE((product - Eigen::MatrixXd::Identity(GetParam(), GetParam())).cwiseAbs().maxCoeff(), kRounding);
}

}  // namespace
}  // namespace lacuna

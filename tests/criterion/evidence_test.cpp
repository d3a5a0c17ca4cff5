#include "criterion/evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lacuna::evidence_test {
namespace {

Eigen::VectorXd drawn(std::mt19937_64& bits, Eigen::Index size, double mean) {
  std::normal_distribution<double> normal(mean, 1.0);
  Eigen::VectorXd blocks(size);
  for (double& block : blocks) block = normal(bits);
  return blocks;
}

TEST(StandardError, IsThatOfASumOfIndependentBlocks) {
  std::mt19937_64 bits(1);
  double mean = 0.0;
  for (int i = 0; i < 200; ++i) mean += standard_error(drawn(bits, 40, 3.0)) / 200.0;
  EXPECT_NEAR(mean / std::sqrt(40.0), 1.1, 0.1);  // the largest of three estimates is a tenth more
}

TEST(StandardError, GrowsWhereNeighboursErrTogether) {
  Eigen::VectorXd blocks(40);
  for (Eigen::Index i = 0; i < 40; ++i) blocks(i) = (i / 4) % 2 == 0 ? 1.0 : -1.0;
  EXPECT_GT(standard_error(blocks), 1.8 * std::sqrt(40.0));
}

TEST(SignProbability, IsUniformWithoutAGainAndSmallWithOne) {
  std::mt19937_64 bits(2);
  int small = 0;
  for (int i = 0; i < 100; ++i) {
    const std::vector<Eigen::VectorXd> gains{drawn(bits, 40, 0.0), drawn(bits, 40, 0.0), drawn(bits, 40, 0.0)};
    small += sign_probability(gains, 1) < 0.05 ? 1 : 0;
  }
  EXPECT_LE(small, 7);
  EXPECT_LT(sign_probability({drawn(bits, 40, 0.0), drawn(bits, 40, 1.5)}, 1), 0.01);
}

TEST(SignProbability, IsOneOfTooFewBlocks) { EXPECT_EQ(sign_probability({Eigen::VectorXd::Ones(4)}, 1), 1.0); }

}  // namespace
}  // namespace lacuna::evidence_test

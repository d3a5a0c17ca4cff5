#include "where_it_fails/regression_tree.h"

#include "fitting/numerics/seeded_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

constexpr Eigen::Index kRows = 3000;

Eigen::VectorXd coloured_rows(double memory, std::uint64_t stream) {
  SeededNoise random(11, stream);
  const double kept = std::exp(-1.0 / memory);
  Eigen::VectorXd values(kRows);
  double value = random.normal() / std::sqrt(1.0 - kept * kept);
  for (double& one : values) one = value = kept * value + random.normal();
  return values;
}

/// Time, a sine, its derivative, the derivative's size, and noise.
Eigen::MatrixXd features(std::uint64_t stream) {
  Eigen::MatrixXd all(kRows, 5);
  for (Eigen::Index i = 0; i < kRows; ++i) {
    const double phase = static_cast<double>(i) / 50.0;
    all.row(i) << static_cast<double>(i), std::sin(phase), std::cos(phase), std::abs(std::cos(phase)), 0.0;
  }
  all.col(4) = coloured_rows(20.0, stream);
  return all;
}

TEST(GrowTree, NoiseGrowsNone) {
  constexpr int kRepeats = 60;
  for (const double memory : {0.1, 20.0, 100.0}) {
    int grown = 0;
    for (std::uint64_t i = 0; i < kRepeats; ++i)
      grown += grow_tree(features(1000 + i), coloured_rows(memory, i).array().square()).grown() ? 1 : 0;
    EXPECT_LE(grown, 3) << memory;
  }
}

TEST(GrowTree, FindsTheRegimeTheShareAndTheThreshold) {
  const Eigen::MatrixXd all = features(1);
  constexpr double kSpeed = 0.2;
  Eigen::VectorXd error = coloured_rows(3.0, 2).array().square();
  double slow = 0.0, samples = 0.0;
  for (Eigen::Index i = 0; i < kRows; ++i)
    if (all(i, 3) < kSpeed) {
      error(i) *= 16.0;
      slow += error(i);
      samples += 1.0 / kRows;
    }
  const RegressionTree tree = grow_tree(all, error);
  ASSERT_TRUE(tree.grown());
  const RegressionTree::Node& root = tree.nodes.front();
  EXPECT_EQ(root.feature, 3);
  EXPECT_NEAR(root.threshold, kSpeed, 0.03);
  const RegressionTree::Node& left = tree.nodes[static_cast<std::size_t>(root.left)];
  EXPECT_NEAR(left.share_of_error, slow / error.sum(), 0.05);
  EXPECT_NEAR(left.share_of_samples, samples, 0.02);
  EXPECT_LT(root.p, 0.03);
}

TEST(GrowTree, LeavesArePartsOfTheWholeAndNotTooSmall) {
  const Eigen::MatrixXd all = features(3);
  Eigen::VectorXd error = coloured_rows(0.1, 4).array().square();
  for (Eigen::Index i = 0; i < kRows; ++i) error(i) *= (all(i, 3) < 0.3 ? 9.0 : 1.0) * (all(i, 1) > 0.0 ? 4.0 : 1.0);
  const RegressionTree tree = grow_tree(all, error);
  double errors = 0.0, samples = 0.0;
  int depth = 0;
  for (const RegressionTree::Node& node : tree.nodes) {
    depth = std::max(depth, node.depth);
    if (node.left >= 0) continue;
    EXPECT_GE(node.share_of_samples, TreeOptions{}.least_share);
    errors += node.share_of_error;
    samples += node.share_of_samples;
  }
  EXPECT_GE(depth, 2);
  EXPECT_LE(depth, TreeOptions{}.depth);
  EXPECT_NEAR(errors, 1.0, 1e-9);
  EXPECT_NEAR(samples, 1.0, 1e-9);
}

TEST(GrowTree, OneBurstIsNoRegime) {
  Eigen::VectorXd error = coloured_rows(0.1, 5).array().square();
  error.segment(1234, 120) *= 400.0;  // within one block, so that no other block can confirm it
  EXPECT_FALSE(grow_tree(features(6), error).grown());
}

TEST(GrowTree, NothingToPartIsNoTree) {
  EXPECT_FALSE(grow_tree(features(1), Eigen::VectorXd::Zero(kRows)).grown());
  EXPECT_FALSE(grow_tree(Eigen::MatrixXd(kRows, 0), Eigen::VectorXd::Ones(kRows)).grown());
}

}  // namespace
}  // namespace lacuna

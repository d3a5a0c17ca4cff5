#include "criterion/cost.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna::cost_test {
namespace {

TEST(CostOfMeanSquare, IsHalfALogarithmAboveOneAndALikelihoodBelow) {
  EXPECT_DOUBLE_EQ(cost_of_mean_square(4.0), std::log(2.0));
  EXPECT_DOUBLE_EQ(cost_of_mean_square(1.0), 0.0);
  EXPECT_DOUBLE_EQ(cost_of_mean_square(0.0), -0.5);
  const double step = 1e-6;  // one slope on both sides
  EXPECT_NEAR(cost_of_mean_square(1.0 + step) / step, -cost_of_mean_square(1.0 - step) / step, 1e-5);
}

/// One cell of six blocks in three folds, ten readings a block.
CellLayout one_cell() {
  CellLayout layout{{{0, 1.0}}, 1, {0, 0, 1, 1, 2, 2}, 3};
  return layout;
}

/// Rows (residual, column) that are the same in each block, but for `outlier` in the residuals of the last one.
BlockProducts line(const CellLayout& layout, double size, double outlier = 0.0) {
  BlockProducts products(layout, 1);
  for (std::size_t b = 0; b < layout.blocks(); ++b)
    for (int i = 0; i < 10; ++i) {
      const double column = i - 4.5, noise = (i % 2 == 0 ? 1.0 : -1.0);
      const Eigen::Vector2d row(size * column + noise + (b == 5 ? outlier : 0.0), column);
      products.at(0, b) += row * row.transpose();
      products.samples(0, b) += 1.0;
    }
  return products;
}

StepBounds wide() { return {Eigen::VectorXd::Constant(1, -1e6), Eigen::VectorXd::Constant(1, 1e6)}; }

/// Of the alternating noise the line takes a part: Σ noise·column / Σ column² = −5 / 82.5.
constexpr double kOfNoise = -5.0 / 82.5;

TEST(LeastCost, IsThatOfLeastSquares) {
  const CellLayout layout = one_cell();
  const LinearCost least = least_cost(layout, line(layout, 3.0), wide());
  EXPECT_NEAR(least.step(0), 3.0 + kOfNoise, 1e-6);
  EXPECT_NEAR(least.mean_square(0), 1.0 - 5.0 * 5.0 / 82.5 / 10.0, 1e-6);
}

TEST(LeastCost, StaysWithinBounds) {
  const CellLayout layout = one_cell();
  StepBounds bounds = wide();
  bounds.upper(0) = 2.0;
  const LinearCost least = least_cost(layout, line(layout, 3.0), bounds);
  EXPECT_DOUBLE_EQ(least.step(0), 2.0);
}

/// Without bounds both values fall; the second one at its bound, the first rises.
TEST(LeastCost, FreesAValueThatOthersAtTheirBoundsLetBackInside) {
  const CellLayout layout = one_cell();
  BlockProducts products(layout, 2);
  for (std::size_t b = 0; b < layout.blocks(); ++b) {
    products.at(0, b) << 10.0, 0.5, -1.0,  //
        0.5, 1.0, -0.9,                    //
        -1.0, -0.9, 1.0;
    products.samples(0, b) = 1.0;
  }
  const StepBounds bounds{Eigen::Vector2d::Zero(), Eigen::Vector2d::Constant(10.0)};
  const LinearCost least = least_cost(layout, products, bounds);
  EXPECT_NEAR(least.step(0), 0.5, 1e-9);
  EXPECT_EQ(least.step(1), 0.0);
}

/// As much of the diagonal again halves the step.
TEST(LeastCost, ARidgeOfTheDiagonalHalvesTheStep) {
  const CellLayout layout = one_cell();
  StepBounds bounds = wide();
  bounds.ridge = Eigen::VectorXd::Ones(1);
  const LinearCost least = least_cost(layout, line(layout, 3.0), bounds);
  EXPECT_NEAR(least.step(0), 0.5 * (3.0 + kOfNoise), 1e-6);
}

/// A law begins at nothing: what it gains by its whole step counts, what a fit has gained already does not.
TEST(CrossFit, OfWholeStepsHasTheGainOfALaw) {
  const CellLayout layout = one_cell();
  const BlockProducts products = line(layout, 3.0);
  const LinearCost least = least_cost(layout, products, wide());
  const double without = cost_at(layout, products, Eigen::VectorXd::Zero(1)).cost;
  EXPECT_NEAR(cross_fit(layout, products, wide(), least, true).cost, least.cost, 1e-6);
  EXPECT_NEAR(cross_fit(layout, products, wide(), least).cost, without, 1e-6);
}

TEST(BlockProducts, OfAPartAreThoseOfItsValues) {
  const CellLayout layout = one_cell();
  BlockProducts products(layout, 2);
  products.at(0, 3) << 1.0, 2.0, 3.0, 2.0, 4.0, 5.0, 3.0, 5.0, 6.0;
  products.samples(0, 3) = 7.0;
  const BlockProducts part = products.part({1});
  EXPECT_EQ(part.values(), 1);
  EXPECT_EQ(part.at(0, 3), (Eigen::Matrix2d{{1.0, 3.0}, {3.0, 6.0}}));
  EXPECT_EQ(part.samples(0, 3), 7.0);
}

TEST(CrossFit, SumsToTheCostOfAFitWhereAllBlocksAreAlike) {
  const CellLayout layout = one_cell();
  const BlockProducts products = line(layout, -kOfNoise);  // linearised at its least cost
  const LinearCost least = least_cost(layout, products, wide());
  const CrossFittedCost crossed = cross_fit(layout, products, wide(), least);
  EXPECT_NEAR(crossed.cost, least.cost, 1e-6);
  EXPECT_EQ(crossed.by_block().size(), 6);
  EXPECT_NEAR(crossed.by_block()(0), least.cost / 6.0, 1e-6);
}

TEST(CrossFit, CostsMoreWhereFoldsDisagree) {
  const CellLayout layout = one_cell();
  BlockProducts products = line(layout, 3.0);
  const BlockProducts other = line(layout, -3.0);
  for (const std::size_t b : {4U, 5U}) products.at(0, b) = other.at(0, b);
  const LinearCost least = least_cost(layout, products, wide());
  EXPECT_GT(cross_fit(layout, products, wide(), least).cost, least.cost + 0.1);
}

TEST(ToldValues, AreTheRankInScaledCoordinates) {
  Eigen::Matrix3d information;
  information << 1.0, 0.0, 0.0, 0.0, 1e-12, 0.0, 0.0, 0.0, 1e12;
  EXPECT_EQ(told_values(information), 3);
  Eigen::Matrix2d alike;  // two values that only act together
  alike << 4.0, 2.0, 2.0, 1.0;
  EXPECT_EQ(told_values(alike), 1);
}

}  // namespace
}  // namespace lacuna::cost_test

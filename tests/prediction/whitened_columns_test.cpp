#include "prediction/whitened_columns.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

constexpr Eigen::Index kRowsOfStretch = 12;

/// A stretch of one channel, in three blocks of time, with two unknowns of its start.
PredictionLadder one_stretch_ladder() {
  PredictionLadder ladder;
  ladder.lengths = {1.0};
  ladder.noise = {{}};
  ladder.layout = {{{0, 1.0}}, 1, {0, 1, 2}, 3};
  PredictedStretch stretch;
  stretch.unknown = {0, 1};
  stretch.covariance = (Eigen::Matrix2d() << 0.04, 0.01, 0.01, 0.09).finished();
  for (Eigen::Index row = 0; row < kRowsOfStretch; ++row) {
    stretch.rows.push_back(row);
    stretch.columns.push_back(0);
    stretch.channels.push_back(0);
    stretch.blocks.push_back(static_cast<std::size_t>(row) / 4);
  }
  ladder.stretches = {stretch};
  return ladder;
}

/// A change that is added later is as if it had been a value of the model.
TEST(WhitenedColumns, OfAChangeAreThoseOfAValue) {
  const PredictionLadder ladder = one_stretch_ladder();
  LinearStretch linear;
  const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(kRowsOfStretch, 0.0, 1.0);
  linear.residual = time.array().sin() + 0.3;
  linear.values.resize(kRowsOfStretch, 2);
  linear.values << time.array().square(), time.array().cube();
  linear.start.resize(kRowsOfStretch, 2);
  linear.start << Eigen::VectorXd::Ones(kRowsOfStretch), time;
  const BlockProducts whole = whitened_products(ladder, {linear});

  LinearStretch without = linear;
  without.values = linear.values.leftCols(1);
  const PredictedChange change = {linear.values.col(1)};
  const BlockProducts later = WhitenedColumns(ladder, {without}).with({&change});
  ASSERT_EQ(later.values(), whole.values());
  for (std::size_t block = 0; block < 3; ++block) {
    EXPECT_TRUE(later.at(0, block).isApprox(whole.at(0, block), 1e-12)) << block;
    EXPECT_EQ(later.samples(0, block), 4.0);
  }
}

}  // namespace
}  // namespace lacuna

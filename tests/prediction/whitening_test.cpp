#include "prediction/whitened_columns.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace lacuna {
namespace {

/// One stretch of `rows` readings of one channel, in two blocks of time, whose start has two unknown components.
struct OneStretch {
  PredictionLadder ladder;
  LinearStretch linear;

  explicit OneStretch(Eigen::Index rows) {
    ladder.lengths = {1.0};
    ladder.noise = {{"angle", "rad", 1.0, ""}};
    ladder.layout = {{{0, 1.0}}, 1, {0, 1}, 1};
    PredictedStretch stretch;
    stretch.start.positions = {0.0};
    stretch.start.velocities = {0.0};
    stretch.unknown = {0, 1};
    stretch.covariance = Eigen::Matrix2d{{4.0, 1.0}, {1.0, 9.0}};
    for (Eigen::Index row = 0; row < rows; ++row) {
      stretch.rows.push_back(row);
      stretch.columns.push_back(0);
      stretch.channels.push_back(0);
      stretch.blocks.push_back(row < rows / 3 ? 0U : 1U);
    }
    ladder.stretches = {stretch};
    const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(rows, 0.1, 1.0);
    linear.residual = (7.0 * time).array().sin() + 2.0;
    linear.values = (3.0 * time).array().cos();
    linear.start.resize(rows, 2);
    linear.start << Eigen::VectorXd::Ones(rows), time;
  }

  Eigen::MatrixXd sum() const {
    const BlockProducts products = whitened_products(ladder, {linear});
    return products.at(0, 0) + products.at(0, 1);
  }
};

TEST(WhitenedProducts, AreThoseUnderTheCovarianceOfReadingsAndStart) {
  const OneStretch one(30);
  const Eigen::MatrixXd& j = one.linear.start;
  const Eigen::MatrixXd covariance =
      Eigen::MatrixXd::Identity(30, 30) + j * one.ladder.stretches[0].covariance * j.transpose();
  Eigen::MatrixXd rows(30, 2);
  rows << one.linear.residual, one.linear.values;
  const Eigen::MatrixXd wanted = rows.transpose() * covariance.inverse() * rows;
  EXPECT_TRUE(one.sum().isApprox(wanted, 1e-6)) << one.sum() << "\n" << wanted;
}

TEST(WhitenedProducts, CountTheReadingsOfEachBlock) {
  const OneStretch one(30);
  const BlockProducts products = whitened_products(one.ladder, {one.linear});
  EXPECT_EQ(products.samples(0, 0), 10.0);
  EXPECT_EQ(products.samples(0, 1), 20.0);
}

TEST(MovedStarts, TakeOffWhatTheReadingsTellOfThem) {
  OneStretch one(30);
  one.ladder.stretches[0].covariance *= 1e6;  // a start of which little is known follows the readings
  one.linear.residual = one.linear.start * Eigen::Vector2d(0.3, -0.7);
  LinearPrediction linear{{one.linear}, {}};
  const std::vector<Eigen::VectorXd> starts = moved_starts(one.ladder, linear, Eigen::VectorXd::Zero(1));
  EXPECT_NEAR(starts[0](0), 0.3, 1e-4);
  EXPECT_NEAR(starts[0](1), -0.7, 1e-4);
}

}  // namespace
}  // namespace lacuna

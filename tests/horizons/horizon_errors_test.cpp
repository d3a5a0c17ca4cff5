#include "horizons/horizon_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

TEST(HorizonCost, IsHalfALogarithmAboveTheFloorAndALikelihoodBelow) {
  EXPECT_DOUBLE_EQ(cost_of(4.0, 1.0), std::log(2.0));
  EXPECT_DOUBLE_EQ(cost_of(1.0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(cost_of(0.0, 1.0), -0.5);
  const double step = 1e-6;  // one slope on both sides
  EXPECT_NEAR((cost_of(1.0 + step, 1.0) - cost_of(1.0, 1.0)) / step,
              (cost_of(1.0, 1.0) - cost_of(1.0 - step, 1.0)) / step, 1e-5);
}

/// Two rungs of one channel, of `segments` segments with ten readings each.
struct TwoRungs {
  Ladder ladder;
  std::vector<Trial> trials{1};
  std::vector<Eigen::VectorXd> residuals;

  explicit TwoRungs(std::size_t segments = 20) {
    trials[0].measured.channels = {{"angle", "rad"}};
    trials[0].measured.samples.resize(1, 1);
    ladder.channels = {{"angle", "rad", 1.0, ""}};
    for (const double length : {0.1, 1.0}) {
      Rung rung{length, std::vector<Segment>(segments), {1e-6}, {0.0}, {1.0}, {true}, {0.5}};
      for (Segment& segment : rung.segments) {
        segment.rows.assign(10, 0);
        segment.columns.assign(10, 0);
        residuals.push_back(Eigen::VectorXd::Constant(10, length));
      }
      ladder.rungs.push_back(rung);
    }
  }
  HorizonErrors errors() const { return horizon_errors(ladder, trials, residuals); }
};

TEST(HorizonErrors, AreMeansByRung) {
  const HorizonErrors errors = TwoRungs().errors();
  ASSERT_TRUE(errors.valid);
  EXPECT_NEAR(errors.mean_square[0][0], 0.01, 1e-12);
  EXPECT_NEAR(errors.mean_square[1][0], 1.0, 1e-12);
  EXPECT_NEAR(errors.weight[0][0] + errors.weight[1][0], 1.0, 1e-12);
  EXPECT_NEAR(errors.cost, 0.5 * std::log(0.1), 1e-12);  // the mean of ½ ln 0.01 and ½ ln 1
}

/// One segment that a model loses may not decide.
TEST(HorizonErrors, AreWinsorised) {
  TwoRungs rungs;
  rungs.residuals[3].setConstant(100.0);
  // m of which 19/20 is 0.01 and 1/20 stands at 16 m.
  EXPECT_NEAR(rungs.errors().mean_square[0][0], 0.0475, 1e-3);
}

TEST(HorizonErrors, ARungOfFewSegmentsWeighsLess) {
  TwoRungs rungs;
  rungs.ladder.rungs[1].segments.resize(1);
  rungs.residuals.resize(21);
  weigh_by_information(rungs.ladder, rungs.trials, rungs.residuals);
  const HorizonErrors errors = rungs.errors();
  EXPECT_LT(errors.weight[1][0], 0.25 * errors.weight[0][0]);
}

TEST(HorizonErrors, WhatDoesNotCountIsLeftOut) {
  TwoRungs rungs;
  rungs.ladder.rungs[1].weight = {0.0};
  EXPECT_NEAR(rungs.errors().cost, std::log(0.1), 1e-12);
}

}  // namespace
}  // namespace lacuna

#include "horizons/linear_ladder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace lacuna {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoise = 0.01;
constexpr std::size_t kSegments = 20;
constexpr Eigen::Index kRows = 25;

/// One channel, one rung of twenty segments of a second in so many trials; what a model leaves is noise and what a test
/// adds.
struct OneRung {
  Ladder ladder;
  std::vector<Trial> trials;
  HorizonFit fit;
  std::vector<Eigen::VectorXd> noise, wave, slope;

  explicit OneRung(std::size_t count = 1) : trials(count) {
    const auto in_each = static_cast<Eigen::Index>(kSegments / count);
    for (Trial& trial : trials) {
      trial.measured.channels = {{"angle", "rad"}};
      trial.measured.times = Eigen::VectorXd::LinSpaced(in_each * kRows, 0.0, static_cast<double>(in_each));
      trial.measured.samples = TimeSeries::Samples::Zero(in_each * kRows, 1);
    }
    ladder.channels = {{"angle", "rad", kNoise, ""}};
    Rung rung{1.0, std::vector<Segment>(kSegments), {1e-8}, {0.0}, {1.0}, {true}, {1.0}};
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, kNoise);
    for (std::size_t k = 0; k < kSegments; ++k) {
      Segment& segment = rung.segments[k];
      const auto at = static_cast<Eigen::Index>(k) % in_each;
      segment.stretch = {k / static_cast<std::size_t>(in_each), at * kRows, (at + 1) * kRows};
      for (Eigen::Index row = 0; row < kRows; ++row) segment.rows.push_back(row);
      segment.columns.assign(static_cast<std::size_t>(kRows), 0);
      for (std::vector<Eigen::VectorXd>* column : {&noise, &wave, &slope})
        column->emplace_back(Eigen::VectorXd::Zero(kRows));
      for (Eigen::Index row = 0; row < kRows; ++row) {
        noise.back()(row) = normal(random);
        wave.back()(row) = std::sin(0.7 * static_cast<double>(row) + static_cast<double>(k));
        slope.back()(row) = 0.1 * static_cast<double>(row);
      }
    }
    ladder.rungs = {rung};
  }

  /// What the model leaves: noise and so much of the two responses.
  void leave(double of_wave, double of_slope) {
    fit.residuals = noise;
    for (std::size_t k = 0; k < kSegments; ++k) fit.residuals[k] += of_wave * wave[k] + of_slope * slope[k];
    fit.errors = horizon_errors(ladder, trials, fit.residuals);
  }
  /// The slope is the model's own value, which may move by `room`.
  LinearLadder linear(double room = kInfinity) const {
    LinearLadder::Parts parts{
        ladder, trials, fit, {}, {}, {}, Eigen::VectorXd::Constant(1, room), Eigen::VectorXd::Constant(1, room), 1.0};
    for (const Eigen::VectorXd& column : slope) parts.own.emplace_back(column);
    return LinearLadder(parts);
  }
};

TEST(LinearLadder, FindsTheSizesThatLeaveNoise) {
  OneRung rung;
  rung.leave(0.3, 0.2);
  LinearLadder linear = rung.linear();
  const std::size_t change = linear.add(rung.wave, -kInfinity, kInfinity);
  const LinearFit found = linear.best({&change, 1});
  EXPECT_NEAR(found.sizes(0), 0.2, 0.005);
  EXPECT_NEAR(found.sizes(1), 0.3, 0.005);
  EXPECT_NEAR(std::sqrt(found.mean_square[0][0]), kNoise, 0.001);
  EXPECT_NEAR(found.cost, std::log(kNoise), 0.1);
  EXPECT_LT(found.cost, linear.best({}).cost);
}

TEST(LinearLadder, KeepsBounds) {
  OneRung rung;
  rung.leave(-0.3, 0.2);
  LinearLadder linear = rung.linear(0.05);
  const std::size_t change = linear.add(rung.wave, 0.0, kInfinity);
  const LinearFit found = linear.best({&change, 1});
  EXPECT_DOUBLE_EQ(found.sizes(0), 0.05);
  EXPECT_DOUBLE_EQ(found.sizes(1), 0.0);
}

TEST(LinearLadder, AFitOfNoiseCostsMoreWhereItWasNotFitted) {
  OneRung rung;
  rung.leave(0.0, 0.0);
  LinearLadder linear = rung.linear();
  const double fitted = linear.best({}).cost;
  const CrossFit cross = linear.cross_fit(8);
  EXPECT_GT(cross.cost, fitted);
  EXPECT_LT(cross.cost, fitted + 0.02);
  EXPECT_NEAR(cross.by_block.sum(), 0.0, 1e-9);
  EXPECT_EQ(cross.told, 1);
  EXPECT_GT(cross.covariance(0, 0), 0.0);
}

TEST(LinearLadder, LeavesOutOneTrialAfterTheOther) {
  OneRung rung(4);
  rung.leave(0.0, 0.0);
  for (std::size_t k = 0; k < kSegments / 4; ++k) rung.fit.residuals[k] += 0.3 * rung.slope[k];
  rung.fit.errors = horizon_errors(rung.ladder, rung.trials, rung.fit.residuals);
  const double slope = rung.slope[0].squaredNorm() / static_cast<double>(kRows);
  // Three trials say 0, where the first has 0.3; with it two of the other three say a third of that.
  const double expected = slope * (0.3 * 0.3 + 3.0 * 0.1 * 0.1) / 4.0 + kNoise * kNoise;
  EXPECT_NEAR(rung.linear().cross_fit(2).cost, 0.5 * std::log(expected), 0.03);
}

}  // namespace
}  // namespace lacuna

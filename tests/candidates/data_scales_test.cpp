#include "candidates/data_scales.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lacuna {
namespace {

constexpr double kSweepInterval = 0.01;    // s
constexpr Eigen::Index kSweepRows = 1001;  // 10 s

/// A sweep up and down at this speed, read as a position or, where `of_speed`, as the speed itself.
Trial sweep(double speed, const std::string& unit, bool of_speed = false) {
  Trial trial;
  trial.measured.times =
      Eigen::VectorXd::LinSpaced(kSweepRows, 0.0, kSweepInterval * static_cast<double>(kSweepRows - 1));
  trial.measured.channels = {{"x", of_speed ? unit + "/s" : unit}};
  trial.measured.samples.resize(kSweepRows, 1);
  for (Eigen::Index row = 0; row < kSweepRows; ++row) {
    const double t = trial.measured.times(row);
    trial.measured.samples(row, 0) = of_speed ? (t < 5.0 ? speed : -speed) : speed * (5.0 - std::abs(t - 5.0));
  }
  return trial;
}

TEST(DataScales, AreRangeAndUsualSpeed) {
  const auto scales = data_scales({sweep(0.2, "m")});
  EXPECT_NEAR(scales.at("m"), 1.0, 1e-9);
  EXPECT_NEAR(scales.at("m/s"), 0.2, 1e-9);
}

TEST(DataScales, HoldTheWayOfAChannelThatReadsSpeed) {
  EXPECT_NEAR(data_scales({sweep(0.2, "m", true)}).at("m"), 1.0, 0.01);
}

/// Between rare readings at high speed waves pass that nobody sees.
TEST(DataScales, HoldTheWavesThatReadingsResolve) {
  EXPECT_NEAR(data_scales({sweep(0.2, "m")}).at("1/m"), 100.0, 1e-6) << "no more than a search tries";
  EXPECT_NEAR(data_scales({sweep(0.2, "m"), sweep(0.002, "m")}).at("1/m"), 100.0, 1e-6) << "beside a slow one";
}

TEST(DataScales, KeepTheWavesOfATurnHoweverFarAnAngleGoes) {
  EXPECT_NEAR(data_scales({sweep(2.0, "rad")}).at("1/rad"), 24.0, 1e-6);
  EXPECT_NEAR(data_scales({sweep(200.0, "rad")}).at("1/rad"), 2.0 * std::numbers::pi / (4.0 * kSweepInterval * 200.0),
              1e-6);
}

TEST(DataScales, AreThereWhereReadingsAreRare) {
  Trial rare = sweep(1.0, "m");
  rare.measured.times *= 10.0;  // 0.1 s apart
  EXPECT_NEAR(data_scales({rare}).at("m/s"), 0.1, 1e-9);
}

FreeValue waves(const std::string& unit) { return {{"effect.x.periods", unit, 0.001, 1e5, 0.5, Scale::logarithmic}}; }

TEST(BoundByResolution, LeavesAWaveThatRepeatsAndThatReadingsShow) {
  const auto scales = data_scales({sweep(0.2, "m")});
  EffectEntry entry;
  entry.id = "x";
  std::vector<FreeValue> free = {waves("1/m"), waves("1/m")};
  free[1].address = "effect.other.periods";
  bound_by_resolution({entry}, scales, free);
  EXPECT_NEAR(free[0].lower, 2.0 * std::numbers::pi, 1e-6);
  EXPECT_NEAR(free[0].upper, 100.0, 1e-6);
  EXPECT_EQ(free[0].start, free[0].lower);
  EXPECT_EQ(free[1].upper, 1e5) << "of an effect that the model has";
}

TEST(BoundByResolution, LeavesOnceATurnOfAnAngle) {
  EffectEntry entry;
  entry.id = "x";
  std::vector<FreeValue> free = {waves("1/rad")};
  bound_by_resolution({entry}, data_scales({sweep(0.2, "rad")}), free);
  EXPECT_EQ(free[0].lower, 1.0);
}

/// Not even one wave a turn is seen: the value stays at one, and cannot move.
TEST(BoundByResolution, HoldsWhatCannotBeResolved) {
  EffectEntry entry;
  entry.id = "x";
  std::vector<FreeValue> free = {waves("1/rad")};
  bound_by_resolution({entry}, data_scales({sweep(200.0, "rad")}), free);
  EXPECT_EQ(free[0].lower, 1.0);
  EXPECT_EQ(free[0].upper, 1.0);
}

TEST(ShapesToTry, AreWavesCloseEnoughThatNoneIsMissedBetweenTwo) {
  const auto scales = data_scales({sweep(0.2, "m")});
  const std::vector<double> tried = shapes_to_try("1/m", scales);
  ASSERT_GT(tried.size(), 20U);
  for (std::size_t i = 1; i < tried.size(); ++i) EXPECT_LT(tried[i] - tried[i - 1], std::numbers::pi + 1e-9);
}

}  // namespace
}  // namespace lacuna

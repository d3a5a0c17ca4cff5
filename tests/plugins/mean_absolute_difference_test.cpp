#include "plugins/built_catalog.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kScoreTolerance = 1e-15;  // of a handful of additions of order one

using Sample = std::array<double, 2>;

std::unique_ptr<ScoreAccumulator> accumulator(std::size_t samples) {
  return built_catalog().get<FitnessMetric>("mean_absolute_difference").accumulator({1, samples, 2}, {});
}

TEST(MeanAbsoluteDifference, IsTheMeanOverSamplesAndChannels) {
  const auto score = accumulator(2);
  score->add(Sample{1.0, 2.0}, Sample{1.5, 1.0});
  score->add(Sample{0.0, 0.0}, Sample{-0.25, 0.25});
  EXPECT_NEAR(score->score(), (0.5 + 1.0 + 0.25 + 0.25) / 4.0, kScoreTolerance);
  EXPECT_NEAR(score->bound(), score->score(), kScoreTolerance);
}

TEST(MeanAbsoluteDifference, MeasuredNanCountsForNothing) {
  const auto score = accumulator(2);
  score->add(Sample{1.0, 2.0}, Sample{kNan, 1.0});
  score->add(Sample{3.0, 7.0}, Sample{1.0, kNan});
  EXPECT_NEAR(score->score(), (1.0 + 2.0) / 2.0, kScoreTolerance);
}

TEST(MeanAbsoluteDifference, BoundNeverFallsAndNeverExceedsTheScore) {
  constexpr std::size_t kSamples = 200;
  const auto score = accumulator(kSamples);
  std::vector<double> bounds;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double x = static_cast<double>(i);
    score->add(Sample{std::sin(x), std::cos(3.0 * x)}, Sample{std::sin(x) / (1.0 + x), i % 3 == 0 ? kNan : 0.1});
    bounds.push_back(score->bound());
  }
  EXPECT_TRUE(std::is_sorted(bounds.begin(), bounds.end()));
  EXPECT_GT(bounds.front(), 0.0 - kScoreTolerance);
  EXPECT_LE(bounds.back(), score->score() + kScoreTolerance);
  EXPECT_LT(bounds[kSamples / 2], score->score());
}

TEST(MeanAbsoluteDifference, APredictionThatIsNoNumberIsInfinitelyBad) {
  const auto score = accumulator(1);
  score->add(Sample{kNan, 1.0}, Sample{0.0, 1.0});
  EXPECT_TRUE(std::isinf(score->score()));
  EXPECT_TRUE(std::isinf(score->bound()));
}

TEST(MeanAbsoluteDifference, ComparingNothingIsNoSuccess) { EXPECT_TRUE(std::isinf(accumulator(1)->score())); }

TEST(MeanAbsoluteDifference, ResetForgetsEverything) {
  const auto score = accumulator(1);
  score->add(Sample{kNan, 1.0}, Sample{0.0, kNan});
  score->reset();
  score->add(Sample{1.0, 1.0}, Sample{0.0, 1.0});
  EXPECT_EQ(score->score(), 0.5);
}

TEST(MeanAbsoluteDifference, RefusesSamplesOfAnotherSize) {
  const auto score = accumulator(1);
  EXPECT_THAT(
      [&] {
        score->add(std::array{1.0}, Sample{0.0, 1.0});
      },
      ThrowsMessage<Error>(HasSubstr("1 predicted and 2 measured values instead of 2")));
}

}  // namespace
}  // namespace lacuna

#include "fitting/numerics/seeded_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace lacuna::seeded_noise_test {
namespace {

constexpr int kDraws = 20000;
constexpr double kFour = 4.0;  // standard errors

/// Mean and mean square.
template <class Draw>
std::pair<double, double> moments(Draw draw) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = draw();
    sum += value;
    squares += value * value;
  }
  return {sum / kDraws, squares / kDraws};
}

TEST(SeededNoise, IsNormal) {
  SeededNoise random(1, 1);
  const auto [mean, square] = moments([&] { return random.normal(); });
  EXPECT_NEAR(mean, 0.0, kFour / std::sqrt(kDraws));
  EXPECT_NEAR(square, 1.0, kFour * std::sqrt(2.0 / kDraws));
}

TEST(SeededNoise, IsUniformWithinItsBounds) {
  SeededNoise random(1, 1);
  const auto [mean, square] = moments([&] {
    const double value = random.uniform(-1.0, 3.0);
    EXPECT_TRUE(value > -1.0 && value < 3.0);
    return value;
  });
  const double deviation = 4.0 / std::sqrt(12.0);
  EXPECT_NEAR(mean, 1.0, kFour * deviation / std::sqrt(kDraws));
  EXPECT_NEAR(square - mean * mean, deviation * deviation, 0.05 * deviation * deviation);
}

/// By splitmix64 in another language: results of seeds are kept.
TEST(SeededNoise, GivesTheNumbersOfItsSeedAndStreamOnEveryMachine) {
  SeededNoise random(1, 2);
  EXPECT_EQ(random.uniform(), 0.8258775552138216);
  EXPECT_EQ(random.uniform(), 0.8107846355627506);
}

TEST(SeededNoise, DiffersFromSeedToSeedAndFromStreamToStream) {
  const double one = SeededNoise(1, 1).uniform();
  EXPECT_EQ(SeededNoise(1, 1).uniform(), one);
  EXPECT_NE(SeededNoise(2, 1).uniform(), one);
  EXPECT_NE(SeededNoise(1, 2).uniform(), one);
}

}  // namespace
}  // namespace lacuna::seeded_noise_test

#include "eea/ensemble/ensemble_band.h"

#include <lacuna/random_stream.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

constexpr double kUpper95 = 1.959963984540054;
constexpr double kStudent2 = 4.302652729749464;  // 97.5 % quantile of Student's t with 2 degrees of freedom
constexpr double kRounding = 1e-12;

/// One sample of one channel, one a model.
std::vector<TimeSeries::Samples> models_that_say(const std::vector<double>& values) {
  std::vector<TimeSeries::Samples> predictions;
  for (const double value : values) predictions.push_back(TimeSeries::Samples::Constant(1, 1, value));
  return predictions;
}

TEST(EnsembleBand, IsStudentsForOneMoreModel) {
  const EnsembleBand band = band_of(models_that_say({1.0, 2.0, 3.0}), {0.0});
  EXPECT_NEAR(band.mean(0, 0), 2.0, kRounding);
  EXPECT_NEAR(band.half_width(0, 0), kStudent2 * std::sqrt(4.0 / 3.0), kRounding) << "the deviation is 1";
}

TEST(EnsembleBand, HasTheNoiseOfAReadingInQuadrature) {
  const EnsembleBand band = band_of(models_that_say({1.0, 2.0, 3.0}), {3.0});
  EXPECT_NEAR(band.half_width(0, 0), std::hypot(kStudent2 * std::sqrt(4.0 / 3.0), 3.0 * kUpper95), kRounding);
}

TEST(EnsembleBand, OfOneModelIsTheNoiseAlone) {
  const EnsembleBand band = band_of(models_that_say({5.0}), {0.5});
  EXPECT_EQ(band.mean(0, 0), 5.0);
  EXPECT_NEAR(band.half_width(0, 0), 0.5 * kUpper95, kRounding);
}

TEST(EnsembleBand, DoesWithoutNoiseThatNobodyKnows) {
  const EnsembleBand band = band_of(models_that_say({1.0, 2.0, 3.0}), {std::numeric_limits<double>::infinity()});
  EXPECT_NEAR(band.half_width(0, 0), kStudent2 * std::sqrt(4.0 / 3.0), kRounding);
}

TEST(EnsembleBand, HoldsAReadingOfAnotherModelOfItsKindWith95Percent) {
  constexpr int kDraws = 20000;
  constexpr double kNoise = 1e-6, kTolerance = 0.005;  // three deviations of the share
  RandomStream random(std::array<std::uint64_t, 1>{7});
  int inside = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const EnsembleBand band =
        band_of(models_that_say({random.normal(), random.normal(), random.normal(), random.normal()}), {kNoise});
    inside += std::abs(random.normal() - band.mean(0, 0)) <= band.half_width(0, 0) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(inside) / kDraws, 0.95, kTolerance);
}

}  // namespace
}  // namespace lacuna

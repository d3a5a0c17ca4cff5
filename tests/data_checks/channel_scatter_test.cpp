#include "data_checks/channel_scatter.h"

#include "fitting/numerics/seeded_noise.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

TimeSeries series_of(const std::vector<double>& values, double interval = 0.1) {
  TimeSeries series;
  series.channels = {{"angle", "rad"}};
  series.times.resize(static_cast<Eigen::Index>(values.size()));
  series.samples.resize(static_cast<Eigen::Index>(values.size()), 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    series.times(static_cast<Eigen::Index>(i)) = interval * static_cast<double>(i);
    series.samples(static_cast<Eigen::Index>(i), 0) = values[i];
  }
  return series;
}

/// 1 off the line of its neighbours, which white noise of deviation s is by √1.5 s.
TEST(Scatter, IsTheDistanceFromTheLineOfTheNeighbours) {
  EXPECT_NEAR(scatter_of(series_of({0.0, 1.0, 0.0}), 0), 1.0 / std::sqrt(1.5), 1e-12);
}

TEST(Scatter, IsTheDeviationOfWhiteNoise) {
  SeededNoise random(3, 0);
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i) values.push_back(0.02 * i + 0.05 * random.normal());
  EXPECT_NEAR(scatter_of(series_of(values), 0), 0.05, 0.001);
}

TEST(Scatter, IsZeroOnALineWhateverItsSlope) {
  EXPECT_NEAR(scatter_of(series_of({0.0, 2.0, 4.0, 6.0, 8.0}), 0), 0.0, 1e-12);
}

TEST(Scatter, IsZeroWithFewerThanThreeReadings) {
  EXPECT_EQ(scatter_of(series_of({0.0, 5.0}), 0), 0.0);
  EXPECT_EQ(scatter_of(series_of({0.0, std::nan(""), 5.0}), 0), 0.0);
}

}  // namespace
}  // namespace lacuna

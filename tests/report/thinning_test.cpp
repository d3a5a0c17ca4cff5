#include "report/figures/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lacuna {
namespace {

TEST(Thinned, KeepsShortLinesWhole) { EXPECT_EQ(thinned({3.0, 1.0, 2.0}, 10), (std::vector<std::size_t>{0, 1, 2})); }

TEST(Thinned, KeepsEverySpikeOfALongLine) {
  std::vector<double> y(100000, 0.0);
  y[12345] = 7.0;
  y[77777] = -7.0;
  const std::vector<std::size_t> kept = thinned(y, 500);
  EXPECT_LE(kept.size(), 4u * 500u);
  EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 12345u));
  EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 77777u));
  EXPECT_EQ(kept.front(), 0u);
  EXPECT_EQ(kept.back(), y.size() - 1);
}

TEST(Thinned, KeepsGaps) {
  std::vector<double> y(100000, 1.0);
  std::fill(y.begin() + 40000, y.begin() + 40010, std::numeric_limits<double>::quiet_NaN());
  const std::vector<std::size_t> kept = thinned(y, 500);
  EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [&](std::size_t i) { return std::isnan(y[i]); }));
}

}  // namespace
}  // namespace lacuna

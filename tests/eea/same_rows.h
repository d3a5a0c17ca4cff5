#pragma once

#include "eea/definition/eea_journal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lacuna {

/// Equal to the last bit; NaN equals NaN.
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}
inline bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) { return same(x, y); });
}

inline void expect_same_models(const std::vector<ModelRow>& a, const std::vector<ModelRow>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].number, b[i].number);
    EXPECT_EQ(a[i].parents, b[i].parents);
    EXPECT_EQ(a[i].generation, b[i].generation);
    EXPECT_EQ(a[i].kind, b[i].kind);
    EXPECT_EQ(a[i].reused, b[i].reused);
    EXPECT_TRUE(same(a[i].genome, b[i].genome));
    EXPECT_TRUE(same(a[i].score, b[i].score));
    EXPECT_TRUE(same(a[i].trial_scores, b[i].trial_scores));
  }
}

inline void expect_same_tests(const std::vector<TestRow>& a, const std::vector<TestRow>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].number, b[i].number);
    EXPECT_TRUE(same(a[i].genome, b[i].genome));
    EXPECT_TRUE(same(a[i].fitness, b[i].fitness));
  }
}

}  // namespace lacuna

#include "foundation/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace lacuna {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
  std::vector<int> visits(1000, 0);
  parallel_for(visits.size(), 3, [&](std::size_t index, int) { ++visits[index]; });
  EXPECT_EQ(visits, std::vector<int>(1000, 1));
}

TEST(ParallelFor, ThrowsTheFailureOfTheSmallestIndex) {
  try {
    parallel_for(100, 2, [](std::size_t index, int) {
      if (index == 20 || index == 70) throw std::runtime_error(std::to_string(index));
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "20");
  }
}

}  // namespace
}  // namespace lacuna

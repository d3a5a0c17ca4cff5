#include "foundation/name_index.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lacuna {
namespace {

TEST(NameIndex, FindsTheFirstOfANameAndCountsAll) {
  const std::vector<std::string> names = {"angle", "speed", "angle"};
  const NameIndex index(names);
  EXPECT_EQ(index.find("angle"), 0U);
  EXPECT_EQ(index.count("angle"), 2U);
  EXPECT_EQ(index.find("speed"), 1U);
  EXPECT_EQ(index.find("torque"), std::nullopt);
  EXPECT_EQ(index.count("torque"), 0U);
}

}  // namespace
}  // namespace lacuna

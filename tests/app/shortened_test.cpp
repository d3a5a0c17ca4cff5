#include "app/mcp/shortened.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lacuna {
namespace {

using nlohmann::ordered_json;

TEST(Shortened, LeavesOutLongListsOfNumbersWhereverTheyStand) {
  const ordered_json result = {{"short", {1, 2, 3}}, {"deep", {{"times", std::vector<double>(33, 0.5)}}}};
  EXPECT_EQ(shortened(result), ordered_json({{"short", {1, 2, 3}}, {"deep", {{"times", "33 numbers, left out"}}}}));
}

TEST(Shortened, SaysHowManyRowsItLeavesOut) {
  const ordered_json rows(std::vector<ordered_json>(203, {{"n", 1}}));
  const ordered_json kept = shortened(rows);
  ASSERT_EQ(kept.size(), 201U);
  EXPECT_EQ(kept.back(), "3 more, left out");
}

TEST(Shortened, SaysHowLongAMemberIsThatIsTooLong) {
  const ordered_json kept = shortened({{"page", std::string(300000, 'x')}, {"n", 1}});
  EXPECT_EQ(kept["n"], 1);
  EXPECT_THAT(kept["page"].get<std::string>(), testing::StartsWith("300002 bytes, left out"));
}

}  // namespace
}  // namespace lacuna

#include "command_line/whole_number.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(WholeNumber, TakesItsRangeAndNothingElse) {
  const CLI::Validator validator = whole_number(1, 10);
  const auto refused = [&](std::string text) { return !validator(text).empty(); };
  for (const char* text : {"1", "7", "10"}) EXPECT_FALSE(refused(text)) << text;
  for (const char* text : {"0", "11", "-3", "2.0", "x", "", "1e1", " 3", "99999999999999999999999"})
    EXPECT_TRUE(refused(text)) << text;
}

TEST(WholeNumber, ReachesTheLargestSeed) {
  std::string largest = "18446744073709551615", beyond = "18446744073709551616";
  EXPECT_TRUE(whole_number(0)(largest).empty());
  EXPECT_FALSE(whole_number(0)(beyond).empty());
}

}  // namespace
}  // namespace lacuna

#include "foundation/text/code_points.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(CodePoints, AreThoseOfWellFormedText) {
  EXPECT_EQ(code_points("aµ−\xF0\x9F\xA4\x96"), U"aµ−\U0001F916");
  EXPECT_EQ(code_points(""), U"");
}

TEST(CodePoints, StandForEachByteThatIsNoCharacter) {
  EXPECT_EQ(code_points("a\xFF\xC2"), U"a\uFFFD\uFFFD");
  EXPECT_EQ(code_points("\xE0\x80\x80"), U"\uFFFD\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(code_points("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD") << "half of a surrogate pair";
}

TEST(CodePoints, OfACharacterTakeSoManyBytes) {
  EXPECT_EQ(bytes_of_character("a"), 1U);
  EXPECT_EQ(bytes_of_character("µm"), 2U);
  EXPECT_EQ(bytes_of_character("−"), 3U);
  EXPECT_EQ(bytes_of_character("\x80"), 0U);
  EXPECT_EQ(bytes_of_character(""), 0U);
}

}  // namespace
}  // namespace lacuna

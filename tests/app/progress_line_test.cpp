#include "app/progress_line.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(FirstCharacters, CutsBetweenCharactersAndNotInThem) {
  EXPECT_EQ(first_characters("pass 1 · best", 8), "pass 1 ·");
  EXPECT_EQ(first_characters("pass 1 · best", 7), "pass 1 ");
  EXPECT_EQ(first_characters("short", 80), "short");
  EXPECT_EQ(first_characters("short", 5), "short");
  EXPECT_EQ(first_characters("short", 0), "");
}

}  // namespace
}  // namespace lacuna

#include "app/terminal/text_diff.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

TEST(TextDiff, ShowsTheChangedLineWithItsSurroundings) {
  EXPECT_EQ(text_diff("a\nb\nc\nd\ne\nf\n", "a\nb\nc\nD\ne\nf\n"),
            "    2   b\n    3   c\n    4 - d\n    4 + D\n    5   e\n    6   f\n");
}

TEST(TextDiff, ShowsInsertedLines) { EXPECT_EQ(text_diff("a\nc\n", "a\nb\nc\n"), "    1   a\n    2 + b\n    3   c\n"); }

TEST(TextDiff, IsEmptyForEqualTexts) { EXPECT_EQ(text_diff("a\n", "a\n"), ""); }

TEST(TextDiff, DoesNotCountRepeatedLinesTwice) {
  EXPECT_EQ(text_diff("a\na\n", "a\na\na\n"), "    1   a\n    2   a\n    3 + a\n");
}

}  // namespace
}  // namespace lacuna

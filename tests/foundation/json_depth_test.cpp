#include "foundation/text/json_depth.h"

#include <lacuna/error.h>

#include <gtest/gtest.h>

namespace lacuna {
namespace {

std::string nested(int depth, const std::string& open, const std::string& close) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += open;
  text += "1";
  for (int i = 0; i < depth; ++i) text += close;
  return text;
}

TEST(JsonDepth, CountsArraysAndObjects) {
  EXPECT_FALSE(nests_too_deep(nested(kDeepestJson, "[", "]")));
  EXPECT_TRUE(nests_too_deep(nested(kDeepestJson + 1, "[", "]")));
  EXPECT_FALSE(nests_too_deep(nested(kDeepestJson, R"({"a": )", "}")));
  EXPECT_TRUE(nests_too_deep(nested(kDeepestJson + 1, R"({"a": )", "}")));
  EXPECT_TRUE(nests_too_deep(nested(kDeepestJson / 2 + 1, R"([{"a": )", "}]")));
}

TEST(JsonDepth, ManyBesideEachOtherAreNotDeep) {
  std::string list = "[0";
  for (int i = 0; i < 10 * kDeepestJson; ++i) list += ", [{}]";
  EXPECT_FALSE(nests_too_deep(list + "]"));
}

TEST(JsonDepth, BracketsInTextsAreNone) {
  const std::string brackets(10 * kDeepestJson, '[');
  EXPECT_FALSE(nests_too_deep("[\"" + brackets + "\"]"));
  EXPECT_FALSE(nests_too_deep(R"(["a\"b)" + brackets + "\"]"));
  EXPECT_FALSE(nests_too_deep("\"" + brackets)) << "a text without an end";
  EXPECT_FALSE(nests_too_deep("\"\\")) << "nor a sign behind its last one";
  EXPECT_TRUE(nests_too_deep(R"(["a\\")" + brackets));
}

TEST(JsonDepth, WhatIsDeepIsRefusedWithASentence) {
  EXPECT_EQ(shallow_json("[1]"), "[1]");
  EXPECT_THROW(shallow_json(std::string(80'000, '[')), Error);
}

}  // namespace
}  // namespace lacuna

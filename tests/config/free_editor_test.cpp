#include "config/edits/free_editor.h"

#include "foundation/text/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::HasSubstr;

const FreeRange kArmature{"joint.hinge.armature", 0.002, 0.2, 0.01};
constexpr const char* kLine = R"("joint.hinge.armature" = { range = [0.002, 0.2], start = 0.01 })";

/// A text before and after; "@" stands for the value's line.
struct FreeLayout {
  const char* name;
  const char* before;
  const char* after;
};

void PrintTo(const FreeLayout& layout, std::ostream* stream) { *stream << layout.name; }

std::string with_line(std::string text) { return text.replace(text.find('@'), 1, kLine); }

class EveryFreeLayout : public testing::TestWithParam<FreeLayout> {};

TEST_P(EveryFreeLayout, TakesAValueInAndGivesItBackByteForByte) {
  const std::string inserted = insert_free_value(GetParam().before, kArmature);
  EXPECT_EQ(inserted, with_line(GetParam().after));
  EXPECT_EQ(remove_free_value(inserted, kArmature.pattern), GetParam().before);
}

const FreeLayout kFreeLayouts[] = {
    {"none", "[model]\nfile = 'a'\n\n[engine]\nstep = 1\n",
     "[model]\nfile = 'a'\n\n[engine]\nstep = 1\n\n[model.free]\n@\n"},
    {"carriage_returns", "[model]\r\nx = 1\r\n", "[model]\r\nx = 1\r\n\r\n[model.free]\r\n@\r\n"},
    {"section", "[model.free]\n\"a.b\" = [0, 1]  # why\n\n[engine]\nstep = 1\n",
     "[model.free]\n\"a.b\" = [0, 1]  # why\n@\n\n[engine]\nstep = 1\n"},
    {"section_with_margin", "[model]\n[model.free]\n  \"a.b\" = [0, 1]\n",
     "[model]\n[model.free]\n  \"a.b\" = [0, 1]\n  @\n"},
    {"braces", "[model]\nfree = { \"a.b\" = [0, 1] }  # c\n", "[model]\nfree = { \"a.b\" = [0, 1], @ }  # c\n"},
};

INSTANTIATE_TEST_SUITE_P(FreeEditor, EveryFreeLayout, testing::ValuesIn(kFreeLayouts),
                         [](const auto& layout) { return layout.param.name; });

TEST(FreeEditor, LeavesAnEmptyTableInBraces) {
  const std::string inserted = insert_free_value("model = { x = 1 }\n", kArmature);
  EXPECT_EQ(inserted, with_line("model = { x = 1, free = { @ } }\n"));
  EXPECT_EQ(remove_free_value(inserted, kArmature.pattern), "model = { x = 1, free = {} }\n");
}

TEST(FreeEditor, SaysWhatCannotBe) {
  const auto insertion = [](const std::string& text) {
    try {
      insert_free_value(text, kArmature);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(insertion("[engine]\n"), HasSubstr("there is no section [model]"));
  EXPECT_THAT(insertion("[model]\nfree = 3\n"), HasSubstr("model.free is not a table"));
  EXPECT_THAT(insertion("[model.free]\n\"joint.hinge.armature\" = [0, 1]\n"),
              HasSubstr("has joint.hinge.armature already"));
  EXPECT_THAT(insertion("[model]\nfree.\"a.b\" = [0, 1]\n[engine]\nx = 1\n"),
              testing::AnyOf(HasSubstr("by hand"), testing::IsEmpty()));
  EXPECT_THROW(remove_free_value("[model]\nx = 1\n", "a.b"), Error);
}

}  // namespace
}  // namespace lacuna

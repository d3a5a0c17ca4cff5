#include "config/edits/effects_editor.h"

#include "foundation/text/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lacuna {
namespace {

using testing::HasSubstr;

const EffectEntry kFriction{"friction", "coulomb_friction", {"joint.hinge"}, {{"torque", 0.1}}, {}};
constexpr const char* kItem =
    R"({ id = "friction", effect = "coulomb_friction", where = "joint.hinge", start = { torque = 0.1 } })";

/// A text with a mark where the effect stands: "@" for the item, "@," ... are written out by the case.
struct Layout {
  const char* name;
  const char* before;
  const char* after;  ///< "@" stands for the item
};

std::string with_item(std::string text) {
  for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@')) text.replace(at, 1, kItem);
  return text;
}

void PrintTo(const Layout& layout, std::ostream* stream) { *stream << layout.name; }

class EveryLayout : public testing::TestWithParam<Layout> {};

TEST_P(EveryLayout, TakesAnEffectInAndGivesItBackByteForByte) {
  const std::string inserted = insert_effect(GetParam().before, kFriction);
  EXPECT_EQ(inserted, with_item(GetParam().after));
  EXPECT_EQ(remove_effect(inserted, "friction"), GetParam().before);
}

const Layout kLayouts[] = {
    {"empty_list", "[model]\neffects = []  # the revision\nx = 1\n",
     "[model]\neffects = [\n  @,\n]  # the revision\nx = 1\n"},
    {"empty_list_without_final_line_end", "[model]\neffects = []", "[model]\neffects = [\n  @,\n]"},
    {"carriage_returns", "[model]\r\neffects = []\r\nx = 1\r\n", "[model]\r\neffects = [\r\n  @,\r\n]\r\nx = 1\r\n"},
    {"list_of_a_comment", "[model]\neffects = [\n  # none yet\n]\n", "[model]\neffects = [\n  # none yet\n  @,\n]\n"},
    {"one_line", "[model]\neffects = [{ effect = \"a\" }]\n", "[model]\neffects = [{ effect = \"a\" }, @]\n"},
    {"one_line_with_blanks", "[model]\neffects = [ {effect='a'} ] # c\n",
     "[model]\neffects = [ {effect='a'}, @ ] # c\n"},
    {"one_line_with_last_comma", "[model]\neffects = [ {effect='a'}, ]\n", "[model]\neffects = [ {effect='a'}, @, ]\n"},
    {"lines", "[model]\neffects = [\n    {effect='a'},\n]\n", "[model]\neffects = [\n    {effect='a'},\n    @,\n]\n"},
    {"lines_without_last_comma", "[model]\neffects = [\n  {effect='a'}\n]\n",
     "[model]\neffects = [\n  {effect='a'},\n  @\n]\n"},
    {"lines_with_comments", "[model]\neffects = [ # why\n\t{effect='a'}, # first, of [two]\n\t# old\n\n]\n",
     "[model]\neffects = [ # why\n\t{effect='a'}, # first, of [two]\n\t@,\n\t# old\n\n]\n"},
    {"lines_with_comment_without_last_comma", "[model]\neffects = [\n  {effect='a'} # c\n]\n",
     "[model]\neffects = [\n  {effect='a'}, # c\n  @\n]\n"},
    {"lines_with_carriage_returns", "[model]\r\neffects = [\r\n  {effect='a'},\r\n]\r\n",
     "[model]\r\neffects = [\r\n  {effect='a'},\r\n  @,\r\n]\r\n"},
    {"bracket_behind_the_item", "[model]\neffects = [\n  {effect='a'} ]\n",
     "[model]\neffects = [\n  {effect='a'},\n  @ ]\n"},
    {"nested_lists_and_strings", "[model]\neffects = [{ effect = \"a\", where = [\"],}\", '#'], start = { p = 1 } }]\n",
     "[model]\neffects = [{ effect = \"a\", where = [\"],}\", '#'], start = { p = 1 } }, @]\n"},
    {"not_ascii_and_byte_order_mark",
     "\xEF\xBB\xBF# Gr\xC3\xB6\xC3\x9F"
     "e\n[model]\nx = \"\xE2\x82\xAC\"\neffects = [{effect='\xC3\xA4'}]\n",
     "\xEF\xBB\xBF# Gr\xC3\xB6\xC3\x9F"
     "e\n[model]\nx = \"\xE2\x82\xAC\"\neffects = [{effect='\xC3\xA4'}, @]\n"},
    {"list_in_an_inline_table", "model = { robot = \"r\", effects = [{effect='a'}] }\n",
     "model = { robot = \"r\", effects = [{effect='a'}, @] }\n"},
    {"dotted_key", "model.robot = \"r\"\nmodel.effects = [\n  {effect='a'},\n]\n",
     "model.robot = \"r\"\nmodel.effects = [\n  {effect='a'},\n  @,\n]\n"},
};
INSTANTIATE_TEST_SUITE_P(EffectsEditor, EveryLayout, testing::ValuesIn(kLayouts),
                         [](const auto& tested) { return tested.param.name; });

constexpr const char* kSection =
    "[[model.effects]]\nid = \"friction\"\neffect = \"coulomb_friction\"\nwhere = \"joint.hinge\"\n"
    "start = { torque = 0.1 }";

TEST(EffectsEditor, AddsASectionBehindSections) {
  const std::string before =
      "[model]\nrobot = \"r\"\n\n[[model.effects]]\neffect = \"a\"  # first\n[model.effects.start]\np = 1 # one\n\n"
      "# fit\n[fit]\nstarts = 2";
  const std::string inserted = insert_effect(before, kFriction);
  EXPECT_EQ(inserted,
            "[model]\nrobot = \"r\"\n\n[[model.effects]]\neffect = \"a\"  # first\n[model.effects.start]\n"
            "p = 1 # one\n\n" +
                std::string(kSection) + "\n\n# fit\n[fit]\nstarts = 2");
  EXPECT_EQ(remove_effect(inserted, "friction"), before);
  EXPECT_EQ(remove_effect(inserted, "a"),
            "[model]\nrobot = \"r\"\n\n" + std::string(kSection) + "\n\n# fit\n[fit]\nstarts = 2");
}

TEST(EffectsEditor, AddsASectionAtTheEndOfATextWithoutFinalLineEnd) {
  const std::string before = "[model]\r\n[[model.effects]]\r\neffect = \"a\"";
  const std::string inserted = insert_effect(before, kFriction);
  EXPECT_THAT(inserted, HasSubstr("effect = \"a\"\r\n\r\n[[model.effects]]\r\nid = \"friction\"\r\n"));
  EXPECT_EQ(remove_effect(inserted, "friction"), before);
}

TEST(EffectsEditor, AddsTheKeyWhereItIsMissing) {
  EXPECT_EQ(insert_effect("[model]\nrobot = \"r\" # which\n\n[model.set]\nx = 1\n[fit]\n", kFriction),
            with_item("[model]\nrobot = \"r\" # which\neffects = [\n  @,\n]\n\n[model.set]\nx = 1\n[fit]\n"));
  EXPECT_EQ(insert_effect("[model]", kFriction), with_item("[model]\neffects = [\n  @,\n]"));
  EXPECT_EQ(insert_effect("model = { robot = \"r\" }\n", kFriction),
            with_item("model = { robot = \"r\", effects = [@] }\n"));
  EXPECT_EQ(insert_effect("model.robot = \"r\"\n[fit]\n", kFriction),
            with_item("model.robot = \"r\"\nmodel.effects = [\n  @,\n]\n[fit]\n"));
}

TEST(EffectsEditor, RemovesFromTheMiddleAndTheFront) {
  const std::string lines =
      "[model]\neffects = [\n  {effect='a'}, # one\n  {effect='b'}, # two\n  {effect='c'} # three\n]\n";
  EXPECT_EQ(remove_effect(lines, "a"), "[model]\neffects = [\n  {effect='b'}, # two\n  {effect='c'} # three\n]\n");
  EXPECT_EQ(remove_effect(lines, "b"), "[model]\neffects = [\n  {effect='a'}, # one\n  {effect='c'} # three\n]\n");
  EXPECT_EQ(remove_effect(lines, "c"), "[model]\neffects = [\n  {effect='a'}, # one\n  {effect='b'} # two\n]\n");
  const std::string line = "[model]\neffects = [{effect='a'}, {effect='b'}, {effect='c'}]\n";
  EXPECT_EQ(remove_effect(line, "a"), "[model]\neffects = [{effect='b'}, {effect='c'}]\n");
  EXPECT_EQ(remove_effect(line, "b"), "[model]\neffects = [{effect='a'}, {effect='c'}]\n");
  EXPECT_EQ(remove_effect(line, "c"), "[model]\neffects = [{effect='a'}, {effect='b'}]\n");
  const std::string commas_first = "[model]\neffects = [\n    {effect='a'}\n  , {effect='b'}\n]\n";
  EXPECT_EQ(remove_effect(commas_first, "b"), "[model]\neffects = [\n    {effect='a'}\n  \n]\n");
  EXPECT_EQ(remove_effect(commas_first, "a"), "[model]\neffects = [\n    {effect='b'}\n]\n");
}

TEST(EffectsEditor, WritesAnEffectThatReadsBackTheSame) {
  const EffectEntry full{
      "my-id",    "stribeck_friction", {"joint.a", "joint.*"}, {{"a", 0.1}, {"b", 1.0 / 3.0}, {"c", 2.0}},
      {"a", "b"}, {{"c", {0.5, 3.0}}}};
  EXPECT_EQ(
      effect_as_toml(full),
      "{ id = \"my-id\", effect = \"stribeck_friction\", where = [\"joint.a\", \"joint.*\"], "
      "start = { a = 0.1, b = 0.3333333333333333, c = 2.0 }, fixed = [\"a\", \"b\"], range = { c = [0.5, 3.0] } }");
  EXPECT_NO_THROW(insert_effect("[model]\neffects = []\n", full));
}

TEST(EffectsEditor, KeepsWhatIsOptional) {
  EffectEntry optional = kFriction;
  optional.optional = true;
  EXPECT_THAT(effect_as_toml(optional), HasSubstr(", optional = true }"));
  EXPECT_THAT(effect_as_toml(kFriction), testing::Not(HasSubstr("optional")));
  const std::string before = "[model]\n[[model.effects]]\neffect = \"a\"\noptional = true\n";
  const std::string inserted = insert_effect(before, optional);
  EXPECT_THAT(inserted, HasSubstr("start = { torque = 0.1 }\noptional = true\n"));
  EXPECT_EQ(remove_effect(inserted, "friction"), before);
}

std::string complaint_of_editing(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no complaint_of_editing";
}

TEST(EffectsEditor, RefusesWhatItCannotDo) {
  const std::string text = "[model]\neffects = [{ effect = \"friction\" }]\n";
  EXPECT_THAT(complaint_of_editing([&] { insert_effect(text, kFriction); }), HasSubstr("the id \"friction\" already"));
  EXPECT_THAT(complaint_of_editing([&] { remove_effect(text, "frictoin"); }), HasSubstr("did you mean \"friction\"?"));
  EXPECT_THAT(complaint_of_editing([] { insert_effect("[fit]\n", kFriction); }), HasSubstr("no section [model]"));
  EXPECT_THAT(complaint_of_editing([] { insert_effect("[model]\neffects = 3\n", kFriction); }),
              HasSubstr("is not a list"));
  EXPECT_THAT(complaint_of_editing([] { insert_effect("[model\n", kFriction); }), HasSubstr("not TOML"));
}

}  // namespace
}  // namespace lacuna

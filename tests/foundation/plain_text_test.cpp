#include "foundation/text/plain_text.h"

#include <gtest/gtest.h>

#include <string>

namespace lacuna {
namespace {

using namespace std::string_literals;

TEST(PlainText, LeavesCharactersAsTheyAre) {
  for (const char* text : {"", "sine.csv", "N·m", "`a` $b @c {d} \\e %f \"g\" 'h'", "日本", "\U0001F916"})
    EXPECT_EQ(plain_text(text), text);
}

TEST(PlainText, MakesSpacesOfControlCharacters) {
  EXPECT_EQ(plain_text("a\nb\rc\td\0e\x1B[31mf\x7Fg"s), "a b c d e [31mf g");
  EXPECT_EQ(plain_text("a\u0085b\u009Fc"), "a b c") << "those of the second kind, which begin lines and colours too";
}

TEST(PlainText, ReplacesWhatIsNoCharacter) {
  EXPECT_EQ(plain_text("caf\xE9"), "caf\uFFFD") << "Latin-1";
  EXPECT_EQ(plain_text("\xC3"), "\uFFFD") << "cut short";
  EXPECT_EQ(plain_text("\xC0\xA2"), "\uFFFD\uFFFD") << "a quote in two bytes";
  EXPECT_EQ(plain_text("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
  EXPECT_EQ(plain_text("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond the last";
  EXPECT_EQ(plain_text("\xEF\xBF\xBF"), "\uFFFD") << "not allowed in XML";
}

}  // namespace
}  // namespace lacuna

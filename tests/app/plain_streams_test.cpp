#include "app/terminal/plain_streams.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace lacuna {
namespace {

std::string made_plain(std::initializer_list<std::string> pieces) {
  PlainPieces stream;
  std::string all;
  for (std::string piece : pieces) {
    stream.make_plain(piece);
    all += piece;
  }
  return all;
}

TEST(PlainPiecesTest, KeepsTextAsItIs) {
  const std::string text = "pass 1\t· 20 µm → über\n";
  EXPECT_EQ(made_plain({text}), text);
}

TEST(PlainPiecesTest, LeavesNothingThatSteersATerminal) {
  EXPECT_EQ(made_plain({"a\x1B[31mb\rc\x7F"
                        "d\be"}),
            "a [31mb c d e");
  EXPECT_EQ(made_plain({"a\u009B31mb"}), "a\u00A031mb") << "the second kind of control characters";
}

TEST(PlainPiecesTest, KnowsCharactersThatComeInTwoPieces) {
  EXPECT_EQ(made_plain({"a\xC2", "\x9B"}), "a\u00A0");
  EXPECT_EQ(made_plain({"a\xC3", "\x9C"}), "a\u00DC");
}

}  // namespace
}  // namespace lacuna

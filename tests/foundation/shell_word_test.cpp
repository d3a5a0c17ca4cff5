#include "foundation/text/shell_word.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>

namespace lacuna {
namespace {

std::string as_a_shell_takes_it(const std::string& word) {
  const std::string command = "printf %s " + word;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::array<char, 256> text{};
  const std::size_t size = std::fread(text.data(), 1, text.size(), pipe.get());
  return {text.data(), size};
}

TEST(ShellWord, LeavesPlainWordsAsTheyAre) {
  for (const char* word : {"run", "walk.toml", "--db=/tmp/walk.db", "engine.step=0.001"})
    EXPECT_EQ(shell_word(word), word);
}

TEST(ShellWord, ComesBackFromAShell) {
  for (const char* word :
       {R"(model.free={"body.*.mass"=[1,7]})", "two words", "it's", "", "$HOME", "a\\b", "`id`", "*"})
    EXPECT_EQ(as_a_shell_takes_it(shell_word(word)), word);
}

TEST(ShellWord, StaysOnOneLine) { EXPECT_EQ(shell_word("it's\na\\b\x1B\x7F.db"), R"($'it\'s\012a\\b\033\177.db')"); }

}  // namespace
}  // namespace lacuna

#include "command_line/subcommands.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class HelpText : public testing::Test {
 protected:
  HelpText() {
    CLI::App* cases = program_.add_subcommand("cases", "Many");
    cases->add_subcommand("plan", "Say what will be done")->add_flag("--short");
    program_.add_subcommand("help")->callback([this] { answer_ = help_text(program_, {"cases"}); });
  }

  CLI::App program_{"A bench.", "bench"};
  std::string answer_;
};

TEST_F(HelpText, IsThatOfTheCommand) {
  EXPECT_THAT(help_text(program_, {"cases", "plan"}),
              testing::AllOf(HasSubstr("Usage: bench cases plan"), HasSubstr("--short")));
  EXPECT_EQ(help_text(program_, {}), program_.help());
}

TEST_F(HelpText, OfAnotherCommandIsNotThatOfTheOneThatAsks) {
  program_.parse("help");
  EXPECT_THAT(answer_, testing::AllOf(HasSubstr("Usage: bench cases"), HasSubstr("plan")));
}

TEST_F(HelpText, SuggestsTheNearestCommand) {
  EXPECT_THAT(
      [&] {
        help_text(program_, {"cases", "plam"});
      },
      ThrowsMessage<std::exception>("bench cases: there is no command \"plam\" (did you mean \"plan\"?); see "
                                    "bench cases --help"));
}

/// The command that a line asks the help of.
std::optional<std::vector<std::string>> explained(const CLI::App& program, std::vector<std::string> words) {
  words.insert(words.begin(), "bench");
  std::vector<char*> typed;
  for (std::string& word : words) typed.push_back(word.data());
  return command_to_explain(program, static_cast<int>(typed.size()), typed.data());
}

TEST_F(HelpText, IsAskedForWhereverTheOptionStands) {
  const std::vector<std::string> plan = {"cases", "plan"};
  EXPECT_EQ(explained(program_, {"cases", "plan", "no such file", "--help"}), plan);
  EXPECT_EQ(explained(program_, {"--help", "cases", "plan"}), plan);
  EXPECT_EQ(explained(program_, {"cases", "plan", "--short", "-h"}), plan);
  EXPECT_EQ(explained(program_, {"--help"}), std::vector<std::string>());
}

TEST_F(HelpText, IsNotAskedForByAnotherWordOrOfNoCommand) {
  EXPECT_EQ(explained(program_, {"cases", "plan", "help"}), std::nullopt);
  EXPECT_EQ(explained(program_, {"cases", "plan", "--", "--help"}), std::nullopt);
  EXPECT_EQ(explained(program_, {"cases", "plam", "--help"}), std::nullopt);
}

}  // namespace
}  // namespace lacuna

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

}  // namespace
}  // namespace lacuna

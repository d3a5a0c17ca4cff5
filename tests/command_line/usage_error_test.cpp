#include "command_line/usage_error.h"

#include "command_line/whole_number.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

/// What `bench cases run` and `bench cases plan` answer to words behind `bench`.
std::string answer_to(std::vector<std::string> words) {
  CLI::App program("", "bench");
  program.require_subcommand(1);
  CLI::App* cases = program.add_subcommand("cases");
  cases->require_subcommand(1);
  cases->add_subcommand("plan");
  CLI::App* run = cases->add_subcommand("run");
  std::string set, database, json;
  int jobs = 1;
  run->add_option("--set", set)->required();
  run->add_option("--db", database)->required();
  run->add_flag("--json{}", json, "Results")->option_text("[=FILE]");
  run->add_option("--jobs", jobs)->check(whole_number(1, 64));
  words.insert(words.begin(), "bench");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  const int count = static_cast<int>(arguments.size());
  try {
    program.parse(count, arguments.data());
  } catch (const CLI::ParseError& error) {
    return usage_sentence(program, error, count, arguments.data());
  }
  return "";
}

TEST(UsageSentence, NamesAllOptionsThatAreMissing) {
  EXPECT_EQ(answer_to({"cases", "run"}), "bench cases run: --set, --db are required; see bench cases run --help");
  EXPECT_EQ(answer_to({"cases", "run", "--set", "a"}), "bench cases run: --db is required; see bench cases run --help");
  EXPECT_EQ(answer_to({"cases", "run", "--set", "a", "--db", "b"}), "");
}

TEST(UsageSentence, NamesAnUnknownWordBeforeWhatIsMissing) {
  EXPECT_EQ(
      answer_to({"cases", "run", "--jbos", "2"}),
      "bench cases run: there is no option --jbos (did you mean \"--jobs\"?); --set, --db are required; see bench "
      "cases run --help");
  EXPECT_EQ(answer_to({"cases", "ran"}),
            "bench cases: there is no command \"ran\" (did you mean \"run\"?); see bench cases --help");
  EXPECT_EQ(answer_to({"cases"}), "bench cases: name a command: plan, run; see bench cases --help");
}

TEST(UsageSentence, OfAMisspeltOptionBeforeAnyCommandNamesTheOptionAlone) {
  EXPECT_EQ(answer_to({"--hlep"}), "bench: there is no option --hlep (did you mean \"--help\"?); see bench --help");
  EXPECT_EQ(answer_to({"cases", "--hlep"}),
            "bench cases: there is no option --hlep (did you mean \"--help\"?); see bench cases --help");
}

TEST(UsageSentence, SaysHowAValueThatMayBeLeftOutIsWritten) {
  EXPECT_EQ(answer_to({"cases", "run", "--set", "a", "--db", "b", "--json", "x.json"}),
            "bench cases run: one argument too many: x.json; if it belongs to --json, write --json=x.json; see bench "
            "cases run --help");
}

TEST(UsageSentence, SaysWhatANumberMayBe) {
  EXPECT_EQ(answer_to({"cases", "run", "--set", "a", "--db", "b", "--jobs", "0"}),
            "bench cases run: --jobs: must be a whole number from 1 to 64, but is \"0\"; see bench cases run --help");
}

}  // namespace
}  // namespace lacuna

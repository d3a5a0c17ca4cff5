#include "end_to_end/guide.h"

#include "end_to_end/printed_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace lacuna {
namespace {

/// The guides that take the small rig of experiments/first-steps.toml, a fit of which takes a second or two, an
/// experiment of experiments/smoke/, shortened, the robots and bags of experiments/bags/, or the tables of
/// experiments/classroom/.
class Guide : public testing::TestWithParam<const char*> {};

TEST_P(Guide, PrintsWhatItSays) {
  const Program program;
  program.copy_first_steps();
  program.copy_smoke();
  program.copy_bags();
  program.copy_classroom();
  follow_guide(GetParam(), program);
}

INSTANTIATE_TEST_SUITE_P(Guides, Guide,
                         testing::Values("docs/tutorials/first-steps.md", "docs/tutorials/find-the-missing-effect.md",
                                         "docs/how-to/use-your-own-csv.md", "docs/how-to/query-the-database.md",
                                         "docs/how-to/run-the-algorithm.md", "docs/how-to/choose-the-next-test.md",
                                         "docs/how-to/use-many-machines.md", "docs/reference/commands.md",
                                         "docs/reference/formulas.md", "docs/how-to/identify-an-arm-from-a-bag.md",
                                         "docs/how-to/identify-a-leg-from-a-bag.md",
                                         "docs/how-to/identify-a-pendulum-from-a-table.md"),
                         [](const auto& guide) {
                           const std::string path = guide.param;
                           const std::size_t begin = path.rfind('/') + 1;
                           return std::regex_replace(path.substr(begin, path.rfind('.') - begin), std::regex("-"), "_");
                         });

/// One compilation, against an installation.
TEST(WriteAPlugin, PrintsWhatItSays) {
  Program program;
  const Outcome installed = program.install("lacuna");
  ASSERT_EQ(installed.exit_code, 0) << installed.errors;
  follow_guide("docs/how-to/write-a-plugin.md", program);
}

/// The tutorial's commands are run above; README shows some of them, and of their output what matters most.
TEST(Readme, ShowsWhatTheTutorialShows) {
  const std::vector<GuideStep> tutorial = guide_steps(source_file("docs/tutorials/find-the-missing-effect.md"));
  const std::vector<GuideStep> shown = guide_steps(source_file("README.md"));
  ASSERT_GE(shown.size(), 5U);
  auto from = tutorial.begin();
  for (const GuideStep& step : shown) {
    SCOPED_TRACE("README.md:" + std::to_string(step.line));
    from = std::find_if(from, tutorial.end(), [&](const GuideStep& one) { return one.command == step.command; });
    ASSERT_NE(from, tutorial.end()) << "the tutorial does not show, at this place: " << step.command;
    EXPECT_EQ(difference(step.lines, from->lines, 0.0), "");
    ++from;
  }
}

/// Commands that `help` lists, each behind `before`.
std::vector<std::string> listed_commands(const std::string& help, const std::string& before) {
  std::vector<std::string> commands;
  bool inside = false;
  for (const std::string& line : lines_of(help)) {
    std::smatch found;
    if (inside && std::regex_match(line, found, std::regex("  ([a-z]+) .*")))
      commands.push_back(before + found[1].str());
    if (line == "Subcommands:") inside = true;
  }
  return commands;
}

TEST(CommandReference, HasTheHelpOfEveryCommand) {
  const Program program;
  std::vector<std::string> commands = listed_commands(program.run({"--help"}).output, "lacuna ");
  for (const std::string group : {"plugins", "task"}) {
    const auto of_group = listed_commands(program.run({group, "--help"}).output, "lacuna " + group + " ");
    commands.insert(commands.end(), of_group.begin(), of_group.end());
  }
  ASSERT_GE(commands.size(), 10U);
  const std::string text = source_file("docs/reference/commands.md");
  for (const std::string& command : commands) {
    if (command == "lacuna plugins") continue;  // its commands are
    EXPECT_THAT(text, testing::HasSubstr("\n$ " + command + " --help\n"));
    EXPECT_THAT(text, testing::HasSubstr("\n## `" + command + "`\n"));
  }
}

TEST(FirstStepsPicture, IsWhatCompareDraws) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program.run({"compare", "first-steps.toml", "--out", "pictures"}).exit_code, 0);
  const std::vector<std::string> shown = words_of_picture(source_file("docs/pictures/first-steps-rigid.svg"));
  ASSERT_THAT(shown, testing::Contains(testing::HasSubstr("chirp.csv (held out)")));
  EXPECT_EQ(difference(shown, words_of_picture(program.read("pictures/chirp.csv-angle.svg")), kFigureTolerance), "");
}

TEST(GuideSteps, AreCommandsWithTheirOutputAndEdits) {
  const std::vector<GuideStep> steps = guide_steps(
      "text\n```toml\na = 1\n```\n```toml rig.toml\nb = 2\n```\n```console\n$ lacuna x > y\nno\n(exit code 2)\n```\n");
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].file, "rig.toml");
  EXPECT_EQ(steps[0].lines, std::vector<std::string>{"b = 2"});
  EXPECT_EQ(steps[1].command, "lacuna x > y");
  EXPECT_EQ(steps[1].lines, std::vector<std::string>{"no"});
  EXPECT_EQ(steps[1].exit_code, 2);
}

TEST(GuideSteps, EditTheLinesThatSetTheSameKeys) {
  EXPECT_EQ(edited("# a = 1\nb = 2\nc = 3\n", {"b = 5", "new = 6", "a = 7"}), "a = 7\nb = 5\nnew = 6\nc = 3\n");
  EXPECT_THROW(edited("a = 1\n", {"b = 2"}), std::runtime_error);
}

}  // namespace
}  // namespace lacuna

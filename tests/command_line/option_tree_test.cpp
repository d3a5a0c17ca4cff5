#include "command_line/option_tree.h"

#include "command_line/completion.h"
#include "command_line/manual_page.h"

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lacuna {
namespace {

using testing::HasSubstr;

class OptionTree : public testing::Test {
 protected:
  OptionTree() {
    CLI::App* check = program_.add_subcommand("check", "Check a file");
    check->add_option("experiment", file_, "The file")->required()->option_text("FILE");
    check->add_option("--set", settings_, "A setting")->allow_extra_args(false)->option_text("KEY=VALUE");
    check->add_option("--among", settings_, "Some")->option_text("NAME ...");
    check->add_option("--threads", threads_, "Threads")->option_text("N");
    check->add_flag("--quiet", quiet_, "Print little");
    check->add_flag("--json{}", json_, "As JSON")->option_text("[=FILE]");
    program_.add_subcommand("plugins", "Plugins")->add_subcommand("list", "List - don't show");
    tree_ = option_tree(program_);
  }

  const OptionFacts& option(const std::string& name) const {
    for (const OptionFacts& one : tree_.at(1).options)
      if (one.name == name) return one;
    throw std::runtime_error("no option " + name);
  }

  CLI::App program_{"A bench.", "bench"};
  std::string file_;
  std::vector<std::string> settings_;
  int threads_ = 0;
  bool quiet_ = false;
  std::optional<std::string> json_;
  std::vector<CommandFacts> tree_;
};

TEST_F(OptionTree, HasEachCommandBeforeThoseBelowIt) {
  ASSERT_EQ(tree_.size(), 4U);
  EXPECT_EQ(tree_[0].subcommands, (std::vector<std::string>{"check", "plugins"}));
  EXPECT_EQ(tree_[3].words, (std::vector<std::string>{"plugins", "list"}));
  EXPECT_TRUE(stands_below(tree_[3], tree_[2]));
  EXPECT_FALSE(stands_below(tree_[3], tree_[0]));
}

TEST_F(OptionTree, KnowsWhatOptionsTake) {
  EXPECT_EQ(option("experiment").value, OptionValue::file);
  EXPECT_TRUE(option("experiment").positional);
  EXPECT_TRUE(option("experiment").required);
  EXPECT_FALSE(option("experiment").repeats);
  EXPECT_TRUE(option("set").repeats);
  EXPECT_FALSE(option("set").positional);
  EXPECT_FALSE(option("set").takes_rest);
  EXPECT_TRUE(option("among").takes_rest);
  EXPECT_EQ(option("threads").value, OptionValue::whole_number);
  EXPECT_EQ(option("quiet").value, OptionValue::none);
  EXPECT_EQ(option("json").value, OptionValue::optional_file);
}

TEST_F(OptionTree, MakesAManualPageOfACommand) {
  const std::string page = manual_page(tree_[1], tree_, {"1.2", ""});
  EXPECT_EQ(manual_name(tree_[3]), "lacuna-plugins-list");
  EXPECT_THAT(page, HasSubstr(".TH LACUNA\\-CHECK 1 \"\" \"lacuna 1.2\""));
  EXPECT_THAT(page, HasSubstr(".B \\-\\-threads N\nThreads\n"));
  EXPECT_THAT(page, HasSubstr("[OPTIONS] experiment\n"));
  EXPECT_THAT(manual_page(tree_[2], tree_, {}), HasSubstr("lacuna\\-plugins\\-list (1)\nList \\- don't show\n"));
}

TEST_F(OptionTree, QuotesWhatShellsWouldTakeForMore) {
  EXPECT_THAT(fish_completion(tree_), HasSubstr("'List - don\\'t show'"));
  EXPECT_THAT(zsh_completion(tree_), HasSubstr("'list:List - don'\\''t show'"));
  EXPECT_THROW(completion_script("tcsh", tree_), std::exception);
}

}  // namespace
}  // namespace lacuna

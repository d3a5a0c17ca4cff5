#include "end_to_end/printed_lines.h"
#include "end_to_end/program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

/// What shells complete, and manual pages, both made from the program's options.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class BashCompletion : public testing::Test {
 protected:
  BashCompletion() {
    program_.write("complete.sh", R"(source <(lacuna completion bash)
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_lacuna lacuna "${COMP_WORDS[COMP_CWORD]}"
printf '%s\n' "${COMPREPLY[@]}"
)");
  }

  /// What is offered for the last of these words, which bash has split at equals signs.
  std::vector<std::string> offered(const std::string& words) const {
    const Outcome outcome = program_.shell("bash complete.sh " + words);
    EXPECT_EQ(outcome.errors, "");
    std::vector<std::string> lines = lines_of(outcome.output);
    std::erase(lines, "");
    return lines;
  }

  Program program_;
};

TEST_F(BashCompletion, HasTheCommandsAndThoseBelowThem) {
  EXPECT_THAT(offered("lacuna ''"),
              AllOf(Contains("check"), Contains("diagnose"), Contains("mcp"), Not(Contains("list"))));
  EXPECT_THAT(offered("lacuna comp"), testing::UnorderedElementsAre("compare", "completion"));
  EXPECT_THAT(offered("lacuna plugins ''"), AllOf(Contains("list"), Contains("show"), Not(Contains("compare"))));
  EXPECT_THAT(offered("lacuna help diag"), ElementsAre("diagnose"));
  EXPECT_THAT(offered("lacuna man diag"), ElementsAre("diagnose"));
  EXPECT_THAT(offered("lacuna completion ''"), ElementsAre("bash", "fish", "zsh"));
}

TEST_F(BashCompletion, HasTheOptionsOfTheCommand) {
  EXPECT_THAT(offered("lacuna compare first.toml --as"), ElementsAre("--as-is"));
  EXPECT_THAT(offered("lacuna plugins list --k"), ElementsAre("--kind"));
  EXPECT_THAT(offered("lacuna check --"), AllOf(Contains("--set"), Not(Contains("--as-is"))));
  EXPECT_THAT(offered("lacuna --v"), ElementsAre("--version"));
}

TEST_F(BashCompletion, HasFilesAndFoldersWhereTheyAreTaken) {
  program_.write("rig.toml", "");
  program_.shell("mkdir ribs");
  EXPECT_THAT(offered("lacuna check ri"), testing::UnorderedElementsAre("rig.toml", "ribs"));
  EXPECT_THAT(offered("lacuna check rig.toml --plugin-path ri"), ElementsAre("ribs"));
  EXPECT_THAT(offered("lacuna compare rig.toml --json = ri"), testing::UnorderedElementsAre("rig.toml", "ribs"));
  EXPECT_THAT(offered("lacuna compare rig.toml --threads ri"), testing::IsEmpty());
  EXPECT_THAT(offered("lacuna new new.toml --from rig.toml ri"), testing::UnorderedElementsAre("rig.toml", "ribs"));
}

TEST_F(BashCompletion, HasTheNamesOfEffectsAndViews) {
  EXPECT_THAT(offered("lacuna add rig.toml coul"), ElementsAre("coulomb_friction"));
  EXPECT_THAT(offered("lacuna add --db x.db rig.toml wrong"), ElementsAre("wrong_value"));
  EXPECT_THAT(offered("lacuna diagnose rig.toml --among coul"), ElementsAre("coulomb_friction"));
  EXPECT_THAT(offered("lacuna plugins list --kind eff"), ElementsAre("effect"));
  EXPECT_THAT(offered("lacuna plugins show recor"), Contains("recorded"));
  EXPECT_THAT(offered("lacuna sql x.db 'SELECT * FROM error'"), Contains("SELECT * FROM error_by_revision"));
  EXPECT_THAT(offered("lacuna export x.db error"), Contains("error_by_revision"));
  program_.copy_first_steps();
  ASSERT_EQ(program_.run({"compare", "first-steps.toml", "--as-is"}).exit_code, 0);
  EXPECT_THAT(offered("lacuna export first-steps.db sin"), ElementsAre("sine.csv"));
}

/// Shells that need not be there.
void expect_sound(const std::string& shell) {
  const Program program;
  if (program.shell("command -v " + shell).exit_code != 0) GTEST_SKIP() << shell << " is not installed";
  EXPECT_EQ(program.shell(fmt::format("lacuna completion {0} > script && {0} -n script", shell)).errors, "");
}

TEST(ZshCompletion, IsSound) { expect_sound("zsh"); }
TEST(FishCompletion, IsSound) { expect_sound("fish"); }

TEST(FishCompletion, HasCommandsOptionsAndEffects) {
  const Program program;
  if (program.shell("command -v fish").exit_code != 0) GTEST_SKIP() << "fish is not installed";
  const auto offered = [&](const std::string& line) {
    return program.shell(fmt::format("fish -c \"lacuna completion fish | source; complete -C '{}'\"", line)).output;
  };
  EXPECT_THAT(offered("lacuna diag"), HasSubstr("diagnose"));
  EXPECT_THAT(offered("lacuna compare x.toml --as"), HasSubstr("--as-is"));
  EXPECT_THAT(offered("lacuna plugins li"), HasSubstr("list"));
  EXPECT_THAT(offered("lacuna add x.toml coul"), HasSubstr("coulomb_friction"));
}

TEST(ManualPages, AreThereForEveryCommand) {
  const Program program;
  ASSERT_EQ(program.run({"man", "--out", "man1"}).exit_code, 0);
  EXPECT_THAT(program.read("man1/lacuna.1"), HasSubstr("lacuna\\-diagnose (1)"));
  EXPECT_THAT(program.read("man1/lacuna-plugins-list.1"), HasSubstr("\\-\\-kind KIND"));
  EXPECT_EQ(program.run({"man", "plugins", "list"}).output, program.read("man1/lacuna-plugins-list.1"));
  EXPECT_EQ(program.run({"man", "nothing"}).exit_code, 2);
  if (program.shell("command -v groff").exit_code != 0)
    GTEST_SKIP() << "groff, which would check them, is not installed";
  EXPECT_EQ(program.shell("groff -man -Tascii -ww man1/*.1 > pages").errors, "");
}

TEST(Installation, PutsEverythingWhereShellsAndReadersLook) {
  Program program;
  const Outcome outcome = program.install("prefix");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  for (const char* file :
       {"bin/lacuna", "lib/lacuna/plugins/coulomb_friction.so", "include/lacuna/plugin.h",
        "share/bash-completion/completions/lacuna", "share/zsh/site-functions/_lacuna",
        "share/fish/vendor_completions.d/lacuna.fish", "share/man/man1/lacuna-diagnose.1", "share/doc/lacuna/README.md",
        "share/doc/lacuna/docs/tutorials/first-steps.md", "share/doc/lacuna/copyright",
        "share/lacuna/experiments/first-steps.toml", "share/lacuna/experiments/data/servo_pendulum/sine.csv"})
    EXPECT_TRUE(std::filesystem::exists(program.folder() / "prefix" / file)) << file;
  EXPECT_EQ(program.run({"completion", "bash"}).output,
            program.read("prefix/share/bash-completion/completions/lacuna"));
  EXPECT_EQ(program.shell("lacuna check prefix/share/lacuna/experiments/first-steps.toml").exit_code, 0);
}

}  // namespace
}  // namespace lacuna

#include "foundation/processes/child_program.h"

#include "support/test_folder.h"

#include <lacuna/error.h>

#include <gmock/gmock.h>

#include <fmt/format.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace lacuna {
namespace {

using testing::HasSubstr;

constexpr double kPatience = 60.0;  // s

class ChildProgramTest : public testing::Test {
 protected:
  ChildBeginning shell(const std::string& script) const {
    return {.words = {"sh", "-c", script},
            .folder = folder_.path(),
            .environment = {{"LACUNA_TEST_WORD", "lantern"}},
            .output = output_.file(),
            .errors = output_.file()};
  }
  TestFolder folder_;
  CapturedOutput output_{"output"};
};

TEST_F(ChildProgramTest, WorksInItsFolderWithItsVariablesAndNothingToRead) {
  ChildProgram child(shell("pwd; echo $LACUNA_TEST_WORD; cat; exit 3"));
  const std::optional<ChildEnding> ending = child.ended_within(kPatience);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->code(), 3);
  EXPECT_EQ(ending->phrase(), "ended with exit code 3");
  EXPECT_EQ(output_.end(), folder_.path().string() + "\nlantern\n");
}

TEST_F(ChildProgramTest, SaysWhichSignalEndedIt) {
  ChildProgram child(shell("kill -SEGV $$"));
  const std::optional<ChildEnding> ending = child.ended_within(kPatience);
  ASSERT_TRUE(ending);
  EXPECT_EQ(ending->code(), 128 + SIGSEGV);
  EXPECT_EQ(ending->phrase(), "was ended by signal 11 (Segmentation fault)");
}

/// Whether a process that a shell has named is over.
void expect_gone(const std::string& said) {
  const auto process = static_cast<pid_t>(std::stoi(said));
  bool gone = false;
  for (int i = 0; i < 6000 && !gone; ++i) {  // its new parent may take a moment to notice
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    gone = kill(process, 0) != 0;
    // Where nobody waits for orphans, as in some containers, what is left is no process any more.
    if (std::ifstream status("/proc/" + said.substr(0, said.find('\n')) + "/stat"); !gone && status)
      gone = std::string(std::istreambuf_iterator<char>(status), {}).find(") Z ") != std::string::npos;
  }
  EXPECT_TRUE(gone);
}

TEST_F(ChildProgramTest, EndsWithItsOwnChildrenThoughItRefuses) {
  ChildProgram child(shell("trap '' TERM; sleep 1000 & echo $!; wait"));
  std::string said;
  for (int i = 0; i < 6000 && said.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    said = output_.end();
  }
  EXPECT_EQ(child.end(0.05).code(), 128 + SIGKILL);
  expect_gone(said);
}

TEST_F(ChildProgramTest, WhatLeavesItsGroupEndsWithItAllTheSame) {
  ChildProgram child(shell("setsid sh -c 'echo $$; exec sleep 1000' & sleep 0.2"));  // an orphan of another session
  ASSERT_TRUE(child.ended_within(kPatience));
  ASSERT_FALSE(output_.end().empty());
  expect_gone(output_.end());
}

TEST_F(ChildProgramTest, AProgramThatIsNotThereIsSaid) {
  EXPECT_THAT([] { ChildProgram({.words = {"no-such-program"}, .folder = {}, .environment = {}}); },
              testing::ThrowsMessage<Error>(HasSubstr("no-such-program cannot be started: No such file")));
}

TEST_F(ChildProgramTest, OfWhatItWritesTheEndIsKept) {
  constexpr long kWritten = 20'000'000, kBlock = 512;  // bytes; those of a block are the kernel's
  ChildProgram child(shell(fmt::format("head -c {} /dev/zero | tr '\\0' x; echo; echo last", kWritten)));
  ASSERT_TRUE(child.ended_within(kPatience));
  struct stat file {};
  for (int i = 0; i < 6000 && (fstat(output_.file(), &file) != 0 || file.st_blocks * kBlock >= kWritten); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_LT(file.st_blocks * kBlock, kWritten) << "nobody has asked for it meanwhile";
  EXPECT_THAT(output_.end(), testing::EndsWith("x\nlast\n"));
  EXPECT_EQ(output_.end().size(), 1U << 16U);
  ChildProgram more(shell("echo more"));
  ASSERT_TRUE(more.ended_within(kPatience));
  EXPECT_THAT(output_.end(), testing::EndsWith("x\nlast\nmore\n"));
}

}  // namespace
}  // namespace lacuna

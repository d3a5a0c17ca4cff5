#include "foundation/processes/processes.h"

#include "foundation/processes/child_program.h"

#include <gmock/gmock.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace lacuna {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

/// Looks at it again and again for a while.
template <class Condition>
bool comes_true(const Condition& condition) {
  for (int i = 0; i < 3000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(10)))
    if (condition()) return true;
  return false;
}

TEST(Processes, ThoseWithAVariableAreFound) {
  const std::string variable = "LACUNA_TEST_LANTERN=" + std::to_string(getpid());
  EXPECT_THAT(processes_with(variable), IsEmpty());
  ChildProgram child(
      {.words = {"sleep", "1000"}, .folder = {}, .environment = {{"LACUNA_TEST_LANTERN", std::to_string(getpid())}}});
  EXPECT_TRUE(comes_true([&] { return processes_with(variable).size() == 1; }));
  EXPECT_THAT(processes_with("LACUNA_TEST_LANTERN=1"), IsEmpty()) << "another value";
  child.end(0.0);
  EXPECT_THAT(processes_with(variable), IsEmpty());
}

TEST(Processes, DescendantsAreThoseOfChildrenToo) {
  ChildProgram child({.words = {"sh", "-c", "sleep 1000 & wait"}, .folder = {}, .environment = {}});
  EXPECT_TRUE(comes_true([] { return descendants_of(getpid()).size() == 2; }));
  EXPECT_THAT(descendants_of(getpid()), Not(Contains(getpid())));
  child.end(0.0);
  EXPECT_TRUE(comes_true([] { return descendants_of(getpid()).empty(); }));
}

TEST(Processes, AllThatHangOnThisOneAreEnded) {
  const pid_t child = fork();
  if (child == 0) {
    for (;;) pause();
  }
  EXPECT_THAT(descendants_of(getpid()), Contains(child));
  end_descendants(1.0);
  EXPECT_THAT(descendants_of(getpid()), IsEmpty());
  EXPECT_EQ(waitpid(child, nullptr, WNOHANG), -1) << "it was waited for";
}

}  // namespace
}  // namespace lacuna

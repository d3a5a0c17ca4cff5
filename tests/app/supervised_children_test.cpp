#include "app/supervisor.h"

#include <gmock/gmock.h>

#include <cstdlib>

/// Processes that a command started: none is left behind.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(RunSupervised, WhatALostChildHasLeftRunningIsEnded) {
  const Supervisor supervisor([](int, char**) -> int {
    const pid_t left = fork();
    if (left == 0) {
      setsid();
      hang();
    }
    EXPECT_EQ(write(Supervisor::said(), &left, sizeof(left)), static_cast<ssize_t>(sizeof(left)));
    std::abort();
  });
  const pid_t left = supervisor.worker();
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_NE(kill(left, 0), 0) << "the supervisor has waited for it";
}

/// A process of another session, without anything that it inherited.
int leave_a_helper(int, char**) {
  const pid_t helper = fork();
  if (helper == 0) {
    setsid();
    execl("/usr/bin/env", "env", "-i", "/bin/sleep", "1000", static_cast<char*>(nullptr));
    _exit(1);
  }
  EXPECT_EQ(write(Supervisor::said(), &helper, sizeof(helper)), static_cast<ssize_t>(sizeof(helper)));
  std::this_thread::sleep_for(kAWhile);  // until it is what it is to be
  return 0;
}

TEST(RunSupervised, WhatGoodWorkHasLeftRunningIsEndedAndNamed) {
  const Supervisor supervisor(leave_a_helper);
  const pid_t helper = supervisor.worker();
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 0) << "the work is done all the same";
  EXPECT_NE(kill(helper, 0), 0) << "it is gone";
  EXPECT_THAT(supervisor.errors(), AllOf(HasSubstr("ended processes that were still running after the command"),
                                         HasSubstr("\"/bin/sleep 1000\" (process " + std::to_string(helper))));
}

TEST(RunSupervised, ChildrenThatWereThereBeforeTheWorkAreNotItsOwn) {
  std::array<int, 2> told{};
  ASSERT_EQ(pipe2(told.data(), O_CLOEXEC), 0);
  const pid_t shell = fork();
  if (shell == 0) {
    const pid_t other = fork();
    if (other == 0) {
      execl("/bin/sleep", "sleep", "1000", static_cast<char*>(nullptr));
      _exit(1);
    }
    EXPECT_EQ(write(told[1], &other, sizeof(other)), static_cast<ssize_t>(sizeof(other)));
    _exit(run_supervised(0, nullptr, [](int, char**) { return 0; }));
  }
  pid_t other = 0;
  ASSERT_EQ(read(told[0], &other, sizeof(other)), static_cast<ssize_t>(sizeof(other)));
  int status = 0;
  waitpid(shell, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(kill(other, SIGKILL), 0) << "it goes on";
  for (const int end : told) close(end);
}

TEST(RunSupervised, TheWorkDoesNotOutliveTheSupervisor) {
  const Supervisor supervisor(until_interrupted);
  const pid_t worker = supervisor.worker();
  supervisor.send(SIGKILL);
  supervisor.wait();
  bool gone = false;
  for (int i = 0; i < 1000 && !gone; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::string status = read_bytes("/proc/" + std::to_string(worker) + "/stat");
    gone = status.empty() || status.find(") Z") != status.npos;  // nobody may have waited for it yet
  }
  EXPECT_TRUE(gone);
}

}  // namespace
}  // namespace lacuna

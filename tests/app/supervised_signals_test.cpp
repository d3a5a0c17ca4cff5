#include "app/supervisor.h"
#include "foundation/plugins/plugin_call.h"
#include "support/sanitizers.h"

#include <gmock/gmock.h>

#include <cstdlib>

/// Signals to a command: interrupts, hang-ups, stops.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(RunSupervised, ASignalToTheSupervisorReachesTheWork) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Supervisor supervisor(until_interrupted);
    supervisor.worker();
    supervisor.send(signal);
    EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 75) << signal;
    EXPECT_THAT(supervisor.errors(), IsEmpty());
  }
}

int call_that_heeds_nothing(int, char**) {
  watch_for_interrupts();
  const PluginCall call(component_on_page("search \"deaf\""), "ask");
  Supervisor::say_ready();
  hang();
  return 0;
}

TEST(RunSupervised, APluginThatIgnoresAWishIsEndedWithinTwoSeconds) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Supervisor supervisor(call_that_heeds_nothing);
    supervisor.worker();
    const auto asked = std::chrono::steady_clock::now();
    supervisor.send(signal);
    EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 75);
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::milliseconds(LACUNA_WATCHED ? 10'000 : 2'000));
    EXPECT_THAT(supervisor.errors(), AllOf(HasSubstr("interrupted; search \"deaf\": ask did not return"),
                                           Not(HasSubstr("fault of the plugin"))));
  }
}

int end_what_takes_its_time(int, char**) {
  watch_for_interrupts();
  Supervisor::say_ready();
  while (!when_interrupted().is_due()) std::this_thread::sleep_for(kAWhile / 10);
  std::this_thread::sleep_for(15 * kAWhile);  // a rig that is brought to rest
  return 75;
}

TEST(RunSupervised, WhatIsNoPluginsMayTakeItsTime) {
  const Supervisor supervisor(end_what_takes_its_time);
  supervisor.worker();
  supervisor.send(SIGTERM);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 75);
  EXPECT_THAT(supervisor.errors(), IsEmpty());
}

TEST(RunSupervised, AHangUpEndsBothBySignal) {
  const Supervisor supervisor(until_interrupted);
  supervisor.worker();
  supervisor.send(SIGHUP);
  const int status = supervisor.wait();
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGHUP);
  EXPECT_THAT(supervisor.errors(), IsEmpty());
}

int call_for_a_while(int, char**) {
  const PluginCall call(component_on_page("effect \"slow\""), "add_loads");
  Supervisor::say_ready();
  std::this_thread::sleep_for(12 * kAWhile);
  return 42;
}

TEST(RunSupervised, AHangUpThatIsIgnoredEndsNothing) {
  const auto before = std::signal(SIGHUP, SIG_IGN);  // as nohup does
  const Supervisor supervisor(call_for_a_while);
  std::signal(SIGHUP, before);
  supervisor.worker();
  supervisor.send(SIGHUP);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 42);
  EXPECT_THAT(supervisor.errors(), IsEmpty());
}

int abort_once_asked(int, char**) {
  CallPage::allow_new_beginning(true);
  watch_for_interrupts();
  Supervisor::say_ready();
  while (!when_interrupted().is_due()) std::this_thread::sleep_for(kAWhile / 10);
  const PluginCall call(component_on_page("effect \"hasty\""), "add_loads");
  std::abort();
}

TEST(RunSupervised, BeginsNothingAnewOnceItWasAskedToEnd) {
  const Supervisor supervisor(abort_once_asked);
  supervisor.worker();
  supervisor.send(SIGTERM);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(), HasSubstr("effect \"hasty\": add_loads ended the program by signal 6"));
}

TEST(RunSupervised, StopsAndGoesOnWithTheWork) {
  const Supervisor supervisor(until_interrupted);
  kill(supervisor.worker(), SIGSTOP);
  EXPECT_TRUE(WIFSTOPPED(supervisor.wait(WUNTRACED)));
  supervisor.send(SIGCONT);
  EXPECT_TRUE(WIFCONTINUED(supervisor.wait(WCONTINUED)));
  supervisor.send(SIGINT);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 75);
}

}  // namespace
}  // namespace lacuna

#include "app/terminal/supervised.h"

#include "foundation/processes/interrupt.h"
#include "foundation/plugins/plugin_call.h"
#include "support/sanitizers.h"
#include "support/test_folder.h"

#include <gmock/gmock.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <thread>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using SupervisedWork = int (*)(int, char**);
constexpr auto kAWhile = std::chrono::milliseconds(200);

/// A process that supervises `work`; what it prints goes to files in a folder.
class Supervisor {
 public:
  explicit Supervisor(SupervisedWork work) {
    EXPECT_EQ(pipe2(said_.data(), O_CLOEXEC), 0);
    said_end() = said_[1];
    process_ = fork();
    if (process_ != 0) return;
    dup2(open((folder_.path() / "errors").c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    _exit(run_supervised(0, nullptr, work));
  }
  ~Supervisor() {
    for (const int end : said_) close(end);
  }
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// In the work: tells the test its process number.
  static void say_ready() {
    const pid_t process = getpid();
    EXPECT_EQ(write(said_end(), &process, sizeof(process)), static_cast<ssize_t>(sizeof(process)));
  }
  /// The process that does the work, once it is at it.
  pid_t worker() const {
    pid_t process = 0;
    EXPECT_EQ(read(said_[0], &process, sizeof(process)), static_cast<ssize_t>(sizeof(process)));
    return process;
  }
  /// In the work: where the test reads process numbers from.
  static int said() { return said_end(); }
  void send(int signal) const { kill(process_, signal); }
  int wait(int options = 0) const {
    int status = 0;
    waitpid(process_, &status, options);
    return status;
  }
  std::string errors() const { return read_bytes(folder_.path() / "errors"); }

 private:
  static int& said_end() {
    static int end = -1;
    return end;
  }

  TestFolder folder_;
  std::array<int, 2> said_{};
  pid_t process_ = 0;
};

int until_interrupted(int, char**) {
  watch_for_interrupts();
  Supervisor::say_ready();
  for (;;) {
    try {
      pause_for(60.0);
    } catch (const Interrupted&) {
      return 75;
    }
  }
}

TEST(RunSupervised, PassesTheExitCodeOnAndSaysNothing) {
  const Supervisor supervisor([](int, char**) { return 42; });
  const int status = supervisor.wait();
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 42);
  EXPECT_THAT(supervisor.errors(), IsEmpty());
}

TEST(RunSupervised, AnEndThatIsNoReturnIsAFailure) {
  for (const SupervisedWork work : {SupervisedWork([](int, char**) -> int { std::exit(0); }),
                                    SupervisedWork([](int, char**) -> int { _exit(0); })}) {
    const Supervisor supervisor(work);
    EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
    EXPECT_THAT(supervisor.errors(),
                HasSubstr("ended with exit code 0 before its work was done, outside of plugin calls"));
  }
}

int exit_in_one_of_two_calls(int, char**) {
  std::thread([] {
    const PluginCall call(component_on_page("effect \"other\""), "sense");
    std::this_thread::sleep_for(10 * kAWhile);
  }).detach();
  std::this_thread::sleep_for(kAWhile);
  const PluginCall outer(component_on_page("target \"outer\""), "carrying a test out");
  { const PluginCall inner(component_on_page("effect \"inner\""), "add_loads"); }
  std::exit(0);
}

TEST(RunSupervised, NamesTheCallOfTheThreadThatExits) {
  const Supervisor supervisor(exit_in_one_of_two_calls);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(),
              AllOf(HasSubstr("target \"outer\": carrying a test out ended the program with exit code 0"),
                    Not(HasSubstr("other")), Not(HasSubstr("inner"))));
}

int crash_in_a_thread(int, char**) {
  const PluginCall call(component_on_page("search \"patient\""), "ask");
  std::thread([] {
    const PluginCall in_thread(component_on_page("effect \"hasty\""), "command");
    std::abort();
  }).join();
  return 0;
}

TEST(RunSupervised, NamesTheCallOfTheThreadThatCrashes) {
  const Supervisor supervisor(crash_in_a_thread);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(), AllOf(HasSubstr("effect \"hasty\": command ended the program by signal 6 (Aborted)"),
                                         HasSubstr("repair it"), Not(HasSubstr("patient"))));
}

int end_at_once_during_two_calls(int, char**) {
  std::thread([] {
    const PluginCall call(component_on_page("effect \"one\""), "sense");
    std::this_thread::sleep_for(10 * kAWhile);
  }).detach();
  std::this_thread::sleep_for(kAWhile);
  const PluginCall call(component_on_page("effect \"two\""), "add_loads");
  const HostCall service;
  const PluginCall inner(component_on_page("effect \"three\""), "command");
  _exit(0);
}

TEST(RunSupervised, NamesAllCallsWhereNobodyKnowsWhoseItWas) {
  const Supervisor supervisor(end_at_once_during_two_calls);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(), AllOf(HasSubstr("effect \"one\": sense"), HasSubstr("effect \"three\": command"),
                                         HasSubstr("one of these calls"), Not(HasSubstr("two"))));
}

TEST(RunSupervised, AKillIsNotCalledThePluginsFault) {
  const Supervisor supervisor([](int, char**) {
    const PluginCall call(component_on_page("effect \"slow\""), "add_loads");
    return until_interrupted(0, nullptr);
  });
  kill(supervisor.worker(), SIGKILL);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(),
              AllOf(HasSubstr("effect \"slow\": add_loads: the program was ended by signal 9"),
                    HasSubstr("another program killed it"), Not(HasSubstr("fault of the plugin"))));
}

TEST(RunSupervised, ASignalToTheSupervisorReachesTheWork) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Supervisor supervisor(until_interrupted);
    supervisor.worker();
    supervisor.send(signal);
    EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 75) << signal;
    EXPECT_THAT(supervisor.errors(), IsEmpty());
  }
}

void hang() {
  for (;;) std::this_thread::sleep_for(kAWhile);
}

int evaluate_without_end(int, char**) {
  CallPage::limit_evaluations(0.5);
  const Evaluation evaluation;
  for (int i = 0; i < 10; ++i) {  // longer than the limit, but one after the other
    const Evaluation part;
    std::this_thread::sleep_for(kAWhile / 2);
  }
  const PluginCall call(component_on_page("effect \"endless\""), "add_loads");
  hang();
  return 0;
}

TEST(RunSupervised, AnEvaluationThatTakesTooLongIsEndedAndNamed) {
  const Supervisor supervisor(evaluate_without_end);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(),
              AllOf(HasSubstr("effect \"endless\": add_loads: an evaluation took longer than 0.5 s"),
                    HasSubstr("--evaluation-limit"), HasSubstr("is kept")));
}

int describe_without_end(int, char**) {
  const PluginCall call(component_on_page("effect \"endless\""), "describe");
  hang();
  return 0;
}

TEST(RunSupervised, ACallThatOnlyTellsAndTakesTooLongIsEndedAndNamed) {
  const Supervisor supervisor(describe_without_end);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(),
              AllOf(HasSubstr("effect \"endless\": describe took longer than the limit, 10 s"), HasSubstr("is kept")));
}

int many_calls(int, char**) {
  for (int i = 0; i < 120; ++i) {  // longer than the limit, but one after the other
    const PluginCall call(component_on_page("effect \"busy\""), "describe");
    std::this_thread::sleep_for(kAWhile / 2);
  }
  return 42;
}

TEST(RunSupervised, ManyCallsOfOneKindAreNotOneThatTakesLong) {
  const Supervisor supervisor(many_calls);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 42);
  EXPECT_THAT(supervisor.errors(), IsEmpty());
}

int stop_in_each_call(int, char**) {
  for (;;) {
    const PluginCall call(component_on_page("effect \"lazy\""), "sense");
    std::raise(SIGSTOP);
  }
}

TEST(RunSupervised, ACallThatStopsTheProcessAgainIsEndedAndNamed) {
  const Supervisor supervisor(stop_in_each_call);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(), HasSubstr("effect \"lazy\": sense stopped the program by signal 19 (SIGSTOP)"));
}

int never_end(int, char**) {
  CallPage::close(0);
  hang();
  return 0;
}

TEST(RunSupervised, AnEndThatDoesNotComeIsForced) {
  const Supervisor supervisor(never_end);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(),
              AllOf(HasSubstr("did not end within 10 s"), HasSubstr("after its work was complete")));
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
  while (!interrupt_requested()) std::this_thread::sleep_for(kAWhile / 10);
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

int end_by_each_effect_in_turn(int, char**) {
  CallPage::allow_new_beginning(true);
  for (const char* effect : {"effect \"one\"", "effect \"two\""}) {
    if (CallPage::refusal_of(effect)) continue;
    const PluginCall call(component_on_page(effect), "add_loads");
    std::abort();
  }
  return 42;
}

TEST(RunSupervised, WorkThatAllowsItBeginsAnewWithoutWhatEndedIt) {
  const Supervisor supervisor(end_by_each_effect_in_turn);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 42);
  EXPECT_THAT(supervisor.errors(),
              AllOf(HasSubstr("effect \"one\": add_loads ended the program by signal 6"), HasSubstr("effect \"two\""),
                    HasSubstr("the command starts again without it"), Not(HasSubstr("fault of"))));
}

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
  while (!interrupt_requested()) std::this_thread::sleep_for(kAWhile / 10);
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

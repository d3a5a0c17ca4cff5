#include "app/supervisor.h"
#include "foundation/plugins/plugin_call.h"

#include <gmock/gmock.h>

#include <cstdlib>

/// What is said of a command that a plugin ended, or held up.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

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
              AllOf(HasSubstr("effect \"endless\": add_loads: an evaluation took longer than the limit, 0.5 s"),
                    HasSubstr("--evaluation-limit"), HasSubstr("the database keeps all committed results")));
}

int describe_without_end(int, char**) {
  const PluginCall call(component_on_page("effect \"endless\""), "describe");
  hang();
  return 0;
}

TEST(RunSupervised, ACallThatOnlyTellsAndTakesTooLongIsEndedAndNamed) {
  const Supervisor supervisor(describe_without_end);
  EXPECT_EQ(WEXITSTATUS(supervisor.wait()), 1);
  EXPECT_THAT(supervisor.errors(), AllOf(HasSubstr("effect \"endless\": describe took longer than the limit, 10 s"),
                                         HasSubstr("the database keeps all committed results")));
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

}  // namespace
}  // namespace lacuna

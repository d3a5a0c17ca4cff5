#include "loading/child_process.h"

#include "foundation/plugins/plugin_call.h"

#include <gmock/gmock.h>

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(AskInChild, WorkThatReturnsAnswersAndWorkThatThrowsDoesNot) {
  const std::string large(1'000'000, 'x');  // more than a pipe holds
  const auto work = [&](std::size_t index) {
    if (index == 1) throw std::runtime_error("caught in the child");
    return index == 0 ? "first" : large;
  };
  const std::vector<ChildAnswer> answers = ask_in_child(3, work);
  EXPECT_EQ(answers[0].answer, "first");
  EXPECT_EQ(answers[1].answer, "");
  EXPECT_EQ(answers[2].answer, large);
  for (const ChildAnswer& answer : answers) EXPECT_THAT(answer.death, IsEmpty());
}

TEST(AskInChild, DeathsAreNamedAndTheOthersGoOn) {
  const auto work = [](std::size_t index) {
    if (index == 0) std::raise(SIGBUS);
    if (index == 2) _exit(3);
    return std::string("alive");
  };
  const std::vector<ChildAnswer> answers = ask_in_child(4, work);
  EXPECT_THAT(answers[0].death, HasSubstr("signal 7"));
  EXPECT_EQ(answers[1].answer, "alive");
  EXPECT_THAT(answers[2].death, HasSubstr("exit code 3"));
  EXPECT_EQ(answers[3].answer, "alive");
}

TEST(AskInChild, ADeathInACallNamesTheCall) {
  const auto work = [](std::size_t index) -> std::string {
    if (index == 0) std::exit(0);
    { const PluginCall over(component_on_page("effect"), "describe"); }
    const PluginCall call(component_on_page("effect"), "stages");
    std::exit(0);
  };
  const std::vector<ChildAnswer> answers = ask_in_child(2, work);
  EXPECT_EQ(answers[0].call, "");
  EXPECT_EQ(answers[1].call, "stages");
  EXPECT_THAT(CallPage::active(), IsEmpty());
}

TEST(AskInChild, WorkWithoutEndIsCutOff) {
  const auto forever = [](std::size_t) -> std::string {
    for (;;) pause();
  };
  EXPECT_THAT(ask_in_child(1, forever, 1)[0].death, HasSubstr("longer than 1 s"));
}

TEST(AskInChild, WhatTheChildChangesStaysInTheChild) {
  int value = 1;
  ask_in_child(1, [&](std::size_t) {
    value = 2;
    return std::string();
  });
  EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace lacuna

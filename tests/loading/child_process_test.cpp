#include "loading/child_process.h"

#include <gmock/gmock.h>

#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace lacuna {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SurviveInChild, WorkThatReturnsOrThrowsSurvives) {
  const auto work = [](std::size_t index) {
    if (index == 1) throw std::runtime_error("caught in the child");
  };
  EXPECT_THAT(survive_in_child(3, work), ElementsAre(IsEmpty(), IsEmpty(), IsEmpty()));
}

TEST(SurviveInChild, DeathsAreNamedAndTheOthersGoOn) {
  const auto work = [](std::size_t index) {
    if (index == 0) std::raise(SIGBUS);
    if (index == 2) _exit(3);
  };
  EXPECT_THAT(survive_in_child(4, work),
              ElementsAre(HasSubstr("signal 7"), IsEmpty(), HasSubstr("exit code 3"), IsEmpty()));
}

TEST(SurviveInChild, WorkWithoutEndIsCutOff) {
  const auto forever = [](std::size_t) {
    for (;;) pause();
  };
  EXPECT_THAT(survive_in_child(1, forever, 1), ElementsAre(HasSubstr("longer than 1 s")));
}

TEST(SurviveInChild, WhatTheChildChangesStaysInTheChild) {
  int value = 1;
  survive_in_child(1, [&](std::size_t) { value = 2; });
  EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace lacuna

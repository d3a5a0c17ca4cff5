#include "foundation/processes/process_watch.h"

#include "foundation/processes/guarded_call.h"

#include <gmock/gmock.h>

#include <unistd.h>

#include <cfenv>
#include <clocale>
#include <filesystem>
#include <stdexcept>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StrEq;
using testing::ThrowsMessage;

const ComponentOrigin kShifty{"effect", "shifty", "/opt/shifty.so"};

class Watched : public testing::Test {
 protected:
  Watched() { ProcessWatch::begin(); }
};

TEST_F(Watched, ACallThatChangesTheRoundingFailsAndIsSetBack) {
  EXPECT_THAT([] { guarded_call(kShifty, "amend", [] { std::fesetround(FE_UPWARD); }); },
              ThrowsMessage<ComponentChangedProcess>(
                  AllOf(HasSubstr("effect \"shifty\" (/opt/shifty.so): amend changed the rounding of floating-point"),
                        HasSubstr("it was set back"), HasSubstr("fault of the plugin"))));
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST_F(Watched, WhatACallThatThrowsChangedIsSetBackAsWell) {
  EXPECT_THAT(
      [] {
        guarded_call(kShifty, "amend", [] {
          std::setlocale(LC_ALL, "C.UTF-8");
          throw std::runtime_error("no licence");
        });
      },
      ThrowsMessage<ComponentError>(HasSubstr("amend threw std::runtime_error (no licence)")));
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C");
}

TEST_F(Watched, NothingIsSaidOfACallThatChangesNothing) {
  EXPECT_EQ(guarded_call(kShifty, "state_size", [] { return 3; }), 3);
  std::feraiseexcept(FE_INEXACT | FE_DIVBYZERO);  // which any sum may
  EXPECT_THAT(ProcessWatch::changed(), IsEmpty());
}

TEST_F(Watched, TheCurrentFolderIsLookedAtNowAndThen) {
  const std::filesystem::path before = std::filesystem::current_path();
  ASSERT_EQ(chdir("/"), 0);
  std::string found;
  for (int i = 0; i < 100 && found.empty(); ++i) {
    usleep(1000);
    found = ProcessWatch::changed();
  }
  EXPECT_THAT(found, StrEq("the current folder (/)"));
  EXPECT_EQ(std::filesystem::current_path(), before);
}

TEST(Enumerated, IsWrittenAsInASentence) {
  EXPECT_EQ(enumerated({}), "");
  EXPECT_EQ(enumerated({"a"}), "a");
  EXPECT_EQ(enumerated({"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace lacuna

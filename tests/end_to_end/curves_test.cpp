#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A database of two runs of small.toml that differ in their settings.
class CurvesCommand : public testing::Test {
 protected:
  CurvesCommand() { program_.write("small.toml", kSmallRun); }
  void run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"run", "small.toml", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    ASSERT_EQ(program_.run(words).exit_code, 0);
  }
  const Program program_;
};

TEST_F(CurvesCommand, SaysWhichRunsAreLeftOut) {
  run();
  run({"--set", "target.hidden_seed=3", "--replicates", "2"});
  const Outcome curves = program_.run({"curves", "small.db", "--error", "score"});
  ASSERT_EQ(curves.exit_code, 0) << curves.errors;
  EXPECT_THAT(curves.errors, HasSubstr("1 run left out: other settings than the newest run"));
  EXPECT_THAT(curves.output, Not(HasSubstr("["))) << "two runs have no interval";
}

TEST_F(CurvesCommand, TellsDatabasesApartAndReadsEachOnce) {
  run();
  ASSERT_EQ(program_.shell("mkdir other && cp small.db other/small.db").exit_code, 0);
  const Outcome curves = program_.run({"curves", "small.db", "other/small.db", "./small.db", "--error", "score"});
  ASSERT_EQ(curves.exit_code, 0) << curves.errors;
  EXPECT_THAT(curves.output, AllOf(HasSubstr(" in small.db "), HasSubstr(" in other/small.db ")));
  EXPECT_THAT(curves.output, Not(HasSubstr(" in ./small.db ")));
  const Outcome wrong = program_.run({"curves", "small.db", "--against", "smal"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("--against smal: no run of it has ended (did you mean"));
}

}  // namespace
}  // namespace lacuna

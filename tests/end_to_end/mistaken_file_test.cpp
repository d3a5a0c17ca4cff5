#include "end_to_end/program.h"
#include "support/sanitizers.h"

#include <gmock/gmock.h>

#include <string>

/// The wrong file, and too small a limit: what is said is the reason, and the line to type.
namespace lacuna::mistaken_file_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr int kDone = 0, kFailed = 1, kBadInput = 2;

class MistakenFile : public testing::Test {
 protected:
  MistakenFile() { program_.copy_first_steps(); }
  Program program_;
};

TEST_F(MistakenFile, ADatabaseInPlaceOfItsExperimentIsToldWithTheLineToType) {
  ASSERT_EQ(program_.run({"compare", "first-steps.toml"}).exit_code, kDone);
  for (const char* command : {"compare", "check", "history", "run"}) {
    const Outcome outcome = program_.run({command, "first-steps.db", "--quiet"});
    EXPECT_EQ(outcome.exit_code, kBadInput) << command;
    EXPECT_THAT(outcome.errors,
                HasSubstr("first-steps.db: is a database, but this command needs an experiment file: lacuna " +
                          std::string(command) + " first-steps.toml --quiet"));
  }
}

TEST_F(MistakenFile, AnExperimentInPlaceOfItsDatabaseIsToldWithTheLineToType) {
  const Outcome none = program_.run({"runs", "first-steps.toml"});
  EXPECT_EQ(none.exit_code, kBadInput);
  EXPECT_THAT(none.errors,
              HasSubstr("first-steps.toml: is an experiment file, but this command needs a database: lacuna runs "
                        "first-steps.db; it does not exist yet, make it with lacuna compare first-steps.toml"));
  ASSERT_EQ(program_.run({"compare", "first-steps.toml"}).exit_code, kDone);
  const Outcome there = program_.run({"sql", "first-steps.toml", "SELECT 1"});
  EXPECT_EQ(there.exit_code, kBadInput);
  EXPECT_THAT(there.errors, AllOf(HasSubstr("lacuna sql first-steps.db 'SELECT 1'"), Not(HasSubstr("not exist yet"))));
}

/// A copy whose name was not changed writes into the database of its original.
TEST_F(MistakenFile, ACopyThatSharesTheDatabaseOfItsOriginalIsTold) {
  const std::vector<std::string> compare_copy = {"compare", "copy.toml", "--as-is", "--quiet"};
  ASSERT_EQ(program_.run({"compare", "first-steps.toml", "--as-is"}).exit_code, kDone);
  program_.write("copy.toml", program_.read("first-steps.toml"));
  const Outcome shared = program_.run(compare_copy);
  EXPECT_EQ(shared.exit_code, kDone) << shared.errors;
  EXPECT_THAT(shared.errors, HasSubstr("copy.toml:5:8: first-steps.toml is also called \"first-steps\" and writes into "
                                       "the same database, first-steps.db"));
  EXPECT_THAT(program_.run({"check", "copy.toml"}).output, HasSubstr("name another database with --db"));
  std::string renamed = program_.read("copy.toml");
  renamed.replace(renamed.find("\"first-steps\""), 13, "\"second\"");
  program_.write("copy.toml", renamed);
  EXPECT_EQ(program_.run(compare_copy).errors, "");
}

TEST_F(MistakenFile, AMovedExperimentGoesOnInItsDatabase) {
  ASSERT_EQ(program_.run({"compare", "first-steps.toml", "--as-is"}).exit_code, kDone);
  ASSERT_EQ(program_.shell("mv first-steps.toml moved.toml").exit_code, 0);
  EXPECT_EQ(program_.run({"compare", "moved.toml", "--as-is", "--quiet"}).errors, "");
}

TEST_F(MistakenFile, DoesNotStandBetweenAUserAndTheHelp) {
  for (const char* command : {"report", "sql", "serve", "runs"}) {
    const Outcome outcome = program_.run({command, "first-steps.toml", "--help"});
    EXPECT_EQ(outcome.exit_code, kDone) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("Usage: lacuna " + std::string(command)));
  }
}

TEST_F(MistakenFile, AReportIsNotPrintedToATerminal) {
  ASSERT_EQ(program_.run({"compare", "first-steps.toml"}).exit_code, kDone);
  if (program_.shell("command -v script").exit_code != 0) GTEST_SKIP() << "there is no script to make a terminal";
  const Outcome terminal =
      program_.shell("script -qec 'lacuna report first-steps.db --no-robots' /dev/null </dev/null");
  EXPECT_EQ(terminal.exit_code, kBadInput);
  EXPECT_LT(terminal.output.size(), 1000U);
  EXPECT_THAT(terminal.output, HasSubstr("lacuna report first-steps.db --no-robots --out first-steps.html"));
  EXPECT_THAT(program_.shell("lacuna report first-steps.db --no-robots | head -c 100").output, HasSubstr("<!doctype"));
}

TEST_F(MistakenFile, ANumberInASentenceIsShort) {
  std::string robot = program_.read("robots/servo-pendulum.toml");
  const std::string mass = "mass = \"0.50 kg\"";
  robot.replace(robot.find(mass), mass.size(), "mass = 1e308");
  program_.write("robots/servo-pendulum.toml", robot);
  const Outcome outcome = program_.run({"check", "first-steps.toml"});
  EXPECT_EQ(outcome.exit_code, kBadInput);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("its mass is 1e+308 kg, it must be positive and at most 1e+12 kg"),
                                    Not(HasSubstr("00000"))));
}

class SmallLimit : public MistakenFile {
 protected:
  Outcome compare(const std::string& limit) const {
    return program_.shell("ulimit " + limit + "; lacuna compare first-steps.toml --quiet --threads 2");
  }
};

TEST_F(SmallLimit, OfOpenFilesAndOfTheStackIsNamed) {
  for (const char* few : {"6", "10", "16"}) {
    const Outcome files = compare("-n " + std::string(few));
    EXPECT_EQ(files.exit_code, kFailed) << few;
    EXPECT_THAT(files.errors, HasSubstr("the limit of open files is " + std::string(few) + " (ulimit -n)"));
  }
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer needs more stack";
  const Outcome stack = compare("-s 200");
  EXPECT_EQ(stack.exit_code, kFailed);
  EXPECT_THAT(stack.errors, HasSubstr("the stack limit is 200 kB (ulimit -s)"));
}

TEST_F(SmallLimit, OfTheStackThatMayBeRaisedIsRaised) {
  EXPECT_EQ(compare("-S -s 300").exit_code, kDone);
  EXPECT_EQ(compare("-S -n 8").exit_code, kDone);
}

/// From what the loader needs to what the command needs: a sentence about memory, or the result. A stack that cannot
/// grow ends a process by signal 11, which nothing in it can prevent: then the sentence stands beside the signal.
TEST_F(SmallLimit, OfMemoryEndsWithASentenceOrTheResult) {
  if (LACUNA_WATCHED) GTEST_SKIP() << "a sanitizer reserves terabytes";
  int told = 0;
  for (int kilobytes = 30'000; kilobytes <= 60'000; kilobytes += 5'000) {
    const Outcome outcome = compare("-v " + std::to_string(kilobytes));
    if (outcome.exit_code == kDone || outcome.errors.find("shared librar") != std::string::npos) continue;
    EXPECT_EQ(outcome.exit_code,
              outcome.errors.find("shared object") == std::string::npos ? kFailed : outcome.exit_code)
        << kilobytes;
    EXPECT_THAT(outcome.errors,
                AllOf(Not(HasSubstr("signal 6")),
                      testing::AnyOf(HasSubstr("not enough memory"), HasSubstr("needs more memory"),
                                     HasSubstr("a stack that cannot grow"), HasSubstr("shared object"))))
        << kilobytes;
    told += outcome.errors.find("not enough memory") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(told, 0) << "none of the limits was too small";
}

TEST_F(SmallLimit, OfProcessorTimeIsNamed) {
  const Outcome outcome = program_.shell("ulimit -t 1; lacuna diagnose first-steps.toml --quiet --threads 1");
  if (outcome.exit_code == kDone) GTEST_SKIP() << "a second was enough";
  EXPECT_THAT(outcome.errors, HasSubstr("it used up its processor time of 1 s (ulimit -t)"));
}

}  // namespace
}  // namespace lacuna::mistaken_file_test

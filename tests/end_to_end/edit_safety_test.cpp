#include "end_to_end/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

namespace lacuna {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> kAddFriction = {"add", "first-steps.toml", "coulomb_friction", "--where", "joint.hinge"};

std::string count_of(const Program& program, const std::string& table) {
  static const Program observer;  // what the watched one prints is its own
  const Outcome count = observer.run(
      {"sql", (program.folder() / "first-steps.db").string(), "--csv", "SELECT count(*) AS n FROM " + table});
  return count.output;
}

/// Whether `add` has fitted the model without the effect, which is a run in its database, and fits the one with it now.
bool refits(const Program& program) {
  return std::filesystem::exists(program.folder() / "first-steps.db") && count_of(program, "run") == "n\n2\n";
}

/// Neither the file nor the database has the effect, and nothing lies beside them.
void expect_untouched(const Program& program, const std::string& as_written) {
  EXPECT_EQ(program.read("first-steps.toml"), as_written);
  EXPECT_EQ(count_of(program, "revision"), "n\n1\n");
  EXPECT_EQ(program.shell("ls -A | grep -v -e '^first-steps\\.' -e '^data$' -e '^robots$'").output, "");
}

TEST(Add, InterruptedInItsRefitLeavesTheFileAsItWas) {
  const Program program;
  program.copy_first_steps();
  const std::string as_written = program.read("first-steps.toml");
  const Outcome outcome = program.run_and_signal(
      kAddFriction, [&] { return refits(program); }, SIGINT);
  EXPECT_EQ(outcome.exit_code, 75) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("first-steps.toml is unchanged"));
  expect_untouched(program, as_written);
  EXPECT_THAT(program.run({"history", "first-steps.toml"}).output, Not(HasSubstr("coulomb_friction")));
}

TEST(Add, KilledInItsRefitLeavesTheFileAsItWasAndWorksTheNextTime) {
  const Program program;
  program.copy_first_steps();
  const std::string as_written = program.read("first-steps.toml");
  program.run_and_signal(
      kAddFriction, [&] { return refits(program); }, SIGKILL);
  expect_untouched(program, as_written);
  const Outcome again = program.run(kAddFriction);
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(program.read("first-steps.toml"), HasSubstr("coulomb_friction"));
}

TEST(Add, LeavesAFileAloneThatItsUserChangedDuringTheRefit) {
  const Program program;
  program.copy_first_steps();
  const std::string mine = program.read("first-steps.toml") + "# a thought\n";
  // Signal 0 sends nothing: it only tells when the refit has begun.
  const Outcome outcome = program.run_and_signal(
      kAddFriction,
      [&] {
        if (!refits(program)) return false;
        program.write("first-steps.toml", mine);
        return true;
      },
      0);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("first-steps.toml: was changed by another program during this command"));
  expect_untouched(program, mine);
}

/// Runs `add` with rename(2) of an experiment file replaced by one that kills the process before or after it.
void kill_at_the_edit(const Program& program, const std::string& when) {
  const Outcome outcome = program.shell("LD_PRELOAD='" LACUNA_KILL_AT_RENAME "' LACUNA_KILL=" + when +
                                        " lacuna add first-steps.toml coulomb_friction --where joint.hinge");
  ASSERT_NE(outcome.exit_code, 0) << "it was not killed";
}

TEST(Add, KilledBeforeItsEditLeavesFileAndDatabaseWithoutIt) {
  const Program program;
  program.copy_first_steps();
  const std::string as_written = program.read("first-steps.toml");
  kill_at_the_edit(program, "before");
  EXPECT_EQ(program.read("first-steps.toml"), as_written);
  EXPECT_EQ(count_of(program, "revision"), "n\n1\n");
  const Outcome again = program.run(kAddFriction);
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_THAT(again.output, HasSubstr("revision 1 → 2"));
  EXPECT_EQ(program.shell("ls -A | grep lacuna").output, "") << "the draft that had its name already is gone";
}

TEST(Add, KilledBehindItsEditIsTakenUpByTheNextCommand) {
  const Program program;
  program.copy_first_steps();
  const std::string as_written = program.read("first-steps.toml");
  kill_at_the_edit(program, "after");
  EXPECT_THAT(program.read("first-steps.toml"), HasSubstr("coulomb_friction"));
  EXPECT_EQ(count_of(program, "revision"), "n\n1\n");
  const Outcome undo = program.run({"undo", "first-steps.toml"});
  EXPECT_EQ(undo.exit_code, 0) << undo.errors;
  EXPECT_THAT(undo.output, HasSubstr("back at revision 1"));
  EXPECT_EQ(program.read("first-steps.toml"), as_written);
}

/// A constraint that is looked at by the commit alone stands for a disk that is full then.
TEST(Add, TakesItsEditBackWhereTheDatabaseCannotBeWritten) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program.run({"compare", "first-steps.toml"}).exit_code, 0);
  const std::string as_written = program.read("first-steps.toml");
  ASSERT_EQ(program
                .shell("sqlite3 first-steps.db 'CREATE TABLE full (id INTEGER PRIMARY KEY); ALTER TABLE revision ADD "
                       "COLUMN disk INTEGER DEFAULT 1 REFERENCES full DEFERRABLE INITIALLY DEFERRED'")
                .exit_code,
            0);
  const Outcome outcome = program.run(kAddFriction);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  expect_untouched(program, as_written);
}

/// Runs a command whose results would take the place of something that it reads.
void expect_refused(const Program& program, const std::vector<std::string>& command, const std::string& victim) {
  const std::string before = program.read(victim);
  const Outcome outcome = program.run(command);
  EXPECT_EQ(outcome.exit_code, 2) << command.back();
  EXPECT_THAT(outcome.errors, HasSubstr("choose another file for the results")) << command.back();
  EXPECT_EQ(program.read(victim), before) << command.back();
}

TEST(Outputs, AreNotWhatTheCommandReads) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program.run({"compare", "first-steps.toml"}).exit_code, 0);
  ASSERT_EQ(program.shell("ln first-steps.db second-name.db && ln -s first-steps.db link.db").exit_code, 0);
  for (const std::string output : {"first-steps.db", "./first-steps.db", "second-name.db", "link.db"})
    expect_refused(program, {"sql", "first-steps.db", "SELECT 1", "--json=" + output}, "first-steps.db");
  expect_refused(program, {"report", "first-steps.db", "--out", "first-steps.db"}, "first-steps.db");
  for (const std::string input : {"first-steps.toml", "robots/servo-pendulum.toml", "first-steps.db"})
    expect_refused(program, {"compare", "first-steps.toml", "--csv=" + input}, input);
  const std::string recording = "data/servo_pendulum/sine.csv";
  for (const std::string command : {"compare", "fit", "diagnose"})
    expect_refused(program, {command, "first-steps.toml", "--json=" + recording}, recording);
}

TEST(Outputs, AreNotTheDatabaseOfAnyCommandThatWrites) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program.run({"compare", "first-steps.toml"}).exit_code, 0);
  ASSERT_EQ(program.shell("ln -s first-steps.db link.db").exit_code, 0);
  for (const std::string output : {"first-steps.db", "link.db", "first-steps.db-wal"}) {
    const std::string json = "--json=" + output;
    expect_refused(program, {"runs", "first-steps.db", json}, "first-steps.db");
    expect_refused(program, {"sql", "first-steps.db", "SELECT 1", json}, "first-steps.db");
    expect_refused(program, {"replay", "first-steps.db", "--csv=" + output}, "first-steps.db");
    expect_refused(program, {"report", "first-steps.db", "--out", output}, "first-steps.db");
    expect_refused(program, {"compare", "first-steps.toml", json}, "first-steps.db");
  }
}

TEST(Outputs, AreNotADatabaseThatIsYetToBeMade) {
  const Program program;
  program.copy_first_steps();
  for (const std::string output : {"./new.db", "data/../new.db", "new.db-wal", "new.db-shm"}) {
    const Outcome outcome = program.run({"compare", "first-steps.toml", "--db", "new.db", "--json=" + output});
    EXPECT_EQ(outcome.exit_code, 2) << output;
    EXPECT_THAT(outcome.errors, HasSubstr("choose another file for the results")) << output;
    EXPECT_FALSE(std::filesystem::exists(program.folder() / "new.db")) << output;
  }
}

TEST(DatabaseName, IsNotEmpty) {
  const Program program;
  program.copy_first_steps();
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"compare", "first-steps.toml", "--db", ""}, {"runs", ""}}) {
    const Outcome outcome = program.run(command);
    EXPECT_EQ(outcome.exit_code, 2) << command.front();
    EXPECT_THAT(outcome.errors, HasSubstr("the name of the database is empty; name a file")) << command.front();
  }
  EXPECT_FALSE(std::filesystem::exists(program.folder() / "first-steps.db"));
}

TEST(NextCommand, HasTheDatabaseThatWasNamed) {
  const Program program;
  program.copy_first_steps();
  const std::vector<std::string> options = {"first-steps.toml", "--db", "other.db"};
  const auto output = [&](std::vector<std::string> words) {
    words.insert(words.end(), options.begin(), options.end());
    return program.run(words).output;
  };
  EXPECT_THAT(output({"fit"}), HasSubstr("→ lacuna compare first-steps.toml --db other.db\n"));
  EXPECT_THAT(output({"compare"}), HasSubstr("Next: lacuna diagnose first-steps.toml --db other.db\n"));
}

TEST(Report, OfAnEditedTextIsRefused) {
  const Program program;
  program.copy_first_steps();
  ASSERT_EQ(program.run({"compare", "first-steps.toml"}).exit_code, 0);
  ASSERT_EQ(program.shell("sqlite3 first-steps.db \"UPDATE experiment_text SET text = text || ' '\"").exit_code, 0);
  const Outcome outcome = program.run({"report", "first-steps.db", "--out", "report.html", "--no-robots"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_THAT(outcome.errors, HasSubstr("its digest does not match"));
  EXPECT_FALSE(std::filesystem::exists(program.folder() / "report.html"));
}

}  // namespace
}  // namespace lacuna

#include "end_to_end/program.h"
#include "end_to_end/small_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Names in which some interpreter would find a command that makes the file P.
class HostileNames : public testing::Test {
 public:
  ~HostileNames() override { EXPECT_FALSE(fs::exists(program_.folder() / "P")) << "a name was carried out"; }

 protected:
  std::string picture(const fs::path& file) const {
    EXPECT_TRUE(fs::exists(program_.folder() / file)) << file;
    return program_.read(file);
  }

  const Program program_;
};

class HostileRecording : public HostileNames {
 protected:
  HostileRecording() {
    program_.copy_first_steps();
    const fs::path data = program_.folder() / "data/servo_pendulum";
    fs::rename(data / "sine.csv", data / "x`touch P`.csv");
    std::string text = program_.read("first-steps.toml");
    text.replace(text.find("sine.csv"), 8, "x`touch P`.csv");
    program_.write("first-steps.toml", text);
  }
};

TEST_F(HostileRecording, IsNamedInItsPicture) {
  const Outcome outcome = program_.run({"compare", "first-steps.toml", "--out", "pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(picture("pictures/x-touch-P-.csv-angle.svg"), HasSubstr("x`touch P`.csv"));
}

TEST_F(HostileRecording, MayBeDrawnIntoAnyFolder) {
  for (const std::string folder : {"a`touch P`b", "-persist", "$(touch P)"}) {
    const Outcome outcome = program_.run({"compare", "first-steps.toml", "--quiet", "--out", folder});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
    EXPECT_THAT(picture(fs::path(folder) / "x-touch-P-.csv-angle.svg"), HasSubstr("</svg>"));
  }
}

TEST_F(HostileRecording, DoesNotMakeACommandOfItsExperimentsName) {
  fs::rename(program_.folder() / "first-steps.toml", program_.folder() / "x`touch P`.toml");
  const Outcome outcome = program_.run({"fit", "x`touch P`.toml"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("→ lacuna compare 'x`touch P`.toml'"));
}

TEST_F(HostileNames, DoNotBeginLines) {
  program_.copy_first_steps();
  const fs::path data = program_.folder() / "data/servo_pendulum";
  fs::rename(data / "sine.csv", data / "sine\nforged.csv");
  std::string text = program_.read("first-steps.toml");
  text.replace(text.find("sine.csv"), 8, "sine\\nforged.csv");
  program_.write("first-steps.toml", text);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"check", "first-steps.toml"},
        {"check", "no\nforged.toml"},
        {"new", "a\nforged.toml", "--from", "no\nforged.csv"},
        {"new", "a\nforged.toml", "--from", "data/servo_pendulum/steps.csv"},
        {"compare", "first-steps.toml", "--db", "x\nforged.db"},
        {"history", "first-steps.toml", "--db", "x\nforged.db"},
        {"report", "x\nforged.db", "--out", "r\nforged.html"}}) {
    const Outcome outcome = program_.run(arguments);
    EXPECT_THAT(outcome.output + outcome.errors, AllOf(HasSubstr("forged"), Not(HasSubstr("\nforged"))))
        << arguments[0];
  }
}

TEST_F(HostileRecording, DoesNotReachThroughALinkInTheFolder) {
  program_.write("mine.txt", "kept\n");
  fs::create_directory(program_.folder() / "pictures");
  for (const char* name : {"x-touch-P-.csv-angle.svg", "x-touch-P-.csv-predictions.csv"})
    fs::create_symlink("../mine.txt", program_.folder() / "pictures" / name);
  ASSERT_EQ(program_.run({"compare", "first-steps.toml", "--out", "pictures"}).exit_code, 0);
  EXPECT_EQ(program_.read("mine.txt"), "kept\n");
  EXPECT_THAT(picture("pictures/x-touch-P-.csv-predictions.csv"), HasSubstr("time_s"));
}

TEST_F(HostileNames, ThatLookAlikeInAShellHaveTheirOwnFiles) {
  program_.copy_first_steps();
  const fs::path data = program_.folder() / "data/servo_pendulum";
  fs::rename(data / "sine.csv", data / "a b.csv");
  fs::rename(data / "steps.csv", data / "a,b.csv");
  const Outcome outcome = program_.run(
      {"compare", "first-steps.toml", "--as-is", "--set",
       R"(target.files=["data/servo_pendulum/a b.csv", "data/servo_pendulum/a,b.csv"])", "--out", "pictures", "--csv"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("\n\"a,b.csv\",0,angle"));
  EXPECT_THAT(picture("pictures/a-b.csv-angle.svg"), HasSubstr("a b.csv"));
  EXPECT_THAT(picture("pictures/a-b.csv-angle-2.svg"), HasSubstr("a,b.csv"));
  EXPECT_NE(picture("pictures/a-b.csv-predictions.csv"), picture("pictures/a-b.csv-predictions-2.csv"));
}

TEST_F(HostileNames, InADatabaseAreDrawnAsTheyAre) {
  program_.write("small.toml", kSmallRun);
  ASSERT_EQ(program_.run({"run", "small.toml", "--quiet"}).exit_code, 0);
  program_.write(
      "hostile.sql",
      "UPDATE experiment SET name = 'e`touch P`';\n"
      "UPDATE free_value SET address = 'body.`touch P`.../../`touch P`' || position, unit = '`touch P`';\n"
      "UPDATE objective_score SET name = 'o`touch P`*', unit = 'u\"; system(\"touch P\"); \"' WHERE position = 0;\n");
  ASSERT_EQ(program_.shell("sqlite3 small.db < hostile.sql").exit_code, 0);
  const Outcome plot = program_.run({"plot", "small.db", "--out", "pictures"});
  ASSERT_EQ(plot.exit_code, 0) << plot.errors;
  EXPECT_THAT(picture("pictures/error_by_pass.svg"), testing::AllOf(HasSubstr("e`touch P`"), HasSubstr("o`touch P`")));
  const Outcome curves = program_.run({"curves", "small.db", "--out", "curves"});
  ASSERT_EQ(curves.exit_code, 0) << curves.errors;
  EXPECT_THAT(picture("curves/error_by_trials.svg"), HasSubstr("e`touch P`"));
  EXPECT_EQ(program_.shell("ls -A | grep -v -e '^small' -e '^hostile.sql$' -e '^pictures$' -e '^curves$'").output, "")
      << "nothing lies outside of the folders";
}

/// Nor do they steer the terminal: neither by what is printed, nor by lines that seem to be the program's.
TEST_F(HostileNames, InADatabaseArePrintedOnOneLineWithoutControlCharacters) {
  program_.write("small.toml", kSmallRun);
  ASSERT_EQ(program_.run({"run", "small.toml", "--quiet"}).exit_code, 0);
  program_.write(
      "hostile.sql",
      "CREATE TABLE hostile AS SELECT char(27) || '[31m' || char(10) || 'forged' AS name;\n"
      "UPDATE experiment SET name = name || (SELECT name FROM hostile);\n"
      "UPDATE free_value SET address = address || (SELECT name FROM hostile), unit = (SELECT name FROM hostile);\n"
      "UPDATE objective_score SET name = name || '*' || (SELECT name FROM hostile) WHERE position = 0;\n"
      "DROP TABLE hostile;\n");
  ASSERT_EQ(program_.shell("sqlite3 small.db < hostile.sql").exit_code, 0);
  for (const std::string command :
       {"runs small.db", "curves small.db --out c", "curves small.db --against no --out c", "hash small.db",
        "plot small.db --out p", "sql small.db 'SELECT name FROM experiment'", "replay small.db --trial 1",
        "reproduce small.db", "report small.db --out r.html"}) {
    const Outcome outcome = program_.shell("lacuna " + command);
    EXPECT_THAT(outcome.output + outcome.errors, Not(HasSubstr("\x1b"))) << command;
    EXPECT_THAT("\n" + outcome.output, Not(HasSubstr("\nforged"))) << command;
  }
  EXPECT_THAT(program_.run({"runs", "small.db"}).output, HasSubstr("small [31m forged"));
  EXPECT_THAT(program_.run({"runs", "small.db", "--json"}).output, HasSubstr("small\\u001b[31m\\nforged"));
  EXPECT_THAT(program_.run({"sql", "small.db", "SELECT name FROM experiment", "--csv"}).output,
              HasSubstr("\"small\x1b[31m\nforged\""))
      << "data are exact";
}

/// SQLite reads the first statement of what a table was made by; a report is made with the same text.
TEST_F(HostileNames, OfStatementsInASchemaAreNotCarriedOut) {
  program_.write("small.toml", kSmallRun);
  ASSERT_EQ(program_.run({"run", "small.toml", "--quiet"}).exit_code, 0);
  program_.write("hostile.sql",
                 "PRAGMA writable_schema = ON;\n"
                 "UPDATE sqlite_master SET sql = sql || '; COMMIT; ATTACH ''P'' AS p; CREATE TABLE p.x (a); BEGIN'"
                 " WHERE name IN ('experiment', 'runs');\n");
  ASSERT_EQ(program_.shell("sqlite3 small.db < hostile.sql").exit_code, 0);
  program_.run({"report", "small.db", "--out", "page.html"});
}

/// A recording must not bring lines of its own into the experiment that is drafted from it.
TEST_F(HostileNames, OfColumnsStayInTheirCommentsAndStrings) {
  program_.write("log.csv",
                 "t_s,angle_deg,\"a\"\"\r[target.command] # \",torque_Nm\n0,0,1,0\n0.1,1,2,0\n0.2,2,3,1\n0.3,3,4,1\n");
  const Outcome outcome = program_.run({"new", "rig.toml", "--from", "log.csv"});
  if (outcome.exit_code != 0) return;  // refused
  EXPECT_THAT(program_.read("rig.toml"), Not(HasSubstr("\r")));
}

/// What was there stays whole where a command fails on its way, here by a limit on the size of files.
TEST_F(HostileRecording, KeepsOldOutputsOnAFullDisk) {
  const std::string kMuch =
      "WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 50000) SELECT i FROM n";
  ASSERT_EQ(program_.run({"compare", "first-steps.toml", "--json=a.json", "--out", "pictures"}).exit_code, 0);
  ASSERT_EQ(program_.run({"sql", "first-steps.db", "--json=all.json", kMuch}).exit_code, 0);
  const std::string before = program_.read("all.json"), page = "<html>mine</html>\n";
  ASSERT_GT(before.size(), 65536U);
  program_.write("page.html", page);
  const Outcome sql = program_.shell("ulimit -f 128; lacuna sql first-steps.db --json=all.json '" + kMuch + "'");
  EXPECT_EQ(sql.exit_code, 1);
  EXPECT_THAT(sql.errors, HasSubstr("all.json: cannot be written completely"));
  EXPECT_EQ(program_.read("all.json"), before);
  EXPECT_NE(program_.shell("ulimit -f 128; lacuna report first-steps.db --out page.html").exit_code, 0);
  EXPECT_EQ(program_.read("page.html"), page);
  EXPECT_EQ(program_.shell("ls -A | grep '^.lacuna-'").output, "");
}

TEST_F(HostileNames, DevicesAndPipesAreWrittenInto) {
  EXPECT_EQ(program_.shell("lacuna plugins list --json=/dev/null").exit_code, 0);
  EXPECT_THAT(program_.shell("lacuna plugins list --json=/dev/stdout | cat").output, HasSubstr("coulomb_friction"));
  EXPECT_THAT(program_.shell("mkfifo pipe; cat pipe & lacuna plugins list --json=pipe; wait").output,
              HasSubstr("coulomb_friction"));
  EXPECT_EQ(program_.shell("lacuna plugins list --json=/dev/full").exit_code, 1);
}

/// Each line would wait for ever where it opened the pipe or read the device.
TEST_F(HostileNames, PipesAndDevicesThatHaveNoEndAreRefusedWithTheReason) {
  program_.copy_first_steps();
  program_.shell("mkfifo pipe");
  const auto refused = [&](const std::string& command) {
    const Outcome outcome = program_.shell("timeout -k 1 30 lacuna " + command + " </dev/null");
    EXPECT_EQ(outcome.exit_code, 2) << command;
    return outcome.errors;
  };
  EXPECT_THAT(refused("check pipe"), HasSubstr("pipe: is a pipe, not a regular file"));
  EXPECT_THAT(refused("check /dev/zero"), HasSubstr("/dev/zero: is a device, not a regular file"));
  EXPECT_THAT(refused("check first-steps.toml --set 'target.files=[\"pipe\"]'"),
              HasSubstr("pipe is a pipe, not a regular file"));
  EXPECT_THAT(refused("new draft.toml --from pipe"), HasSubstr("is a pipe, not a file"));
  EXPECT_THAT(refused("new draft.toml --from /dev/zero"), HasSubstr("is a device, not a file"));
  EXPECT_THAT(refused("compare first-steps.toml --json=pipe"),
              HasSubstr("pipe: cannot be written: it is a pipe without a reader"));
  EXPECT_THAT(refused("compare first-steps.toml --db pipe"), HasSubstr("pipe: is a pipe"));
}

TEST_F(HostileNames, ARecordingMayComeThroughAPipeOfTheShell) {
  program_.copy_first_steps();
  const Outcome drafted =
      program_.shell("cat data/servo_pendulum/sine.csv | lacuna new draft.toml --from /dev/stdin 2>&1; echo code $?");
  EXPECT_THAT(drafted.output, testing::AnyOf(HasSubstr("code 0"), testing::Not(HasSubstr("is a pipe"))));
}

}  // namespace
}  // namespace lacuna

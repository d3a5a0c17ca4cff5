#include "end_to_end/resume_fixture.h"

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

/// The database of a run, edited, damaged, copied, replaced.
namespace lacuna {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST_F(Resume, CommandsThatOnlyReadLeaveNoLogBehind) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  for (const char* command : {"runs small.db", "hash small.db", "sql small.db 'SELECT 1'", "replay small.db",
                              "reproduce small.db --quiet", "plot small.db --out pictures"}) {
    EXPECT_EQ(program_.shell(std::string("lacuna ") + command).exit_code, kDone) << command;
    for (const char* file : {"small.db-wal", "small.db-shm"})
      EXPECT_FALSE(std::filesystem::exists(program_.folder() / file)) << command << " left " << file;
  }
}

TEST_F(Resume, RefusesATextThatWasEdited) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  ASSERT_EQ(program_.shell("sqlite3 small.db \"UPDATE experiment_text SET text = text || '# '\"").exit_code, 0);
  for (const char* command : {"reproduce small.db", "reproduce small.db --trust", "replay small.db", "check small.toml",
                              "predict small.toml --test 0"}) {
    const Outcome outcome = program_.shell(std::string("lacuna ") + command);
    EXPECT_EQ(outcome.exit_code, kBadInput) << command;
    EXPECT_THAT(outcome.errors, HasSubstr("its digest does not match")) << command;
  }
  ASSERT_EQ(program_.shell("sqlite3 small.db \"UPDATE run SET ending = 'interrupted'\"").exit_code, 0);
  EXPECT_THAT(program_.run({"run", "small.toml", "--resume"}).errors, HasSubstr("its digest does not match"));
}

TEST_F(Resume, RefusesAFileNameThatWasEditedAndTakesADigestOfAnEarlierVersion) {
  ASSERT_EQ(program_.run({"run", "small.toml"}).exit_code, kDone);
  program_.write("old.py",
                 "import hashlib, sqlite3\n"
                 "d = sqlite3.connect('small.db')\n"
                 "text, overrides = d.execute('SELECT text, overrides FROM experiment_text').fetchone()\n"
                 "digest = hashlib.sha256((text + '\\n' + overrides).encode()).hexdigest()\n"
                 "d.execute('UPDATE experiment_text SET digest = ?', (digest,))\n"
                 "d.commit()\n");
  ASSERT_EQ(program_.shell("cp small.db edited.db && python3 old.py").exit_code, 0);
  EXPECT_EQ(program_.run({"reproduce", "small.db"}).exit_code, kDone);
  ASSERT_EQ(program_.shell("sqlite3 edited.db \"UPDATE experiment_text SET file = 'other.toml'\"").exit_code, 0);
  const Outcome edited = program_.run({"reproduce", "edited.db"});
  EXPECT_EQ(edited.exit_code, kBadInput);
  EXPECT_THAT(
      edited.errors,
      HasSubstr("differs from the text or file name that was stored when the run began (its digest does not match)"));
}

TEST_F(Resume, ADatabaseThatIsCopiedOverTheOpenOneStaysAsItIs) {
  const Outcome noticed = run_and_copy_over({});
  EXPECT_EQ(noticed.exit_code, 1) << noticed.errors;
  EXPECT_THAT(noticed.errors, AllOf(HasSubstr("small.db: was overwritten by another program while it was open"),
                                    Not(HasSubstr("nothing is lost"))));
  EXPECT_EQ(program_.read("small.db"), program_.read("theirs.db"));
  EXPECT_FALSE(std::filesystem::exists(program_.folder() / "small.db-wal"));
  EXPECT_EQ(hash("small.db"), hash("theirs.db"));
}

/// Restored from a copy that was made in the midst of a run, the run goes on to the same end.
TEST_F(Resume, GoesOnFromABackup) {
  program_.write("lines", "");
  const auto back_up = [&] {
    if (program_.read("lines").find("\"progress\"") == std::string::npos) return false;
    const Outcome copied = program_.run({"backup", "small.db", "copy.db"});
    EXPECT_EQ(copied.exit_code, kDone) << copied.errors;
    EXPECT_THAT(copied.output, ContainsRegex("copy.db: [0-9.]+ MB, a checked copy of small.db"));
    return true;
  };
  EXPECT_EQ(
      program_.run_and_signal({"run", "small.toml", "--json=lines", "--threads", "1"}, back_up, SIGCONT).exit_code,
      kDone);
  constexpr const char* kModels = "SELECT count(*) FROM model";
  EXPECT_NE(ask("copy.db", kModels), ask("small.db", kModels)) << "the copy is of a run under way";
  const Outcome resumed = program_.run({"run", "small.toml", "--db", "copy.db", "--resume"});
  EXPECT_EQ(resumed.exit_code, kDone) << resumed.errors;
  EXPECT_EQ(hash("copy.db"), hash("small.db"));
  const Outcome again = program_.run({"backup", "small.db", "copy.db"});
  EXPECT_EQ(again.exit_code, kBadInput);
  EXPECT_THAT(again.errors, HasSubstr("copy.db: already exists; name a new file, or move it away"));
}

TEST_F(Resume, SaysOnceForAllReplicatesThatTheDatabaseWasWrittenOver) {
  const Outcome noticed = run_and_copy_over({"--replicates", "3", "--quiet"});
  EXPECT_EQ(noticed.exit_code, 1) << noticed.errors;
  const std::size_t first = noticed.errors.find("was overwritten by another program");
  ASSERT_NE(first, std::string::npos) << noticed.errors;
  EXPECT_EQ(noticed.errors.find("was overwritten by another program", first + 1), std::string::npos) << noticed.errors;
  EXPECT_THAT(noticed.errors, HasSubstr("runs 1, 2, 3: small.db: was overwritten"));
}

TEST_F(Resume, DoesNotSayThatNothingIsLostOfADamagedDatabase) {
  interrupt({});
  ASSERT_EQ(program_.shell("sqlite3 small.db \"UPDATE checkpoint SET digest = lower(hex(zeroblob(32)))\"").exit_code,
            0);
  const Outcome damaged = program_.run({"run", "small.toml", "--resume"});
  EXPECT_EQ(damaged.exit_code, 1);
  EXPECT_THAT(damaged.errors, AllOf(HasSubstr("run 1: small.db: the checkpoint of run 1 is damaged"),
                                    HasSubstr("earlier results may be lost"), Not(HasSubstr("nothing is lost"))));
}

/// Another database is moved over one that is being written, and the writer goes on, or is killed.
TEST_F(Resume, AReplacedDatabaseHarmsNobody) {
  ASSERT_EQ(program_.run({"run", "small.toml", "--db", "theirs.db"}).exit_code, kDone);
  const std::string theirs = program_.read("theirs.db"), their_hash = hash("theirs.db");
  const auto replace = [&] {
    if (program_.read("lines").find("\"trial\"") == std::string::npos) return false;
    program_.write("new.db", theirs);
    std::filesystem::rename(program_.folder() / "new.db", program_.folder() / "small.db");
    return true;
  };
  const std::vector<std::string> run = {"run", "small.toml", "--json=lines", "--threads", "1"};
  program_.write("lines", "");
  const Outcome noticed = program_.run_and_signal(run, replace, SIGCONT);
  EXPECT_EQ(noticed.exit_code, 1) << noticed.errors;
  EXPECT_THAT(noticed.errors, AllOf(HasSubstr("small.db: was replaced by another file while it was open"),
                                    HasSubstr("small.db.rescued"), HasSubstr("--resume and --db FILE"),
                                    Not(HasSubstr("lacuna run small.toml"))))
      << "that would go on with the other database";
  EXPECT_EQ(program_.read("small.db"), theirs);
  EXPECT_FALSE(std::filesystem::exists(program_.folder() / "small.db-wal"));
  EXPECT_THAT(program_.run({"runs", "small.db.rescued"}).output, ContainsRegex("1 +small +1"));
  EXPECT_EQ(program_.run({"run", "small.toml", "--resume", "--db", "small.db.rescued"}).exit_code, kDone);
  EXPECT_EQ(hash("small.db.rescued"), their_hash) << "it goes on to the same rows";

  for (const std::string command :
       {"lacuna sql small.db 'SELECT count(*) FROM runs'", "lacuna hash small.db",
        "lacuna report small.db --out report.html", "(timeout -s INT 3 lacuna serve small.db --port 0 || true)",
        "lacuna run small.toml --resume"}) {
    std::filesystem::remove(program_.folder() / "small.db");
    program_.write("lines", "");
    ASSERT_EQ(program_.run_and_signal(run, replace, SIGKILL).exit_code, 128 + SIGKILL);
    const std::string log = program_.read("small.db-wal");
    ASSERT_GT(log.size(), 4096U) << "the test would show nothing";
    const Outcome outcome = program_.shell(command);
    EXPECT_THAT(outcome.errors, HasSubstr("small.db-wal: contains changes to another database")) << command;
    EXPECT_EQ(hash("small.db"), their_hash) << command;
    EXPECT_EQ(program_.read("small.db-wal.set-aside"), log) << command;
    std::filesystem::remove(program_.folder() / "small.db-wal.set-aside");
  }
}

}  // namespace
}  // namespace lacuna

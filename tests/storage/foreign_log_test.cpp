#include "storage/asked.h"
#include "storage/child_process.h"
#include "storage/core/statement.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <sys/stat.h>

#include <fstream>
#include <functional>

namespace lacuna {
namespace {

using test::add_experiments;
using test::ask;
using test::ChildProcess;
using test::is_intact;
using test::sentence_of;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// What `action` prints to standard error.
std::string said_by(const std::function<void()>& action) {
  testing::internal::CaptureStderr();
  action();
  return testing::internal::GetCapturedStderr();
}

class ForeignLog : public testing::Test {
 protected:
  /// A closed database with so many experiments.
  static void make(const fs::path& file, int experiments) {
    Database database = Database::open(file);
    add_experiments(database, 0, experiments);
  }
  /// Adds experiments in a process that is killed while the log holds them.
  static void add_and_be_killed(const fs::path& file, int first, int count) {
    ChildProcess child([&](int to_parent) {
      Database database = Database::open(file);
      add_experiments(database, first, count);
      ChildProcess::say(to_parent, "w");
      pause();
    });
    ASSERT_EQ(child.next(), 'w');
    child.kill();
    ASSERT_GT(fs::file_size(file.string() + "-wal"), 5000U) << "the test would show nothing";
  }
  /// The same with any SQL on SQLite alone, as another program would.
  static void execute_and_be_killed(const fs::path& file, const std::string& sql) {
    ChildProcess child([&](int to_parent) {
      sqlite3* handle = nullptr;
      sqlite3_open(file.c_str(), &handle);
      ChildProcess::say(to_parent,
                        sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK ? "w" : "f");
      pause();
    });
    ASSERT_EQ(child.next(), 'w');
    child.kill();
  }
  static std::int64_t experiments_in(const fs::path& file) {
    const Database database = Database::open_read_only(file);
    EXPECT_TRUE(is_intact(database));
    return ask(database, "SELECT count(*) FROM experiment");
  }
  /// Opens it in this way, and says what that printed; the file itself must be what it was before.
  std::string opened(const std::function<void(const fs::path&)>& open) const {
    const std::string before = read_bytes(file_), log = read_bytes(log_);
    std::string said = said_by([&] { open(file_); });
    EXPECT_EQ(read_bytes(file_.string() + "-wal.set-aside"), log) << "nothing of the log is lost";
    if (experiments_in(file_) != 2) ADD_FAILURE() << "the file has other content";
    EXPECT_EQ(read_bytes(file_).substr(0, 18), before.substr(0, 18));
    return said;
  }

  TestFolder folder_;
  fs::path file_ = folder_ / "rig.db";
  fs::path log_ = folder_ / "rig.db-wal";
  fs::path other_ = folder_ / "other.db";
};

const auto write_to = [](const fs::path& file) { Database::open(file); };
const auto read_from = [](const fs::path& file) { Database::open_read_only(file); };

TEST_F(ForeignLog, OfAKilledWriterIsSetAsideBeforeTheFileThatTookItsPlaceIsWritten) {
  make(file_, 3);
  make(other_, 2);
  add_and_be_killed(file_, 3, 40);
  fs::rename(other_, file_);
  EXPECT_THAT(opened(write_to), AllOf(HasSubstr("rig.db-wal: contains changes to another database"),
                                      HasSubstr("set aside as " + log_.string() + ".set-aside")));
}

TEST_F(ForeignLog, OfAKilledWriterIsSetAsideBeforeTheFileThatTookItsPlaceIsRead) {
  make(file_, 3);
  make(other_, 2);
  add_and_be_killed(file_, 3, 40);
  fs::rename(other_, file_);
  const std::string before = read_bytes(file_);
  EXPECT_THAT(opened(read_from), HasSubstr("set aside"));
  EXPECT_EQ(read_bytes(file_), before);
}

TEST_F(ForeignLog, OfANewDatabaseThatWasNeverClosedIsSetAsideToo) {
  add_and_be_killed(file_, 0, 40);
  make(other_, 2);
  fs::rename(other_, file_);
  EXPECT_THAT(opened(read_from), HasSubstr("set aside"));
}

TEST_F(ForeignLog, OfALaterStateIsSetAsideWhereAnOldCopyIsPutBack) {
  make(file_, 2);
  fs::copy_file(file_, other_);
  {
    Database later = Database::open(file_);
    add_experiments(later, 2, 5);
  }
  add_and_be_killed(file_, 7, 40);
  fs::rename(other_, file_);
  EXPECT_THAT(opened(write_to), HasSubstr("set aside"));
}

TEST_F(ForeignLog, IsSetAsideWhereThereWasNoFileAnyMore) {
  make(file_, 3);
  add_and_be_killed(file_, 3, 40);
  fs::rename(file_, other_);
  const std::string log = read_bytes(log_);
  EXPECT_THAT(said_by([&] { make(file_, 2); }), HasSubstr("set aside"));
  EXPECT_EQ(experiments_in(file_), 2);
  fs::rename(log_.string() + ".set-aside", other_.string() + "-wal");
  EXPECT_EQ(experiments_in(other_), 43) << "as the sentence says: nothing was lost";
}

TEST_F(ForeignLog, OfAnotherProgramIsSetAside) {
  execute_and_be_killed(file_, "PRAGMA journal_mode = WAL; CREATE TABLE a (x); INSERT INTO a VALUES (zeroblob(9000))");
  make(other_, 2);
  fs::rename(other_, file_);
  EXPECT_THAT(opened(write_to), HasSubstr("set aside"));
}

TEST_F(ForeignLog, LeavesATextFileAsItIs) {
  make(file_, 3);
  add_and_be_killed(file_, 3, 40);
  const std::string text = "t,position\n" + std::string(9000, '1') + "\n";
  std::ofstream(other_) << text;
  fs::rename(other_, file_);
  std::string sentence;
  said_by([&] { sentence = sentence_of([&] { Database::open(file_); }); });
  EXPECT_THAT(sentence, HasSubstr("is not a Lacuna database"));
  EXPECT_EQ(read_bytes(file_), text);
  EXPECT_TRUE(fs::exists(log_.string() + ".set-aside"));
}

TEST_F(ForeignLog, IsNotReadWhereItCannotBeSetAside) {
  make(file_, 3);
  make(other_, 2);
  add_and_be_killed(file_, 3, 40);
  fs::rename(other_, file_);
  chmod(folder_.path().c_str(), 0555);
  ChildProcess child([&](int to_parent) {
    if (geteuid() == 0 && setuid(65534) != 0) return ChildProcess::say(to_parent, "no guest");
    ChildProcess::say(to_parent, "read: " + std::to_string(experiments_in(file_)));
  });
  EXPECT_EQ(child.all(), "read: 2");
  chmod(folder_.path().c_str(), 0755);
}

TEST_F(ForeignLog, OnesOwnIsKeptAfterAKill) {
  make(file_, 3);
  add_and_be_killed(file_, 3, 40);
  EXPECT_EQ(said_by([&] { EXPECT_EQ(experiments_in(file_), 43); }), "");
  EXPECT_EQ(said_by([&] { Database::open(file_); }), "");
  EXPECT_EQ(experiments_in(file_), 43);
}

TEST_F(ForeignLog, OnesOwnIsKeptWhereAnotherProgramWroteIt) {
  make(file_, 3);
  execute_and_be_killed(file_, "UPDATE run SET command = 'by hand'");
  EXPECT_EQ(said_by([&] { Database::open(file_); }), "");
  EXPECT_EQ(ask(Database::open_read_only(file_), "SELECT count(*) FROM run WHERE command = 'by hand'"), 1);
}

TEST_F(ForeignLog, OnesOwnIsKeptAfterAVacuumThatWasKilled) {
  make(file_, 30);
  execute_and_be_killed(file_, "UPDATE experiment_text SET file = 'moved'; VACUUM");
  EXPECT_EQ(said_by([&] { EXPECT_EQ(experiments_in(file_), 30); }), "");
  EXPECT_EQ(ask(Database::open_read_only(file_), "SELECT count(*) FROM experiment_text WHERE file = 'moved'"), 30);
}

TEST_F(ForeignLog, OnesOwnIsKeptWithACopyOfBothFiles) {
  make(file_, 3);
  add_and_be_killed(file_, 3, 40);
  fs::copy_file(file_, other_);
  fs::copy_file(log_, other_.string() + "-wal");
  EXPECT_EQ(said_by([&] { EXPECT_EQ(experiments_in(other_), 43); }), "");
  EXPECT_EQ(experiments_in(file_), 43);
}

/// Checkpoints bring a part of the log into the file again and again.
TEST_F(ForeignLog, OfALiveWriterIsLeftToIt) {
  make(file_, 1);
  ChildProcess child([&](int to_parent) {
    Database database = Database::open(file_);
    database.execute("PRAGMA wal_autocheckpoint = 20");
    for (int i = 0; i < 300; ++i) {
      add_experiments(database, 1 + i, 1);
      if (i == 0) ChildProcess::say(to_parent, "w");
    }
    ChildProcess::say(to_parent, "e");
  });
  ASSERT_EQ(child.next(), 'w');
  std::int64_t before = 0;
  const std::string said = said_by([&] {
    for (int i = 0; i < 100; ++i) {
      const std::int64_t now = ask(Database::open_read_only(file_), "SELECT count(*) FROM experiment");
      ASSERT_GE(now, before);
      before = now;
      if (i % 10 == 0) Database::open(file_);
    }
  });
  EXPECT_EQ(said, "");
  EXPECT_EQ(child.all(), "e");
  EXPECT_EQ(experiments_in(file_), 301);
}

TEST_F(ForeignLog, OfAReplacedFileIsTakenAwayByItsWriterWhichKeepsWhatWasCommitted) {
  make(other_, 2);
  const std::string theirs = read_bytes(other_);
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 40);
    fs::rename(other_, file_);
    EXPECT_THAT(sentence_of([&] { add_experiments(database, 40, 1); }),
                AllOf(HasSubstr("rig.db: was replaced by another file while it was open"),
                      HasSubstr("The rows stored so far are in " + file_.string() + ".rescued")));
    EXPECT_FALSE(fs::exists(log_));
    EXPECT_FALSE(fs::exists(file_.string() + "-shm"));
    EXPECT_EQ(experiments_in(file_), 2) << "while the other is still open";
  }
  EXPECT_EQ(read_bytes(file_), theirs);
  EXPECT_EQ(experiments_in(file_.string() + ".rescued"), 40);
}

TEST_F(ForeignLog, OfAFileThatWasReplacedAfterTheLastCommitIsTakenAwayAtTheEnd) {
  make(other_, 2);
  const std::string theirs = read_bytes(other_);
  const std::string said = said_by([&] {
    Database database = Database::open(file_);
    add_experiments(database, 0, 40);
    fs::rename(other_, file_);
  });
  EXPECT_THAT(said, AllOf(HasSubstr("was replaced by another file"), HasSubstr("rig.db.rescued")));
  EXPECT_FALSE(fs::exists(log_));
  EXPECT_EQ(read_bytes(file_), theirs);
  EXPECT_EQ(experiments_in(file_.string() + ".rescued"), 40);
}

TEST_F(ForeignLog, IsNotTheOneThatTheNewFileHasMeanwhile) {
  make(other_, 2);
  Database database = Database::open(file_);
  add_experiments(database, 0, 40);
  fs::rename(other_, file_);
  Database theirs = Database::open(file_);
  EXPECT_TRUE(fs::exists(log_.string() + ".set-aside"));
  add_experiments(theirs, 2, 3);
  EXPECT_THAT(sentence_of([&] { add_experiments(database, 40, 1); }), HasSubstr("rig.db.rescued"));
  EXPECT_TRUE(fs::exists(log_)) << "it is the other one's";
  EXPECT_EQ(experiments_in(file_.string() + ".rescued"), 40);
  EXPECT_EQ(ask(theirs, "SELECT count(*) FROM experiment"), 5);
}

constexpr const char* kInHalfATransaction =
    "PRAGMA journal_mode = DELETE; CREATE TABLE IF NOT EXISTS a (x); INSERT INTO a VALUES (zeroblob(300000));"
    "PRAGMA cache_size = 5; BEGIN; UPDATE a SET x = randomblob(300000)";

TEST_F(ForeignLog, ThatIsARollbackJournalIsSetAside) {
  execute_and_be_killed(file_, kInHalfATransaction);
  ASSERT_GT(fs::file_size(file_.string() + "-journal"), 5000U);
  make(other_, 2);
  fs::rename(other_, file_);
  EXPECT_THAT(said_by([&] { EXPECT_EQ(experiments_in(file_), 2); }), HasSubstr("rig.db-journal.set-aside"));
}

TEST_F(ForeignLog, OnesOwnRollbackJournalIsPlayedBack) {
  make(file_, 3);
  execute_and_be_killed(file_, kInHalfATransaction);
  ASSERT_GT(fs::file_size(file_.string() + "-journal"), 5000U);
  EXPECT_EQ(said_by([&] { Database::open(file_); }), "");
  EXPECT_EQ(experiments_in(file_), 3);
  EXPECT_EQ(ask(Database::open_read_only(file_), "SELECT count(*) FROM a WHERE x = zeroblob(300000)"), 1);
}

}  // namespace
}  // namespace lacuna

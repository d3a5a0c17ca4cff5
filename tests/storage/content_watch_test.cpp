#include "storage/asked.h"
#include "storage/child_process.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fcntl.h>
#include <unistd.h>

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
using testing::Not;

class WrittenOver : public testing::Test {
 protected:
  /// As `cp` does it: into the same file. In another process, since to close a file drops the locks of its process.
  void write_over(const std::string& bytes) const {
    ChildProcess child([&](int to_parent) {
      std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
      ChildProcess::say(to_parent, "w");
    });
    ASSERT_EQ(child.all(), "w");
  }
  /// What another program does with SQLite.
  void execute_elsewhere(const char* sql) const {
    ChildProcess child([&](int to_parent) {
      sqlite3* handle = nullptr;
      sqlite3_open(file_.c_str(), &handle);
      const int result = sqlite3_exec(handle, sql, nullptr, nullptr, nullptr);
      ChildProcess::say(to_parent, result == SQLITE_OK ? "w" : sqlite3_errmsg(handle));
    });
    ASSERT_EQ(child.all(), "w");
  }
  /// Another database's bytes.
  std::string another(int experiments = 2) const {
    const std::filesystem::path other = folder_ / "other.db";
    {
      Database database = Database::open(other);
      add_experiments(database, 0, experiments);
    }
    return read_bytes(other);
  }
  void expect_left_as(const std::string& bytes) const {
    EXPECT_TRUE(read_bytes(file_) == bytes) << "the file is not the one that was copied there";
    EXPECT_FALSE(std::filesystem::exists(log_));
    EXPECT_FALSE(std::filesystem::exists(file_.string() + "-shm"));
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db", log_ = folder_ / "rig.db-wal";
};

constexpr const char* kNoticed =
    "rig.db: was overwritten by another program while it was open; it stays as it is, and nothing more is written";

TEST_F(WrittenOver, ByAnotherDatabaseIsNoticedAtTheNextCommit) {
  const std::string theirs = another();
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 40);
    write_over(theirs);
    EXPECT_THAT(sentence_of([&] { add_experiments(database, 40, 1); }),
                AllOf(HasSubstr(kNoticed), HasSubstr("its log was set aside as " + log_.string() + ".set-aside")));
    EXPECT_THAT(sentence_of([&] { add_experiments(database, 41, 1); }), HasSubstr(kNoticed));
    expect_left_as(theirs);
  }
  expect_left_as(theirs);
}

TEST_F(WrittenOver, AfterTheLastCommitIsNoticedAtTheEnd) {
  const std::string theirs = another();
  testing::internal::CaptureStderr();
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 40);
    write_over(theirs);
  }
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(kNoticed));
  expect_left_as(theirs);
}

TEST_F(WrittenOver, BeforeTheFirstCommitIsNoticed) {
  const std::string theirs = another();
  {
    Database database = Database::open(file_);
    write_over(theirs);
    EXPECT_THAT(sentence_of([&] { add_experiments(database, 0, 1); }), HasSubstr(kNoticed));
  }
  expect_left_as(theirs);
}

TEST_F(WrittenOver, InATransactionIsNoticedBeforeItsCommit) {
  const std::string theirs = another();
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 40);
    Transaction transaction(database);
    database.execute("INSERT INTO schema_text (name, sha256) VALUES ('other', 'x')");
    write_over(theirs);
    EXPECT_THAT(sentence_of([&] { transaction.commit(); }), HasSubstr(kNoticed));
  }
  expect_left_as(theirs);
}

TEST_F(WrittenOver, IsNoticedBeforeTheLogIsBroughtIntoTheFile) {
  const std::string theirs = another();
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 1);
    database.execute("BEGIN; UPDATE experiment_text SET text = text || hex(zeroblob(4000000))");
    write_over(theirs);
    database.execute("COMMIT");
    ASSERT_GT(std::filesystem::file_size(log_), 1000U * 4096U) << "the test would show nothing";
    EXPECT_TRUE(read_bytes(file_) == theirs);
    EXPECT_THAT(sentence_of([&] { database.check_in_place(); }), HasSubstr(kNoticed));
  }
  expect_left_as(theirs);
}

TEST_F(WrittenOver, ByWhatIsNoDatabaseIsNoticed) {
  for (const std::string& bytes : {std::string(), std::string("text\n"), std::string(300'000, '\0')}) {
    std::filesystem::remove(file_);
    {
      Database database = Database::open(file_);
      add_experiments(database, 0, 40);
      write_over(bytes);
      EXPECT_THAT(sentence_of([&] { add_experiments(database, 40, 1); }), HasSubstr(kNoticed));
    }
    expect_left_as(bytes);
  }
}

TEST_F(WrittenOver, IsAlsoAFileThatWasCut) {
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 40);
    std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 4096 / 2 * 4096);
    EXPECT_THAT(sentence_of([&] { add_experiments(database, 40, 1); }), HasSubstr(kNoticed));
  }
  EXPECT_FALSE(std::filesystem::exists(log_));
}

TEST_F(WrittenOver, ByAnOlderCopyOfItselfIsNoticed) {
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 3);
  }
  const std::string before = read_bytes(file_);
  {
    Database database = Database::open(file_);
    add_experiments(database, 3, 100, 60'000);
    ASSERT_FALSE(read_bytes(file_) == before) << "the test would show nothing";
    write_over(before);
    EXPECT_THAT(sentence_of([&] { add_experiments(database, 103, 1); }), HasSubstr(kNoticed));
  }
  expect_left_as(before);
}

/// As it was at the last look, before what another program's checkpoint brought into it.
TEST_F(WrittenOver, ByItsOwnStateBeforeACheckpointIsNoticed) {
  for (const char* mode : {"PASSIVE", "RESTART", "TRUNCATE"}) {
    std::filesystem::remove(file_);
    std::filesystem::remove(log_.string() + ".set-aside");
    Database database = Database::open(file_);
    add_experiments(database, 0, 3);
    const std::string before = read_bytes(file_);
    add_experiments(database, 3, 5);
    execute_elsewhere((std::string("PRAGMA wal_checkpoint(") + mode + ")").c_str());
    ASSERT_FALSE(read_bytes(file_) == before) << "the test would show nothing";
    write_over(before);
    EXPECT_THAT(sentence_of([&] { add_experiments(database, 8, 1); }), HasSubstr(kNoticed)) << mode;
    expect_left_as(before);
  }
}

class RestoredOver : public WrittenOver {
 protected:
  /// The sqlite3 program's `.restore`, in another process.
  void restore(const std::filesystem::path& source, bool checkpoint = false) const {
    ChildProcess child([&](int to_parent) {
      sqlite3 *from = nullptr, *to = nullptr;
      sqlite3_open(source.c_str(), &from);
      sqlite3_open(file_.c_str(), &to);
      sqlite3_backup* backup = sqlite3_backup_init(to, "main", from, "main");
      const bool done = backup != nullptr && sqlite3_backup_step(backup, -1) == SQLITE_DONE;
      sqlite3_backup_finish(backup);
      if (checkpoint) sqlite3_wal_checkpoint_v2(to, "main", SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
      ChildProcess::say(to_parent, done ? "w" : sqlite3_errmsg(to));
    });
    ASSERT_EQ(child.all(), "w");
  }
  void expect_restored(std::int64_t experiments) const {
    EXPECT_FALSE(std::filesystem::exists(log_));
    EXPECT_EQ(ask(Database::open_read_only(file_), "SELECT count(*) FROM experiment"), experiments);
  }
};

TEST_F(RestoredOver, ByAnotherDatabaseIsNoticedBeforeAnythingIsWritten) {
  another(7);
  for (const bool checkpoint : {false, true}) {
    std::filesystem::remove(file_);
    {
      Database database = Database::open(file_);
      add_experiments(database, 0, 40);
      restore(folder_ / "other.db", checkpoint);
      EXPECT_THAT(sentence_of([&] { add_experiments(database, 40, 1); }),
                  AllOf(HasSubstr(kNoticed), Not(HasSubstr("aside"))));
      EXPECT_THAT(sentence_of([&] { add_experiments(database, 41, 1); }), HasSubstr(kNoticed));
    }
    expect_restored(7);
  }
}

TEST_F(RestoredOver, ByAnEarlierStateOfItselfIsNoticed) {
  const std::filesystem::path earlier = folder_ / "earlier.db";
  {
    Database database = Database::open(file_);
    add_experiments(database, 0, 3);
    execute_elsewhere(("VACUUM INTO '" + earlier.string() + "'").c_str());
    add_experiments(database, 3, 5);
    restore(earlier);
    EXPECT_THAT(sentence_of([&] { database.check_in_place(); }), HasSubstr(kNoticed));
  }
  expect_restored(3);
}

TEST_F(WrittenOver, IsNotAFileThatItsOwnCommitsChange) {
  Database database = Database::open(file_);
  int changes = 0;
  std::string before = read_bytes(file_);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(sentence_of([&] { add_experiments(database, 20 * i, 20, 40'000); }), "no error");
    if (std::string now = read_bytes(file_); now != before) {
      before = std::move(now);
      ++changes;
    }
  }
  EXPECT_GE(changes, 3) << "the test would show nothing";
  EXPECT_LT(std::filesystem::file_size(log_), 2000U * 4096U) << "the log is brought into the file";
}

TEST_F(WrittenOver, IsNotAFileThatAnotherWriterChanges) {
  Database database = Database::open(file_);
  for (int i = 0; i < 10; ++i) {
    ChildProcess child([&](int to_parent) {
      Database theirs = Database::open(file_);
      add_experiments(theirs, 10'000 + 50 * i, 50, 50'000);
      ChildProcess::say(to_parent, "w");
    });
    EXPECT_EQ(sentence_of([&] { add_experiments(database, 50 * i, 50, 50'000); }), "no error");
    ASSERT_EQ(child.all(), "w");
    execute_elsewhere(i % 2 == 0 ? "PRAGMA wal_checkpoint(TRUNCATE)" : "VACUUM; PRAGMA wal_checkpoint(TRUNCATE)");
  }
  EXPECT_EQ(sentence_of([&] { add_experiments(database, 500, 1); }), "no error");
  EXPECT_TRUE(is_intact(database));
  EXPECT_EQ(ask(database, "SELECT count(*) FROM experiment"), 1001);
}

TEST_F(WrittenOver, IsNotAFileWhoseTimeAloneChanged) {
  Database database = Database::open(file_);
  add_experiments(database, 0, 3);
  std::filesystem::permissions(file_, std::filesystem::perms::owner_all);
  EXPECT_EQ(sentence_of([&] { add_experiments(database, 3, 1); }), "no error");
}

}  // namespace
}  // namespace lacuna

#include "storage/asked.h"
#include "storage/core/migrate.h"
#include "storage/core/statement.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <array>
#include <atomic>
#include <fstream>
#include <thread>

namespace lacuna {
namespace {

using test::ask;
using test::sentence_of;
using testing::HasSubstr;

/// The sentence with which `action` fails.
class DatabaseTest : public testing::Test {
 protected:
  std::string open_sentence() {
    return sentence_of([&] { Database::open(file_); });
  }
  std::string read_sentence() {
    return sentence_of([&] { Database::open_read_only(file_); });
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db";
};

TEST_F(DatabaseTest, ANewFileSaysWhoseItIsAndWhichVersion) {
  const Database database = Database::open(file_);
  EXPECT_EQ(ask(database, "PRAGMA application_id"), kApplicationId);
  EXPECT_EQ(ask(database, "PRAGMA user_version"), schema_migrations().back().number);
  EXPECT_EQ(ask(database, "PRAGMA foreign_keys"), 1);
  EXPECT_EQ(ask(database, "PRAGMA synchronous"), 2) << "FULL";
  EXPECT_EQ(ask(database, "SELECT count(*) FROM pragma_journal_mode WHERE journal_mode = 'wal'"), 1);
}

TEST_F(DatabaseTest, MigrationsAreNumberedWithoutGaps) {
  int expected = 1;
  for (const Migration& migration : schema_migrations()) EXPECT_EQ(migration.number, expected++);
}

TEST_F(DatabaseTest, EveryTableIsStrict) {
  const Database database = Database::open(file_);
  EXPECT_EQ(ask(database,
                "SELECT count(*) FROM pragma_table_list WHERE schema = 'main' AND type = 'table'"
                " AND name NOT LIKE 'sqlite_%' AND NOT strict"),
            0);
}

TEST_F(DatabaseTest, ReferencesAreEnforced) {
  Database database = Database::open(file_);
  EXPECT_THAT(sentence_of([&] { database.execute("INSERT INTO provenance VALUES (5,'','','','','','','','','')"); }),
              HasSubstr("FOREIGN KEY"));
}

TEST_F(DatabaseTest, ATextFileIsNotADatabaseAndStaysAsItIs) {
  std::ofstream(file_) << "t,position\n0,1\n0.1,2 and more than a header's worth of text to make SQLite look at it\n";
  const std::string before = read_bytes(file_);
  EXPECT_THAT(open_sentence(), HasSubstr("rig.db: is not a Lacuna database"));
  EXPECT_THAT(read_sentence(), HasSubstr("is not a Lacuna database"));
  EXPECT_EQ(read_bytes(file_), before);
}

TEST_F(DatabaseTest, ADatabaseOfAnotherProgramIsRefusedAndStaysAsItIs) {
  {
    Database foreign = Database::open(file_, {{1, "CREATE TABLE theirs (a); PRAGMA journal_mode = DELETE"}});
    foreign.execute("PRAGMA application_id = 7; PRAGMA journal_mode = DELETE");
  }
  const std::string before = read_bytes(file_);
  EXPECT_THAT(open_sentence(), HasSubstr("is not a Lacuna database but that of another program"));
  EXPECT_THAT(read_sentence(), HasSubstr("is not a Lacuna database but that of another program"));
  EXPECT_EQ(read_bytes(file_), before);
}

TEST_F(DatabaseTest, ANewerVersionIsRefused) {
  { Database::open(file_).execute("PRAGMA user_version = 99"); }
  EXPECT_THAT(open_sentence(), HasSubstr("was written by a newer Lacuna (schema 99"));
  EXPECT_THAT(read_sentence(), HasSubstr("was written by a newer Lacuna (schema 99"));
}

/// By somebody who experiments with the header.
TEST_F(DatabaseTest, AWrongVersionGetsASentenceAndLeavesTheFileAsItIs) {
  const int newest = schema_migrations().back().number;
  for (const int wrong : {0, 1, newest - 1, -1, -2147483647, 2147483647}) {
    { Database::open(file_).execute("PRAGMA user_version = " + std::to_string(wrong)); }
    const std::string before = read_bytes(file_);
    for (const std::string& sentence : {open_sentence(), read_sentence()})
      EXPECT_THAT(sentence, testing::AllOf(HasSubstr("rig.db: its header says schema " + std::to_string(wrong)),
                                           HasSubstr("PRAGMA user_version = N")));
    EXPECT_EQ(read_bytes(file_), before) << wrong;
    EXPECT_FALSE(std::filesystem::exists(file_.string() + ".before-version-" + std::to_string(newest)));
    std::filesystem::remove(file_);
  }
}

TEST_F(DatabaseTest, AHeaderWithoutTablesGetsASentence) {
  for (const int version : {1, schema_migrations().back().number}) {
    Database::open_blank(file_).execute("PRAGMA application_id = " + std::to_string(kApplicationId) +
                                        "; PRAGMA user_version = " + std::to_string(version));
    const std::string before = read_bytes(file_);
    for (const std::string& sentence : {open_sentence(), read_sentence()})
      EXPECT_THAT(sentence, HasSubstr("has the header of schema " + std::to_string(version) + " but no tables"));
    EXPECT_EQ(read_bytes(file_), before);
  }
}

TEST_F(DatabaseTest, AFolderAndAMissingFolderGetASentence) {
  std::filesystem::create_directory(file_);
  EXPECT_THAT(open_sentence(), HasSubstr("is a folder"));
  EXPECT_THAT(sentence_of([&] { Database::open(folder_ / "no/such/rig.db"); }), HasSubstr("cannot be opened"));
  EXPECT_THAT(sentence_of([&] { Database::open_read_only(folder_ / "none.db"); }), HasSubstr("no such database"));
}

TEST_F(DatabaseTest, WhatIsNoRegularFileGetsASentence) {
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  const auto sentence = HasSubstr("is a pipe, a socket or a device, not a regular file; name a database file");
  EXPECT_THAT(open_sentence(), sentence);
  EXPECT_THAT(read_sentence(), sentence);
  file_ = "/dev/null";
  EXPECT_THAT(open_sentence(), sentence);
  EXPECT_THAT(read_sentence(), sentence);
}

TEST_F(DatabaseTest, ReadingNeverMakesAFile) {
  EXPECT_THROW(Database::open_read_only(file_), Error);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(DatabaseTest, NothingIsWrittenThroughAReader) {
  { Database::open(file_); }
  Database reader = Database::open_read_only(file_);
  EXPECT_THROW(reader.execute("DELETE FROM run"), Error);
}

TEST_F(DatabaseTest, AnOlderFileIsBroughtUpToDateAndKeptBesideIt) {
  const std::string first = "PRAGMA application_id = " + std::to_string(kApplicationId) + "; CREATE TABLE a (x)";
  { Database::open(file_, {{1, first}}).execute("INSERT INTO a VALUES (42)"); }
  const Database newer =
      Database::open(file_, {{1, first}, {2, "ALTER TABLE a ADD COLUMN y"}, {3, "CREATE TABLE b (z)"}});
  EXPECT_EQ(ask(newer, "PRAGMA user_version"), 3);
  EXPECT_EQ(ask(newer, "SELECT x FROM a WHERE y IS NULL"), 42);
  const Database kept = Database::open(file_.string() + ".before-version-3", {{1, first}});
  EXPECT_EQ(ask(kept, "SELECT x FROM a"), 42);
}

TEST_F(DatabaseTest, AnOlderFileIsReadAsIfItWereUpToDateAndStaysAsItIs) {
  const std::vector<Migration>& all = schema_migrations();
  { Database::open(file_, {all.front()}).execute("INSERT INTO schema_text (name, sha256) VALUES ('other', 'x')"); }
  const std::string before = read_bytes(file_);
  EXPECT_EQ(ask(Database::open_read_only(file_), "SELECT count(*) FROM eea_runs"), 0);
  EXPECT_EQ(read_bytes(file_), before);
}

TEST_F(DatabaseTest, AMigrationThatFailsLeavesTheOldVersion) {
  const std::string first = "PRAGMA application_id = " + std::to_string(kApplicationId) + "; CREATE TABLE a (x)";
  { Database::open(file_, {{1, first}}); }
  EXPECT_THROW(Database::open(file_, {{1, first}, {2, "CREATE TABLE b (z)"}, {3, "CREATE TABLE b (z)"}}), Error);
  const Database old = Database::open(file_, {{1, first}});
  EXPECT_EQ(ask(old, "PRAGMA user_version"), 1);
  EXPECT_EQ(ask(old, "SELECT count(*) FROM sqlite_master WHERE name = 'b'"), 0);
}

TEST_F(DatabaseTest, ViewsAreRenewedWhenTheirTextHasChanged) {
  Database database = Database::open(file_);
  refresh_views(database, "CREATE VIEW answer AS SELECT 42;");
  EXPECT_EQ(ask(database, "SELECT * FROM answer"), 42);
  EXPECT_EQ(ask(database, "SELECT count(*) FROM sqlite_master WHERE type = 'view'"), 1);
  database = Database::open(file_);
  EXPECT_EQ(ask(database, "SELECT count(*) FROM sqlite_master WHERE name = 'answer'"), 0);
}

TEST_F(DatabaseTest, ASecondWriterWaitsAndThenSaysSo) {
  Database first = Database::open(file_);
  Database second = Database::open(file_);
  second.wait_for_writers(std::chrono::milliseconds(20));
  Transaction writing(first);
  EXPECT_THAT(sentence_of([&] { Transaction refused(second); }), HasSubstr("is in use by another process"));
  const Database reader = Database::open_read_only(file_);
  EXPECT_EQ(ask(reader, "SELECT count(*) FROM run"), 0) << "readers are not kept waiting";
  writing.commit();
  Transaction allowed(second);
  allowed.commit();
}

TEST_F(DatabaseTest, WritersThatTakeTurnsLoseNothing) {
  constexpr int kRuns = 20;
  { Database::open(file_); }
  const auto write = [&] {
    Database database = Database::open(file_);
    for (int i = 0; i < kRuns; ++i) {
      ResultStore store(database);
      store.begin_run({.command = "writer", .seed = 1, .threads = 1}, {});
      store.end_run(RunEnding::done);
    }
  };
  std::thread other(write);
  write();
  other.join();
  EXPECT_EQ(ask(Database::open_read_only(file_), "SELECT count(DISTINCT identity) FROM run WHERE ending = 'done'"),
            2 * kRuns);
}

TEST_F(DatabaseTest, TwoMayMakeTheSameFileAtOnce) {
  constexpr std::size_t kFiles = 20;
  std::array<std::atomic<int>, kFiles> arrived{};
  const auto make_all = [&] {
    std::string complaints;
    for (std::size_t i = 0; i < kFiles; ++i) {
      ++arrived.at(i);
      while (arrived.at(i) < 2) std::this_thread::yield();
      const std::string sentence = sentence_of([&] { Database::open(folder_ / (std::to_string(i) + ".db")); });
      if (sentence != "no error") complaints += sentence + '\n';
    }
    return complaints;
  };
  std::string complaints_of_other;
  std::thread other([&] { complaints_of_other = make_all(); });
  EXPECT_EQ(make_all(), "");
  other.join();
  EXPECT_EQ(complaints_of_other, "");
}

TEST_F(DatabaseTest, ATransactionInsideAnotherIsPartOfIt) {
  Database database = Database::open(file_, {{1, "CREATE TABLE a (x)"}});
  {
    Transaction outer(database);
    Transaction inner(database);
    database.execute("INSERT INTO a VALUES (1)");
    inner.commit();
    EXPECT_TRUE(database.in_transaction());
  }
  EXPECT_EQ(ask(database, "SELECT count(*) FROM a"), 0);
}

TEST_F(DatabaseTest, NamesWithSpecialCharactersAreTakenAsTheyAre) {
  file_ = folder_ / "my rig? 50% #1 é.db";
  { Database::open(file_); }
  EXPECT_NO_THROW(Database::open_read_only(file_));
  EXPECT_TRUE(std::filesystem::exists(file_));
}

}  // namespace
}  // namespace lacuna

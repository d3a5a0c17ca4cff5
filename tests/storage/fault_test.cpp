#include "storage/asked.h"
#include "storage/child_process.h"
#include "storage/core/statement.h"
#include "storage/queries/query.h"
#include "storage/small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <thread>

namespace lacuna {
namespace {

using test::ask;
using test::ChildProcess;
using test::is_intact;
using test::sentence_of;
using testing::AllOf;
using testing::HasSubstr;

void add_experiment(ResultStore& store, int number) {
  store.record_experiment({"experiment " + std::to_string(number), "rig.toml", std::string(5000, 'x'), {}});
}

class StorageFault : public testing::Test {
 protected:
  void begin_run(ResultStore& store) { store.begin_run({.command = "test", .seed = 1, .threads = 1}, {}); }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db";
};

TEST_F(StorageFault, AProcessKilledInATransactionLeavesNothingOfIt) {
  { Database::open(file_); }
  ChildProcess child([&](int to_parent) {
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
    const Transaction transaction(database);
    database.execute("PRAGMA cache_size = 10");  // so that pages reach the file before the commit
    for (int i = 0; i < 500; ++i) add_experiment(store, i);
    ChildProcess::say(to_parent, "w");
    pause();
  });
  ASSERT_EQ(child.next(), 'w');
  EXPECT_GT(std::filesystem::file_size(file_.string() + "-wal"), 500U * 5000U) << "the test would show nothing";
  child.kill();
  const Database database = Database::open(file_);
  EXPECT_TRUE(is_intact(database));
  EXPECT_EQ(ask(database, "SELECT count(*) FROM run"), 1);
  EXPECT_EQ(ask(database, "SELECT count(*) FROM experiment"), 0);
}

TEST_F(StorageFault, WhatWasCommittedSurvivesAKillAtAnyMoment) {
  constexpr int kKills = 15;
  { Database::open(file_); }
  std::int64_t acknowledged = 0;
  for (int attempt = 0; attempt < kKills; ++attempt) {
    ChildProcess child([&](int to_parent) {
      Database database = Database::open(file_);
      ResultStore store(database);
      begin_run(store);
      for (int i = 0;; ++i) {
        add_experiment(store, 1000 * attempt + i);
        ChildProcess::say(to_parent, "c");
      }
    });
    for (int commits = 0; commits <= attempt % 4; ++commits) {
      ASSERT_EQ(child.next(), 'c');
      ++acknowledged;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(700 * attempt));
    child.kill();
    const Database database = Database::open(file_);
    ASSERT_TRUE(is_intact(database));
    const std::int64_t found = ask(database, "SELECT count(*) FROM experiment");
    ASSERT_GE(found, acknowledged);
    acknowledged = found;
  }
}

/// How many experiments a file holds by itself, without a log beside it.
std::int64_t experiments_in(const std::filesystem::path& file) {
  const Database database = Database::open_read_only(file);
  EXPECT_TRUE(is_intact(database));
  return ask(database, "SELECT count(*) FROM experiment");
}

TEST_F(StorageFault, OfADeletedFileWhatWasCommittedIsKeptInACopy) {
  {
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
    add_experiment(store, 1);
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(file_.string() + suffix);
    EXPECT_THAT(sentence_of([&] { add_experiment(store, 2); }),
                AllOf(HasSubstr("rig.db: was deleted while it was open"), HasSubstr("rig.db.rescued")));
    EXPECT_THAT(sentence_of([&] { add_experiment(store, 3); }), HasSubstr("rig.db.rescued;")) << "one copy is enough";
  }
  EXPECT_EQ(experiments_in(file_.string() + ".rescued"), 1);
  EXPECT_FALSE(std::filesystem::exists(file_.string() + ".rescued-2"));
  EXPECT_FALSE(std::filesystem::exists(file_)) << "nothing is put where the user deleted";
}

TEST_F(StorageFault, AMovedFileIsCompleteWithoutTheLogThatWasLeftBehind) {
  const std::filesystem::path moved = folder_ / "elsewhere.db";
  {
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
    add_experiment(store, 1);
    std::filesystem::rename(file_, moved);
    EXPECT_THAT(sentence_of([&] { add_experiment(store, 2); }), HasSubstr("rig.db: was moved to " + moved.string()));
  }
  EXPECT_EQ(experiments_in(moved), 1);
}

TEST_F(StorageFault, AFileInARenamedFolderIsComplete) {
  std::filesystem::create_directory(folder_ / "results");
  Database database = Database::open(folder_ / "results" / "rig.db");
  ResultStore store(database);
  begin_run(store);
  add_experiment(store, 1);
  std::filesystem::rename(folder_ / "results", folder_ / "old results");
  EXPECT_THAT(sentence_of([&] { add_experiment(store, 2); }), HasSubstr("old results/rig.db while it was open"));
  EXPECT_FALSE(database.in_transaction());
  EXPECT_EQ(experiments_in(folder_ / "old results" / "rig.db"), 1);
}

TEST_F(StorageFault, AReplacedFileIsNoticedAtTheNextCommit) {
  Database database = Database::open(file_);
  ResultStore store(database);
  begin_run(store);
  std::filesystem::rename(file_, folder_ / "aside.db");
  { Database::open(file_); }
  EXPECT_THAT(sentence_of([&] { add_experiment(store, 1); }), HasSubstr("rig.db: was replaced by another file"));
}

TEST_F(StorageFault, AFileSizeLimitGivesASentenceAndLeavesTheFileIntact) {
  { Database::open(file_); }
  ChildProcess child([&](int) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{400'000, 400'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
    for (int i = 0; i < 500; ++i) add_experiment(store, i);
  });
  EXPECT_THAT(child.all(), HasSubstr("files may not grow this large (ulimit -f)"));
  const Database database = Database::open(file_);
  EXPECT_TRUE(is_intact(database));
  EXPECT_GT(ask(database, "SELECT count(*) FROM experiment"), 0);
}

TEST_F(StorageFault, AFullDiskGivesASentenceAndLeavesTheFileIntact) {
  ChildProcess child([&](int to_parent) {
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, "size=900k") != 0) {
      return ChildProcess::say(to_parent, std::string("no mount: ") + std::strerror(errno));
    }
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
    try {
      for (int i = 0; i < 500; ++i) add_experiment(store, i);
    } catch (const Error& error) {
      ChildProcess::say(to_parent, error.what());
    }
    if (is_intact(database)) ChildProcess::say(to_parent, " / intact");
    if (ask(database, "SELECT count(*) FROM experiment") > 0) ChildProcess::say(to_parent, " / with what was kept");
  });
  const std::string said = child.all();
  if (said.starts_with("no mount"))
    GTEST_SKIP() << "a file system of 900 kB of its own cannot be mounted here (" << said
                 << "); it takes root, and a root folder that is a mount point (not a chroot)";
  EXPECT_THAT(said, HasSubstr("the disk or the quota is full"));
  EXPECT_THAT(said, HasSubstr("intact / with what was kept"));
}

TEST_F(StorageFault, ADamagedPageIsNoticed) {
  {
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
    for (int i = 0; i < 50; ++i) add_experiment(store, i);
  }
  {
    std::fstream bytes(file_, std::ios::in | std::ios::out | std::ios::binary);
    for (std::streamoff page = 1; page < 12; ++page) {
      bytes.seekp(page * 4096);
      bytes << std::string(64, '\xff');
    }
  }
  try {
    const Database database = Database::open_read_only(file_);
    Statement every(database, "SELECT * FROM experiment_text JOIN experiment ON experiment.id = experiment");
    while (every.step()) {
    }
    FAIL() << "nothing was noticed";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("rig.db: is damaged"));
  }
}

/// What `answer` says as somebody who may not write into the folder.
std::string ask_as_guest(const std::filesystem::path& folder, const std::function<std::string()>& answer) {
  chmod(folder.c_str(), 0555);
  ChildProcess child([&](int to_parent) {
    if (geteuid() == 0 && setuid(65534) != 0) return ChildProcess::say(to_parent, "no guest");
    ChildProcess::say(to_parent, answer());
  });
  std::string said = child.all();
  chmod(folder.c_str(), 0755);
  return said;
}

std::string runs_in(const Database& database) {
  return "runs: " + std::to_string(ask(database, "SELECT count(*) FROM runs"));
}

std::string read_as_guest(const std::filesystem::path& folder, const std::filesystem::path& file) {
  return ask_as_guest(folder, [&] { return runs_in(Database::open_read_only(file)); });
}

TEST_F(StorageFault, AClosedDatabaseIsReadableInAReadOnlyFolder) {
  {
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
  }
  EXPECT_EQ(read_as_guest(folder_.path(), file_), "runs: 1");
}

TEST_F(StorageFault, ACopyOfADatabaseInAReadOnlyFolderTakesWhatIsNotKept) {
  {
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
  }
  const auto begin_another = [&] {
    EXPECT_FALSE(is_writable(file_));
    Database copy = Database::open_copy(file_);
    ResultStore store(copy);
    begin_run(store);
    return runs_in(copy);
  };
  EXPECT_EQ(ask_as_guest(folder_.path(), begin_another), "runs: 2");
  EXPECT_EQ(runs_in(Database::open_read_only(file_)), "runs: 1");
}

TEST_F(StorageFault, AReadOnlyFolderIsNamed) {
  const auto open = [&] { return sentence_of([&] { Database::open(file_); }); };
  const char* sentence =
      "rig.db: cannot be written: its folder is read-only; name a database elsewhere (--db FILE, where the command has "
      "it)";
  EXPECT_THAT(ask_as_guest(folder_.path(), open), HasSubstr(sentence));
  chmod(folder_.path().c_str(), 0777);
  { Database::open(file_); }
  chmod(file_.c_str(), 0666);
  EXPECT_THAT(ask_as_guest(folder_.path(), open), HasSubstr(sentence));
}

TEST_F(StorageFault, ADatabaseWithALogInAReadOnlyFolderGetsASentence) {
  ChildProcess writer([&](int to_parent) {
    Database database = Database::open(file_);
    ResultStore store(database);
    begin_run(store);
    ChildProcess::say(to_parent, "w");
    pause();
  });
  ASSERT_EQ(writer.next(), 'w');
  writer.kill();
  std::filesystem::remove(file_.string() + "-shm");
  EXPECT_THAT(read_as_guest(folder_.path(), file_), HasSubstr("has changes in its -wal file"));
}

}  // namespace
}  // namespace lacuna

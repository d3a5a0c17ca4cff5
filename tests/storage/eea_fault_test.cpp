#include "storage/asked.h"
#include "storage/child_process.h"
#include "storage/core/statement.h"
#include "storage/made_up_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <chrono>
#include <random>
#include <thread>

namespace lacuna {
namespace {

using test::ChildProcess;
using test::is_intact;
using test::MadeUpDatabase;
using test::MadeUpRun;
using test::sentence_of;
using testing::HasSubstr;

constexpr MadeUpRun kLong{.passes = 100};

/// Goes on with run 1 of a file.
class Continued {
 public:
  explicit Continued(const std::filesystem::path& file) : database(Database::open(file)) { results.continue_run(run); }
  int commits() const {
    const std::optional<CheckpointRow> checkpoint = store.checkpoint();
    return checkpoint ? static_cast<int>(checkpoint->state.at(0)) : 0;
  }
  std::string hash() const { return content_hash(database, run); }

  Database database;
  std::mutex writing;
  RunId run{1};
  ResultStore results{database};
  ExperimentId experiment = *results.find_experiment("quadruped");
  EeaStore store{database, writing, run, experiment};
};

class EeaFault : public testing::Test {
 protected:
  /// The content after that many commits of a run that nothing disturbed; to be asked in ascending order.
  std::string undisturbed(int commits) {
    reference_.advance(kLong, commits);
    return content_hash(reference_.database, reference_.run);
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "run.db";
  MadeUpDatabase reference_{folder_ / "reference.db"};
};

TEST_F(EeaFault, AfterAKillAtAnyMomentTheContentIsWhatLedToTheCheckpoint) {
  constexpr int kKills = 20;
  constexpr int kLongestMicroseconds = 20'000;  // a commit takes two or three thousand
  {
    MadeUpDatabase begun(file_);
    begun.store->begin(kLong.record());
  }
  std::mt19937 random(3);
  int before = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    ChildProcess child([&](int to_parent) {
      Continued run(file_);
      for (int i = run.commits(); i < kLong.commits(); ++i) {
        kLong.commit(run.store, i);
        ChildProcess::say(to_parent, "c");
      }
      pause();
    });
    ASSERT_EQ(child.next(), 'c');
    std::this_thread::sleep_for(std::chrono::microseconds(random() % kLongestMicroseconds));
    child.kill();
    const Continued run(file_);
    ASSERT_TRUE(is_intact(run.database));
    ASSERT_GT(run.commits(), before) << "what was reported as committed is kept";
    before = run.commits();
    ASSERT_EQ(run.hash(), undisturbed(before)) << "after " << before << " commits";
  }
  EXPECT_LT(before, kLong.commits()) << "the last kills found nothing to disturb";
}

TEST_F(EeaFault, AFullDiskGivesASentenceAndLeavesTheLastCheckpointToGoOnFrom) {
  ChildProcess child([&](int to_parent) {
    const std::filesystem::path disk = folder_ / "disk";
    std::filesystem::create_directory(disk);
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=800k") != 0) {
      return ChildProcess::say(to_parent, "no mount");
    }
    MadeUpDatabase full(disk / "run.db");
    ChildProcess::say(to_parent, sentence_of([&] { full.advance(kLong, kLong.commits()); }));
    const int commits = static_cast<int>(full.store->checkpoint()->state.at(0));
    const bool same = content_hash(full.database, full.run) == undisturbed(commits);
    ChildProcess::say(to_parent, same && commits > 0 && is_intact(full.database) ? " / intact" : " / damaged");
    // Room is made while the program still runs: the same commit goes through.
    mount("tmpfs", disk.c_str(), "tmpfs", MS_REMOUNT, "size=20m");
    full.store->commit({{static_cast<double>(commits + 1)}});
    for (int i = commits + 1; i < commits + 5; ++i) kLong.commit(*full.store, i);
    const bool went_on = content_hash(full.database, full.run) == undisturbed(commits + 5);
    ChildProcess::say(to_parent, went_on ? " / went on" : " / differs");
  });
  const std::string said = child.all();
  if (said == "no mount") GTEST_SKIP() << "a file system of 800 kB can be mounted by root alone";
  EXPECT_THAT(said, HasSubstr("run.db: cannot grow: the disk or the quota is full"));
  EXPECT_THAT(said, HasSubstr("/ intact / went on"));
}

TEST_F(EeaFault, AMovedFileHasAllThatWasCommitted) {
  const std::filesystem::path moved = folder_ / "moved.db";
  {
    MadeUpDatabase run(file_);
    run.advance(kLong, 6);
    std::filesystem::rename(file_, moved);
    EXPECT_THAT(sentence_of([&] { kLong.commit(*run.store, 6); }), HasSubstr("was moved to " + moved.string()));
  }
  Continued run(moved);
  EXPECT_EQ(run.hash(), undisturbed(6));
  for (int i = run.commits(); i < 8; ++i) kLong.commit(run.store, i);
  EXPECT_EQ(run.hash(), undisturbed(8));
}

TEST_F(EeaFault, OfADeletedFileACopyHasAllThatWasCommitted) {
  {
    MadeUpDatabase run(file_);
    run.advance(kLong, 6);
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(file_.string() + suffix);
    EXPECT_THAT(sentence_of([&] { kLong.commit(*run.store, 6); }), HasSubstr("run.db.rescued"));
  }
  const Continued run(file_.string() + ".rescued");
  EXPECT_TRUE(is_intact(run.database));
  EXPECT_EQ(run.hash(), undisturbed(6));
}

TEST_F(EeaFault, AFileMadeReadOnlyTakesWhatARunningProgramCommitsAndRefusesTheNext) {
  chmod(folder_.path().c_str(), 0777);
  ChildProcess child([&](int to_parent) {
    if (geteuid() == 0 && setuid(65534) != 0) return ChildProcess::say(to_parent, "no guest");
    MadeUpDatabase run(file_);
    run.advance(kLong, 3);
    chmod(file_.c_str(), 0444);
    for (int i = 3; i < 6; ++i) kLong.commit(*run.store, i);
    ChildProcess::say(to_parent, sentence_of([&] { Database::open(file_); }));
  });
  EXPECT_THAT(child.all(), HasSubstr("run.db: is read-only; check the permissions"));
  chmod(file_.c_str(), 0644);
  EXPECT_EQ(Continued(file_).hash(), undisturbed(6));
}

TEST_F(EeaFault, ASecondWriterWaitsOrGivesUpWithASentenceAndCanTryAgain) {
  MadeUpDatabase run(file_);
  run.advance(kLong, 3);
  run.database.wait_for_writers(std::chrono::milliseconds(20));
  kLong.append(*run.store, 3);
  {
    Database other = Database::open(file_);
    const Transaction writing(other);
    EXPECT_THAT(sentence_of([&] { run.store->commit({{4.0}}); }), HasSubstr("is in use by another process"));
  }
  run.store->commit({{4.0}});
  EXPECT_EQ(content_hash(run.database, run.run), undisturbed(4));
}

TEST_F(EeaFault, TwoProgramsThatWriteRunsToOneFileTakeTurns) {
  constexpr int kCommits = 40;
  { Database::open(file_); }
  ChildProcess child([&](int to_parent) {
    MadeUpDatabase run(file_);
    ChildProcess::say(to_parent, "b");
    run.advance(kLong, kCommits);
    ChildProcess::say(to_parent, content_hash(run.database, run.run));
  });
  ASSERT_EQ(child.next(), 'b');
  MadeUpDatabase run(file_);
  run.advance(kLong, kCommits);
  const std::string expected = undisturbed(kCommits);
  EXPECT_EQ(content_hash(run.database, run.run), expected);
  EXPECT_EQ(child.all(), expected);
}

}  // namespace
}  // namespace lacuna

#include "storage/core/run_claim.h"

#include "storage/asked.h"
#include "storage/child_process.h"
#include "storage/core/statement.h"
#include "storage/made_up_run.h"

#include <gmock/gmock.h>

#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>

namespace lacuna {
namespace {

using test::ask;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class RunClaimTest : public testing::Test {
 protected:
  /// Another machine takes the run, or shows that it still has it.
  void foreign(int beat) {
    Statement(filled_.database, "INSERT OR REPLACE INTO claim VALUES (?, 'elsewhere', 'elsewhere 17', ?, ?)")
        .run_with(filled_.run, database_inode(), beat);
  }
  std::int64_t database_inode() const {
    struct stat file {};
    stat(file_.c_str(), &file);
    return static_cast<std::int64_t>(file.st_ino);
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "rig.db";
  test::MadeUpDatabase filled_{file_};
};

TEST_F(RunClaimTest, IsHeldByOneProcessAtATimeAndLeavesNothing) {
  {
    const RunClaim first(filled_.database, filled_.run);
    EXPECT_TRUE(first.held());
    const RunClaim second(filled_.database, filled_.run);
    EXPECT_FALSE(second.held());
    EXPECT_EQ(ask(filled_.database, "SELECT count(*) FROM claim"), 1);
    EXPECT_THAT(foreign_claims(filled_.database), IsEmpty()) << "it is this machine's";
  }
  EXPECT_EQ(ask(filled_.database, "SELECT count(*) FROM claim"), 0);
  EXPECT_TRUE(RunClaim(filled_.database, filled_.run).held());
}

TEST_F(RunClaimTest, OfAProcessThatWasKilledIsFreeAtOnce) {
  test::ChildProcess child([&](int) {
    Database database = Database::open(file_);
    static const RunClaim claim(database, filled_.run);
    raise(SIGKILL);
  });
  child.all();
  EXPECT_EQ(ask(filled_.database, "SELECT count(*) FROM claim"), 1) << "nobody took it away";
  EXPECT_TRUE(RunClaim(filled_.database, filled_.run).held());
}

/// A process has as many as it has replicates, and one socket.
TEST_F(RunClaimTest, ThousandsNeedNoMoreOpenFilesThanOne) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit few{std::min<rlim_t>(before.rlim_cur, 100), before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  {
    std::vector<RunClaim> claims;
    ResultStore store(filled_.database);
    for (int i = 0; i < 300; ++i) claims.emplace_back(filled_.database, store.begin_run({.command = "run"}, {}));
    store.hand_over();
    EXPECT_TRUE(std::all_of(claims.begin(), claims.end(), [](const RunClaim& claim) { return claim.held(); }));
    RunClaim::release(claims);
    EXPECT_EQ(ask(filled_.database, "SELECT count(*) FROM claim"), 0);
    EXPECT_FALSE(claims.front().held());
  }
  setrlimit(RLIMIT_NOFILE, &before);
}

TEST_F(RunClaimTest, OfAnotherMachineCountsUntilItFallsSilent) {
  foreign(4);
  EXPECT_FALSE(RunClaim(filled_.database, filled_.run).held());
  const std::vector<ForeignClaim> seen = foreign_claims(filled_.database);
  ASSERT_THAT(seen, SizeIs(1));
  EXPECT_EQ(seen[0].beat, 4);
  foreign(5);
  EXPECT_FALSE(RunClaim(filled_.database, filled_.run, seen).held()) << "it has beaten since";
  EXPECT_TRUE(RunClaim(filled_.database, filled_.run, foreign_claims(filled_.database)).held());
}

TEST_F(RunClaimTest, MeansNothingInACopy) {
  Statement(filled_.database, "INSERT INTO claim VALUES (?, 'elsewhere', 'elsewhere 17', ?, 4)")
      .run_with(filled_.run, database_inode() + 1);
  EXPECT_THAT(foreign_claims(filled_.database), IsEmpty());
  EXPECT_TRUE(RunClaim(filled_.database, filled_.run).held());
}

TEST_F(RunClaimTest, WhoLosesItWritesNothingMore) {
  const test::MadeUpRun made_up;
  const RunClaim claim(filled_.database, filled_.run);
  ASSERT_TRUE(claim.held());
  filled_.advance(made_up, 1);
  beat_claims(filled_.database);
  EXPECT_EQ(ask(filled_.database, "SELECT beat FROM claim"), 1);
  foreign(0);
  try {
    filled_.advance(made_up, 2);
    ADD_FAILURE() << "it was written";
  } catch (const Error& refused) {
    EXPECT_THAT(refused.what(), HasSubstr("is also continued by another process"));
  }
}

}  // namespace
}  // namespace lacuna

#include "faults/failing_memory.h"
#include "foundation/processes/end_without_memory.h"
#include "storage/child_process.h"
#include "storage/integrity/backup.h"
#include "storage/made_up_run.h"
#include "storage/merge/merge.h"
#include "storage/queries/verification.h"
#include "support/sanitizers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <string>

namespace lacuna {
namespace {

namespace fs = std::filesystem;
using test::ChildProcess;
using test::fill_small_database;
using test::MadeUpDatabase;
using test::MadeUpRun;

constexpr std::uint64_t kMost = 40;  ///< allocations that fail in each test by default; all with LACUNA_ALL_FAULTS
constexpr MadeUpRun kRun{.passes = 1, .generations = 2, .models = 4, .tests = 3, .samples = 8};
constexpr int kBefore = 1;  ///< commits of it that are there before

/// As the program does it.
int said_to = -1;
void say_so() {
  end_failing_allocations();
  ChildProcess::say(said_to, "memory is used up");
  _exit(1);
}

using Work = std::function<void(const fs::path& folder)>;

/// Goes on with run 1 to its end.
void go_on(const fs::path& file) {
  Database database = Database::open(file);
  if (is_done(database, RunId{1})) return;
  std::mutex writing;
  ResultStore results(database);
  results.continue_run(RunId{1});
  EeaStore store(database, writing, RunId{1}, *results.find_experiment("quadruped"));
  store.begin(kRun.record());
  const std::optional<CheckpointRow> checkpoint = store.checkpoint();
  for (int i = checkpoint ? static_cast<int>(checkpoint->state.at(0)) : 0; i < kRun.commits(); ++i)
    kRun.commit(store, i);
  store.end(RunEnding::done);
}

std::string hash_in(const fs::path& file) { return content_hash(Database::open_read_only(file), RunId{1}); }

class StorageMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (LACUNA_WATCHED) GTEST_SKIP() << "the sanitizer has its own allocator";
  }

  /// A run under way in prepared/run.db.
  void prepare_run() const {
    MadeUpDatabase begun(prepared() / "run.db");
    begun.advance(kRun, kBefore);
    begun.store->hand_over();
    begun.results.hand_over();
  }
  fs::path prepared() const {
    fs::create_directories(folder_ / "prepared");
    return folder_ / "prepared";
  }
  fs::path working() const { return folder_ / "working"; }
  void put_back() const {
    fs::remove_all(working());
    fs::copy(prepared(), working(), fs::copy_options::recursive);
  }

  /// "done", a sentence, or nothing where it crashed; `count` gets the allocations.
  std::string ending_of(const Work& work, std::uint64_t at, bool lasting, std::uint64_t* count = nullptr) const {
    put_back();
    ChildProcess child([&](int to_parent) {
      said_to = to_parent;
      set_end_without_memory(&say_so);
      std::uint64_t counted = 0;
      try {
        begin_failing_allocations(at, lasting);
        work(working());
        counted = end_failing_allocations();
      } catch (...) {
        end_failing_allocations();
        throw;
      }
      ChildProcess::say(to_parent, count != nullptr ? std::to_string(counted) : "done");
    });
    const std::string said = child.all();
    if (count != nullptr) *count = std::strtoull(said.c_str(), nullptr, 10);
    return said;
  }

  void expect_sound(const fs::path& file) const {
    std::error_code missing;
    if (fs::file_size(file, missing) == 0 || missing) return;
    const Verification found = verify(Database::open_read_only(file));
    EXPECT_TRUE(found.is_sound()) << (found.damage.empty() ? "" : found.damage.front());
  }

  /// Lets allocations fail in the work, one after the other; `after` looks at what it has left.
  void let_fail(const Work& work, const std::function<void()>& after) {
    work_once(work);
    std::uint64_t count = 0;
    ending_of(work, 0, false, &count);
    ASSERT_GT(count, 100U) << "the test would show nothing";
    RecordProperty("allocations", static_cast<int>(count));
    const std::uint64_t tried = std::getenv("LACUNA_ALL_FAULTS") != nullptr ? count : std::min(count, kMost);
    for (std::uint64_t i = 0; i < tried && !HasFatalFailure(); ++i)
      for (const bool lasting : {false, true}) {
        const std::uint64_t at = 1 + i * count / tried;
        SCOPED_TRACE("allocation " + std::to_string(at) + (lasting ? " and all after it" : ""));
        EXPECT_NE(ending_of(work, at, lasting), "") << "it crashed";
        after();
      }
  }

 private:
  /// What is made once in a process is no part of the work.
  void work_once(const Work& work) const {
    put_back();
    work(working());
  }

  TestFolder folder_;
};

TEST_F(StorageMemory, ThatFailsInARunLosesNothingThatWasCommitted) {
  prepare_run();
  put_back();
  go_on(working() / "run.db");
  const std::string whole = hash_in(working() / "run.db");
  let_fail([](const fs::path& folder) { go_on(folder / "run.db"); },
           [&] {
             expect_sound(working() / "run.db");
             go_on(working() / "run.db");
             EXPECT_EQ(hash_in(working() / "run.db"), whole);
           });
}

TEST_F(StorageMemory, ThatFailsWhileRevisionsAreStoredLeavesASoundDatabase) {
  prepared();
  const Work store = [](const fs::path& folder) {
    Database database = Database::open(folder / "rig.db");
    ResultStore results(database);
    fill_small_database(results);
    results.end_run(RunEnding::done);
  };
  let_fail(store, [&] {
    expect_sound(working() / "rig.db");
    store(working());
    expect_sound(working() / "rig.db");
  });
}

TEST_F(StorageMemory, ThatFailsInABackupLeavesAWholeCopyOrNone) {
  prepare_run();
  go_on(prepared() / "run.db");
  const std::string whole = hash_in(prepared() / "run.db");
  let_fail([](const fs::path& folder) { back_up(folder / "run.db", folder / "copy.db"); },
           [&] {
             if (fs::exists(working() / "copy.db")) {
               EXPECT_EQ(hash_in(working() / "copy.db"), whole);
             }
             EXPECT_EQ(hash_in(working() / "run.db"), whole);
             back_up(working() / "run.db", working() / "next.db");
             for (const fs::directory_entry& entry : fs::directory_iterator(working()))
               EXPECT_NE(entry.path().filename().string().front(), '.');
           });
}

TEST_F(StorageMemory, ThatFailsInAMergeTakesARunInWholeOrNotAtAll) {
  prepare_run();
  go_on(prepared() / "run.db");
  const std::string whole = hash_in(prepared() / "run.db");
  const Work take_in = [](const fs::path& folder) {
    Database database = Database::open(folder / "all.db");
    merge(database, {{folder / "run.db", Unusable::refuses_all}}, {});
  };
  let_fail(take_in, [&] {
    expect_sound(working() / "all.db");
    expect_sound(working() / "run.db");
    take_in(working());
    EXPECT_EQ(hash_in(working() / "all.db"), whole);
  });
}

}  // namespace
}  // namespace lacuna

#include "app/tasks/task_checkpoints.h"

#include "storage/asked.h"
#include "storage/small_database.h"
#include "tasks/made_up_plan.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace lacuna {
namespace {

/// While the task's database is written, whose log has the newest rows.
TEST(TaskCheckpointsTest, AreKeptNowAndThen) {
  const TestFolder scratch;
  const TaskFolder folder = TaskFolder::make(scratch / "plan", test::made_up_plan(scratch.path()));
  const TaskCheckpoints checkpoints(folder, 2, scratch / "shard.db", std::chrono::milliseconds(5));
  Database database = Database::open(scratch / "shard.db");
  std::int64_t kept = 0, written = 0;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (kept < 20 && std::chrono::steady_clock::now() < deadline) {
    test::add_experiments(database, static_cast<int>(written++), 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (folder.take_checkpoint(2, scratch / "taken.db"))
      kept = test::ask(Database::open_read_only(scratch / "taken.db"), "SELECT count(*) FROM experiment");
  }
  EXPECT_GE(kept, 20);
  while (kept < written && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    folder.take_checkpoint(2, scratch / "taken.db");
    kept = test::ask(Database::open_read_only(scratch / "taken.db"), "SELECT count(*) FROM experiment");
  }
  EXPECT_EQ(kept, written);
}

}  // namespace
}  // namespace lacuna

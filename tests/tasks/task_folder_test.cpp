#include "tasks/task_folder.h"

#include "foundation/text/problem.h"
#include "storage/asked.h"
#include "storage/small_database.h"
#include "tasks/made_up_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>

namespace lacuna {
namespace {

using test::made_up_plan;
using test::write_text;
using testing::ElementsAre;

/// How many experiments a database has, which is how far these tests have got.
std::int64_t progress_in(const std::filesystem::path& database) {
  return test::ask(Database::open_read_only(database), "SELECT count(*) FROM experiment");
}

class TaskFolderTest : public testing::Test {
 protected:
  /// A task's database on the local disk.
  std::filesystem::path local(int progress) const {
    std::filesystem::remove(scratch_ / "shard.db");
    Database database = Database::open(scratch_ / "shard.db");
    test::add_experiments(database, 0, progress);
    return scratch_ / "shard.db";
  }
  TaskStatus status(std::size_t number) const { return folder_.status(number, folder_.now()); }
  std::int64_t progress_of_checkpoint(std::size_t number) const {
    return folder_.take_checkpoint(number, scratch_ / "taken.db") ? progress_in(scratch_ / "taken.db") : 0;
  }

  TestFolder scratch_;
  TaskPlan plan_ = made_up_plan(scratch_.path());
  TaskFolder folder_ = TaskFolder::make(scratch_ / "plan", plan_);
};

TEST_F(TaskFolderTest, IsMadeOnceForOnePlan) {
  EXPECT_EQ(TaskFolder(scratch_ / "plan").plan().tasks, plan_.tasks);
  EXPECT_EQ(TaskFolder::make(scratch_ / "plan", plan_).plan().tasks, plan_.tasks);
  TaskPlan other = plan_;
  other.tasks.pop_back();
  EXPECT_THROW(TaskFolder::make(scratch_ / "plan", other), BadInput);
  EXPECT_THROW(TaskFolder::make(scratch_.path(), plan_), BadInput) << "has other files";
  EXPECT_THROW(TaskFolder(scratch_ / "nowhere"), BadInput);
  EXPECT_THROW(folder_.task(4), BadInput);
}

/// Where the files are is none of what the results follow from.
TEST_F(TaskFolderTest, TakesUpThatTheFilesOfItsPlanHaveMoved) {
  TaskPlan moved = plan_;
  std::filesystem::create_directory(scratch_ / "elsewhere");
  std::filesystem::rename(scratch_ / "rig.toml", scratch_ / "elsewhere" / "rig.toml");
  moved.inputs[0].file = scratch_ / "elsewhere" / "rig.toml";
  for (Task& task : moved.tasks) task.experiment = moved.inputs[0].file;
  EXPECT_EQ(TaskFolder::make(scratch_ / "plan", moved).plan().tasks, moved.tasks);
  EXPECT_EQ(TaskFolder(scratch_ / "plan").plan().inputs, moved.inputs);
}

/// Killed before the plan was written.
TEST_F(TaskFolderTest, IsMadeWhereItWasHalfMade) {
  std::filesystem::create_directories(scratch_ / "half" / "shards");
  EXPECT_EQ(TaskFolder::make(scratch_ / "half", plan_).plan().tasks, plan_.tasks);
  std::filesystem::create_directories(scratch_ / "mine" / "shards");
  write_text(scratch_ / "mine" / "shards" / "0.db", "not the plan's");
  EXPECT_THROW(TaskFolder::make(scratch_ / "mine", plan_), BadInput);
}

TEST_F(TaskFolderTest, TellsHowFarEachTaskIs) {
  EXPECT_EQ(status(0).state, TaskState::open);
  {
    const TaskSign sign(folder_, 0);
    EXPECT_EQ(status(0).state, TaskState::running);
    EXPECT_FALSE(status(0).machine.empty());
  }
  std::filesystem::last_write_time(scratch_ / "plan" / "signs" / "0.json",
                                   std::filesystem::file_time_type::clock::now() - std::chrono::minutes(5));
  EXPECT_EQ(status(0).state, TaskState::silent);
  folder_.note_failure(0, "the rig does not answer");
  EXPECT_EQ(status(0).state, TaskState::failed);
  EXPECT_EQ(status(0).reason, "the rig does not answer");
  folder_.keep_checkpoint(1, local(1));
  folder_.note_interruption(1, "interrupted");
  EXPECT_EQ(status(1).state, TaskState::interrupted);
  folder_.keep_shard(2, local(2));
  EXPECT_EQ(status(2).state, TaskState::done);
  EXPECT_THAT(folder_.open_tasks(), ElementsAre(0U, 1U, 3U));
}

TEST_F(TaskFolderTest, ACheckpointIsThereUntilTheShardIs) {
  EXPECT_EQ(progress_of_checkpoint(3), 0);
  folder_.keep_checkpoint(3, local(1));
  EXPECT_EQ(progress_of_checkpoint(3), 1);
  folder_.keep_checkpoint(3, local(100));
  EXPECT_EQ(progress_of_checkpoint(3), 100);
  folder_.keep_checkpoint(3, local(2));
  EXPECT_EQ(progress_of_checkpoint(3), 100) << "another process has got further";
  folder_.keep_shard(3, local(110));
  EXPECT_EQ(progress_in(folder_.shard(3)), 110);
  folder_.keep_checkpoint(3, local(109));
  EXPECT_EQ(progress_of_checkpoint(3), 0) << "nobody needs it";
}

/// SQLite keeps what is not in the file yet in the log beside it, as where the disk was full.
TEST_F(TaskFolderTest, ACheckpointHasWhatIsInTheLog) {
  Database database = Database::open(scratch_ / "shard.db");
  test::add_experiments(database, 0, 3);
  folder_.keep_checkpoint(0, scratch_ / "shard.db");
  EXPECT_EQ(progress_of_checkpoint(0), 3);
  test::add_experiments(database, 3, 2);
  folder_.keep_checkpoint(0, scratch_ / "shard.db");
  EXPECT_EQ(progress_of_checkpoint(0), 5) << "the file itself has not grown, and is smaller than the checkpoint";
}

TEST_F(TaskFolderTest, WhatIsDamagedBecomesNeitherCheckpointNorShard) {
  folder_.keep_checkpoint(0, local(1));
  const std::filesystem::path damaged = local(100);
  std::filesystem::resize_file(damaged, std::filesystem::file_size(damaged) - 8192);
  EXPECT_THROW(folder_.keep_checkpoint(0, damaged), Error);
  EXPECT_THROW(folder_.keep_shard(0, damaged), Error);
  EXPECT_EQ(progress_of_checkpoint(0), 1);
  EXPECT_FALSE(folder_.is_done(0));
}

/// What two processes found at once is the same; a merge may be reading the first.
TEST_F(TaskFolderTest, TheFirstShardStays) {
  folder_.keep_shard(0, local(1));
  folder_.keep_shard(0, local(2));
  EXPECT_EQ(progress_in(folder_.shard(0)), 1);
  EXPECT_EQ(status(0).state, TaskState::done);
}

}  // namespace
}  // namespace lacuna

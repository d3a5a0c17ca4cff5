#include "tasks/task_database.h"

#include "storage/small_database.h"
#include "tasks/made_up_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace lacuna {
namespace {

using testing::Optional;

class TaskDatabaseTest : public testing::Test {
 protected:
  void begin_run(const std::string& task) {
    Database database = Database::open(file_);
    ResultStore store(database);
    store.begin_run({.command = "lacuna task run", .task = task}, {});
    store.end_run(ending_);
  }
  std::optional<std::string> fault(TaskDatabase expected) const {
    Task task;
    task.id = "task 1";
    const auto fault = why_not_of_task(file_, task, expected);
    return fault ? std::optional(fault->reason) : std::nullopt;
  }

  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "shard.db";
  RunEnding ending_ = RunEnding::done;
};

TEST_F(TaskDatabaseTest, IsTheShardOfTheTaskThatHasEnded) {
  begin_run("task 1");
  EXPECT_EQ(fault(TaskDatabase::shard), std::nullopt);
  EXPECT_EQ(fault(TaskDatabase::checkpoint), std::nullopt);
}

TEST_F(TaskDatabaseTest, IsACheckpointUntilThen) {
  ending_ = RunEnding::interrupted;
  begin_run("task 1");
  EXPECT_THAT(fault(TaskDatabase::shard), Optional(std::string("contains an unfinished task")));
  EXPECT_EQ(fault(TaskDatabase::checkpoint), std::nullopt);
  ending_ = RunEnding::done;
  begin_run("task 1");  // a diagnosis that goes on is another run
  EXPECT_EQ(fault(TaskDatabase::shard), std::nullopt);
}

TEST_F(TaskDatabaseTest, IsNotThatOfAnotherTask) {
  begin_run("task 2");
  EXPECT_THAT(fault(TaskDatabase::shard), Optional(std::string("contains results of another task")));
  EXPECT_THAT(fault(TaskDatabase::checkpoint), Optional(std::string("contains results of another task")));
}

TEST_F(TaskDatabaseTest, MustBeReadable) {
  EXPECT_TRUE(fault(TaskDatabase::shard)) << "there is none";
  Database::open(file_);
  EXPECT_THAT(fault(TaskDatabase::shard), Optional(std::string("contains no results of the task")));
  EXPECT_EQ(fault(TaskDatabase::checkpoint), std::nullopt);
  begin_run("task 1");
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) / 2);
  EXPECT_THAT(fault(TaskDatabase::checkpoint), Optional(std::string("is damaged")));
  folder_.write("shard.db", "not a database, but a text that is long enough to be looked at as one");
  EXPECT_THAT(fault(TaskDatabase::checkpoint), Optional(testing::HasSubstr("is not a Lacuna database")));
}

}  // namespace
}  // namespace lacuna

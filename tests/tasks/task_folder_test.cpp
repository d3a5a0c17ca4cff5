#include "tasks/task_folder.h"

#include "foundation/problem.h"
#include "tasks/made_up_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <iterator>

namespace lacuna {
namespace {

using test::made_up_plan;
using test::write_text;
using testing::ElementsAre;

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class TaskFolderTest : public testing::Test {
 protected:
  std::filesystem::path local(const std::string& text) const {
    write_text(scratch_ / "shard.db", text);
    return scratch_ / "shard.db";
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

TEST_F(TaskFolderTest, TellsHowFarEachTaskIs) {
  EXPECT_EQ(folder_.status(0).state, TaskState::open);
  {
    const TaskSign sign(folder_, 0);
    EXPECT_EQ(folder_.status(0).state, TaskState::running);
    EXPECT_FALSE(folder_.status(0).machine.empty());
  }
  std::filesystem::last_write_time(scratch_ / "plan" / "signs" / "0.json",
                                   std::filesystem::file_time_type::clock::now() - std::chrono::minutes(5));
  EXPECT_EQ(folder_.status(0).state, TaskState::silent);
  folder_.note_failure(0, "the rig does not answer");
  EXPECT_EQ(folder_.status(0).state, TaskState::failed);
  EXPECT_EQ(folder_.status(0).reason, "the rig does not answer");
  folder_.keep_checkpoint(1, local("half"));
  folder_.note_interruption(1, "interrupted");
  EXPECT_EQ(folder_.status(1).state, TaskState::interrupted);
  folder_.keep_shard(2, local("whole"));
  EXPECT_EQ(folder_.status(2).state, TaskState::done);
  EXPECT_THAT(folder_.open_tasks(), ElementsAre(0U, 1U, 3U));
}

TEST_F(TaskFolderTest, ACheckpointIsThereUntilTheShardIs) {
  EXPECT_FALSE(folder_.take_checkpoint(3, scratch_ / "taken.db"));
  folder_.keep_checkpoint(3, local("half"));
  folder_.keep_checkpoint(3, local("more than half"));
  EXPECT_TRUE(folder_.take_checkpoint(3, scratch_ / "taken.db"));
  EXPECT_EQ(content(scratch_ / "taken.db"), "more than half");
  folder_.keep_shard(3, local("whole"));
  EXPECT_EQ(content(folder_.shard(3)), "whole");
  EXPECT_FALSE(folder_.take_checkpoint(3, scratch_ / "taken.db"));
}

/// What two processes found at once is the same; a merge may be reading the first.
TEST_F(TaskFolderTest, TheFirstShardStays) {
  folder_.keep_shard(0, local("first"));
  folder_.keep_shard(0, local("second"));
  EXPECT_EQ(content(folder_.shard(0)), "first");
  EXPECT_EQ(folder_.status(0).state, TaskState::done);
}

}  // namespace
}  // namespace lacuna

#pragma once

#include "foundation/processes/stop.h"
#include "tasks/task_plan.h"

#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace lacuna {

/// How far a task is.
enum class TaskState {
  open,         ///< not begun
  running,      ///< a process has shown within the last three minutes that it works on it
  silent,       ///< it was begun, and its process has shown nothing for longer than that
  interrupted,  ///< can continue from a checkpoint
  failed,       ///< it ended with an error
  done          ///< its shard is there
};

struct TaskStatus {
  TaskState state = TaskState::open;
  std::string machine;  ///< machine of the last process; empty: not begun
  std::string time;     ///< UTC: when it was begun there, or ended
  std::string reason;   ///< why it failed, or was interrupted
};

/// Path of the checkpoint of an unfinished task in the plan's folder.
std::filesystem::path checkpoint_in(const std::filesystem::path& folder, std::size_t task);

/// A plan's folder, which many processes on many machines use at once:
///
///     plan.json       the plan
///     shards/N.db     results of task N, complete
///     checkpoints/N.db  of one that was interrupted
///     signs/N.json    who has it, since when, what became of it
///     logs/           what jobs have printed
///
/// Every file gets its name when it is complete and checked. A task that two processes carry out at once gets the same
/// results twice.
class TaskFolder {
 public:
  /// Makes the folder. Where it has a plan of the same tasks already, what they have found stays. Throws `BadInput`
  /// where it has another plan or other files.
  static TaskFolder make(const std::filesystem::path& folder, const TaskPlan& plan, const Stop& stop = {});
  /// Throws `BadInput` where there is no plan.
  explicit TaskFolder(const std::filesystem::path& folder);

  const std::filesystem::path& path() const { return folder_; }
  /// Makes what a copy of the folder may lack. Throws `BadInput` where it cannot be written.
  void make_ready() const;
  const TaskPlan& plan() const { return plan_; }
  /// Throws `BadInput` where the plan has no such task.
  const Task& task(std::size_t number) const;

  std::filesystem::path shard(std::size_t number) const;
  std::filesystem::path checkpoint(std::size_t number) const;
  bool is_done(std::size_t number) const;
  /// By the clock of the folder's file system, which all machines share; where nothing can be written there, by that
  /// of this one.
  std::filesystem::file_time_type now() const;
  TaskStatus status(std::size_t number, std::filesystem::file_time_type now) const;
  /// Numbers of the tasks that are not done.
  std::vector<std::size_t> open_tasks() const;

  /// Copies the checkpoint to `file`; false if there is none.
  bool take_checkpoint(std::size_t number, const std::filesystem::path& file) const;
  /// Of one that cannot be used; returns where it is.
  std::filesystem::path put_checkpoint_aside(std::size_t number) const;
  /// A database of the task, be it that it is written meanwhile. Does nothing where there is no such file, where the
  /// task is done or where another process has left a later checkpoint. Throws `Error` where it cannot be written.
  void keep_checkpoint(std::size_t number, const std::filesystem::path& file) const;
  /// Gives the shard its place, unless another process was quicker. The checkpoint goes. Throws `Error` where it cannot
  /// be written.
  void keep_shard(std::size_t number, const std::filesystem::path& file) const;
  void note_interruption(std::size_t number, const std::string& reason) const;
  void note_failure(std::size_t number, const std::string& reason) const;

 private:
  friend class TaskSign;
  std::filesystem::path sign(std::size_t number) const;
  void write_sign(std::size_t number, const char* state, const std::string& reason) const;
  /// A failure to write is reported; it does not affect the results of the task.
  void try_to_write_sign(std::size_t number, const char* state, const std::string& reason) const;

  std::filesystem::path folder_;
  TaskPlan plan_;
};

/// While it lives, others see that a process works on the task.
class TaskSign {
 public:
  TaskSign(const TaskFolder& folder, std::size_t number);

 private:
  std::jthread beating_;
};

}  // namespace lacuna

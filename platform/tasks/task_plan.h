#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// The file of this program, wherever it is installed.
inline constexpr const char* kThisProgram = "/proc/self/exe";

/// A file that results of a task follow from.
struct TaskInput {
  std::filesystem::path file;  ///< absolute, or `kThisProgram`
  std::string sha256;
  bool operator==(const TaskInput&) const = default;
};

enum class TaskKind {
  run,       ///< one replicate of a run of the algorithm
  diagnosis  ///< of an experiment with recorded trials
};

/// One piece of work that a process does alone: a command on an experiment. Its results are a database, the shard.
struct Task {
  std::string id;  ///< 64 hexadecimal digits, see `id_of`
  TaskKind kind = TaskKind::run;
  std::filesystem::path experiment;   ///< the file, absolute
  std::string name;                   ///< of the experiment
  std::vector<std::string> settings;  ///< as `--set` takes them
  std::uint64_t seed = 1;
  int replicate = 1;
  std::vector<std::size_t> inputs;  ///< of the plan
  bool operator==(const Task&) const = default;
};

/// Tasks, numbered from 0, with all that they follow from, so that any process on any machine that has the same files
/// carries out the same ones.
struct TaskPlan {
  std::string command;  ///< that made it
  std::vector<std::filesystem::path> plugin_paths;
  std::vector<TaskInput> inputs;
  std::vector<Task> tasks;
};

/// SHA-256 of what a task's results follow from: kind, name, settings, seed, replicate, and the content of its inputs,
/// wherever they lie.
std::string id_of(const Task& task, const std::vector<TaskInput>& inputs);

/// As JSON; `file` is named in complaints. Throws `BadInput` where it is no plan, or not the one that was written.
std::string text_of_plan(const TaskPlan& plan);
TaskPlan read_plan(const std::string& text, const std::filesystem::path& file);

/// Sentences: which inputs of a task are not those of the plan any more, or cannot be read.
std::vector<std::string> changed_inputs(const TaskPlan& plan, const Task& task);

}  // namespace lacuna

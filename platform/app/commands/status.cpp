#include "app/commands/commands.h"
#include "foundation/text/counted.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/shell_word.h"
#include "tasks/slurm_jobs.h"
#include "tasks/task_folder.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <memory>

namespace lacuna {
namespace {

const char* to_string(TaskState state) {
  switch (state) {
    case TaskState::open: return "not begun";
    case TaskState::running: return "running";
    case TaskState::silent: return "without news";
    case TaskState::interrupted: return "interrupted";
    case TaskState::failed: return "failed";
    case TaskState::done: return "done";
  }
  return "";
}

std::string on_one_line(std::string reason) {
  for (std::size_t end = 0; (end = reason.find('\n', end)) != std::string::npos;) reason.replace(end, 1, "; ");
  return plain_text(reason);
}

/// Prints details only of tasks that may need attention.
void print_task(std::size_t number, const TaskStatus& status) {
  const std::string who = fmt::format("{}, {}", plain_text(status.machine), plain_text(status.time));
  if (status.state == TaskState::failed)
    fmt::print("task {} failed ({}): {}\n", number, who, on_one_line(status.reason));
  if (status.state == TaskState::silent)
    fmt::print("task {}: no news for three minutes ({}). If its process or machine has stopped, run the task again\n",
               number, who);
  if (status.state == TaskState::running) fmt::print("task {} is running ({})\n", number, who);
}

void print_status(const std::filesystem::path& path) {
  const TaskFolder folder(path);
  std::map<TaskState, std::vector<std::size_t>> tasks;
  const auto now = folder.now();
  for (std::size_t number = 0; number < folder.plan().tasks.size(); ++number) {
    const TaskStatus status = folder.status(number, now);
    tasks[status.state].push_back(number);
    print_task(number, status);
  }
  std::vector<std::string> counts;
  for (const auto& [state, numbers] : tasks)
    counts.push_back(fmt::format("{} {} ({})", numbers.size(), to_string(state), array_of(numbers)));
  fmt::print("{}: {}: {}\n", plain_text(path.string()), counted(folder.plan().tasks.size(), "task"),
             fmt::join(counts, ", "));
  const std::string typed = shell_word(path.string());
  for (const TaskState state : {TaskState::interrupted, TaskState::failed, TaskState::open, TaskState::silent})
    if (tasks.contains(state)) return fmt::print("→ lacuna task run {} {}\n", typed, tasks[state].front());
  if (!tasks.contains(TaskState::running)) fmt::print("→ lacuna merge ALL.db {}\n", typed);
}

}  // namespace

void add_status_command(CLI::App& program) {
  auto folder = std::make_shared<std::filesystem::path>();  // shared: CLI11 keeps the callback, which must own it
  CLI::App* command = program.add_subcommand("status", "Print the progress of a plan's tasks");
  command->add_option("folder", *folder, "Folder of the plan")->required()->option_text("FOLDER");
  command->callback([folder] { print_status(*folder); });
}

}  // namespace lacuna

#include "app/tasks/task_left.h"

#include "app/terminal/scratch_folder.h"
#include "foundation/text/shell_word.h"
#include "tasks/task_folder.h"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>

namespace lacuna {
namespace {

TaskLeft read_left(const std::string& text) {
  const std::size_t first = text.find('\0'), second = text.find('\0', first + 1);
  return {text.substr(second + 1, text.find('\0', second + 1) - second - 1), std::strtoull(text.c_str(), nullptr, 10),
          text.substr(first + 1, second - first - 1)};
}

void note_end(const TaskFolder& folder, const TaskLeft& left, const ChildLoss& loss) {
  if (loss.begins_anew) return;
  loss.was_asked ? folder.note_interruption(left.number, loss.deed) : folder.note_failure(left.number, loss.sentence);
}

void say_where_it_is(const TaskFolder& folder, std::size_t number) {
  if (folder.is_done(number)) return tell(fmt::format("another process has done task {}", number));
  const char* const found = std::filesystem::exists(folder.checkpoint(number))
                                ? "has a checkpoint with its results so far"
                                : "has no stored results yet";
  tell(fmt::format("task {} {}; to continue: lacuna task run {} {}", number, found, shell_word(folder.path().string()),
                   number));
}

void hand_in(const TaskLeft& left, const ChildLoss& loss) {
  const std::filesystem::path scratch = keep_scratch(left.scratch);
  try {
    const TaskFolder folder(left.folder);
    note_end(folder, left, loss);
    folder.keep_checkpoint(left.number, scratch / "shard.db");
    std::error_code ignored;
    std::filesystem::remove_all(scratch, ignored);
    if (!loss.begins_anew) say_where_it_is(folder, left.number);
  } catch (const std::exception& lost) {
    tell(fmt::format("{}\n{}", lost.what(), where_it_stays(left.folder, left.number, scratch)));
  }
}

}  // namespace

std::string where_it_stays(const std::filesystem::path& folder, std::size_t number,
                           const std::filesystem::path& scratch) {
  return fmt::format("the results so far are in {}; to let the task continue from them, run: cp {} {}",
                     scratch.string(), shell_word((scratch / "shard.db").string()),
                     shell_word(checkpoint_in(folder, number).string()));
}

std::string TaskLeft::text() const {
  const std::string end(1, '\0');
  return std::to_string(number) + end + scratch.string() + end + folder.string() + end;
}

void report_loss(const ChildLoss& loss) {
  print_loss(loss);
  if (!loss.left.empty()) hand_in(read_left(loss.left), loss);
}

}  // namespace lacuna

#include "app/tasks/task_left.h"

#include "foundation/shell_word.h"
#include "tasks/task_folder.h"

#include <lacuna/error.h>

#include <fmt/format.h>

#include <cstdlib>

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

void hand_in(const TaskLeft& left, const ChildLoss& loss) try {
  const TaskFolder folder(left.folder);
  note_end(folder, left, loss);
  folder.keep_checkpoint(left.number, left.scratch / "shard.db");
  std::error_code ignored;
  std::filesystem::remove_all(left.scratch, ignored);
  if (loss.begins_anew) return;
  fmt::print(stderr, "what task {} has found until then is its checkpoint; to continue: lacuna task run {} {}\n",
             left.number, shell_word(left.folder.string()), left.number);
} catch (const Error& lost) {
  fmt::print(stderr, "{}\nwhat was found until then is in {}\n", lost.what(), left.scratch.string());
}

}  // namespace

std::string TaskLeft::text() const {
  const std::string end(1, '\0');
  return std::to_string(number) + end + scratch.string() + end + folder.string() + end;
}

void report_loss(const ChildLoss& loss) {
  print_loss(loss);
  if (!loss.left.empty()) hand_in(read_left(loss.left), loss);
}

}  // namespace lacuna

#include "app/terminal/left_running.h"

#include "app/terminal/supervised.h"
#include "foundation/processes/processes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <string>
#include <vector>

namespace lacuna {
namespace {

constexpr double kGraceOfLeft = 0.2;   // s
constexpr std::size_t kMostNamed = 5;  // processes

std::string named(const std::vector<pid_t>& processes) {
  std::vector<std::string> names;
  for (const pid_t process : processes) {
    if (names.size() == kMostNamed) {
      names.push_back(fmt::format("{} more", processes.size() - kMostNamed));
      break;
    }
    names.push_back(fmt::format("\"{}\" (process {})", command_of(process), process));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

LeftRunning::LeftRunning() : has_children_of_others_(has_children()) {}

void LeftRunning::end() const {
  if (has_children_of_others_ || !has_children()) return;
  const std::vector<pid_t> left = processes_to_end();
  if (left.empty()) return;
  tell(
      fmt::format("lacuna: ended processes that were still running after the command: {}; a plugin or the target's "
                  "program had started them",
                  named(left)));
  end_descendants(kGraceOfLeft);
}

}  // namespace lacuna

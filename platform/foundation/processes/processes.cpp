#include "foundation/processes/processes.h"

#include "foundation/text/plain_text.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>

namespace lacuna {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPause{5};
constexpr std::chrono::seconds kLongestEnd{2};  // of what is killed

std::optional<pid_t> number_in(std::string_view text) {
  pid_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::vector<pid_t> all_processes() {
  std::vector<pid_t> processes;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", unreadable))
    if (const auto number = number_in(entry.path().filename().string())) processes.push_back(*number);
  return processes;
}

/// Empty where the process has ended, which also happens between opening and reading.
std::string content_of(pid_t process, const char* file) {
  const std::ifstream stream("/proc/" + std::to_string(process) + "/" + file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();  // sets a bad state on a read error instead of throwing
  return content.str();
}

/// A process that has ended but was not waited for does no work.
struct Standing {
  pid_t parent = 0;
  bool over = false;
};

/// The second field of the file is the program's name in brackets, which may contain anything.
std::optional<Standing> standing_of(pid_t process) {
  const std::string status = content_of(process, "stat");
  const std::size_t end_of_name = status.rfind(") ");
  if (end_of_name == std::string::npos || end_of_name + 4 >= status.size()) return std::nullopt;
  const std::size_t begin = end_of_name + 4, end = status.find(' ', begin);
  const auto parent = number_in(std::string_view(status).substr(begin, end - begin));
  if (!parent) return std::nullopt;
  const char state = status[end_of_name + 2];
  return Standing{*parent, state == 'Z' || state == 'X'};
}

bool has_variable(pid_t process, const std::string& variable) {
  return ('\0' + content_of(process, "environ") + '\0').find('\0' + variable + '\0') != std::string::npos;
}

void wait_for_ended_children() {
  while (waitpid(-1, nullptr, WNOHANG) > 0) {
  }
}

/// Those that could be signalled; processes of other users cannot.
std::vector<pid_t> signalled(std::vector<pid_t> processes, int signal) {
  std::erase_if(processes, [&](pid_t process) { return kill(process, signal) != 0; });
  return processes;
}

}  // namespace

std::vector<pid_t> descendants_of(pid_t process) {
  std::map<pid_t, std::vector<pid_t>> children;
  std::map<pid_t, bool> over;
  for (const pid_t one : all_processes())
    if (const auto standing = standing_of(one)) {
      children[standing->parent].push_back(one);
      over[one] = standing->over;
    }
  std::vector<pid_t> found = children[process];
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<pid_t> more = children[found[i]];
    found.insert(found.end(), more.begin(), more.end());
  }
  std::erase_if(found, [&](pid_t one) { return over[one]; });
  return found;
}

std::vector<pid_t> processes_with(const std::string& variable) {
  std::vector<pid_t> found;
  for (const pid_t process : all_processes())
    if (process != getpid() && has_variable(process, variable)) found.push_back(process);
  return found;
}

std::vector<pid_t> processes_to_end() {
  std::vector<pid_t> processes = descendants_of(getpid());
  std::erase_if(processes, [](pid_t process) { return has_variable(process, kOutlives); });
  return processes;
}

bool has_children() {
  siginfo_t child{};
  return waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0;
}

std::string command_of(pid_t process) {
  constexpr std::size_t kMost = 60;  // bytes
  std::string words = content_of(process, "cmdline").substr(0, kMost);
  words.erase(words.find_last_not_of('\0') + 1);
  for (char& letter : words)
    if (letter == '\0') letter = ' ';
  return plain_text(words);
}

void end_descendants(double grace) {
  const auto patience =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(grace));
  signalled(processes_to_end(), SIGTERM);
  while (Clock::now() < patience + kLongestEnd) {
    wait_for_ended_children();
    const bool waited = Clock::now() >= patience;
    if (signalled(processes_to_end(), waited ? SIGKILL : 0).empty()) break;
    std::this_thread::sleep_for(kPause);
  }
  wait_for_ended_children();
}

}  // namespace lacuna

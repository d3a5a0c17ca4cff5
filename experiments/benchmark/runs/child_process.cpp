#include "runs/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace hidden_effects {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{10};
constexpr std::chrono::seconds kGrace{5};  // between asking a child to end and ending it
constexpr std::streamoff kMostText = 1 << 16;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string end_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(0, size - kMostText));
  return {std::istreambuf_iterator<char>(in), {}};
}

/// How a child begins: in its folder, its output in files, in a process group of its own, so that an interrupt at the
/// terminal reaches the benchmark alone.
class Beginning {
 public:
  Beginning(const std::filesystem::path& folder, const std::filesystem::path& output,
            const std::filesystem::path& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    constexpr int kHow = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, output.c_str(), kHow, 0600);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, errors.c_str(), kHow, 0600);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~Beginning() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Beginning(const Beginning&) = delete;
  Beginning& operator=(const Beginning&) = delete;

  pid_t spawn(const std::vector<std::string>& words) const {
    std::vector<std::string> copies = words;
    std::vector<char*> pointers;
    for (std::string& word : copies) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    const int failed = posix_spawn(&child, words.front().c_str(), &actions_, &attributes_, pointers.data(), environ);
    if (failed != 0) throw std::runtime_error(fmt::format("{} cannot be run: {}", words.front(), strerror(failed)));
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

double processor_seconds(const rusage& used) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

bool has_ended(pid_t child, int& status, rusage& used) { return wait4(child, &status, WNOHANG, &used) == child; }

void end_child(pid_t child, int& status, rusage& used) {
  kill(-child, SIGTERM);
  for (const Clock::time_point asked = Clock::now(); Clock::now() - asked < kGrace;) {
    if (has_ended(child, status, used)) return;
    std::this_thread::sleep_for(kPause);
  }
  kill(-child, SIGKILL);
  wait4(child, &status, 0, &used);
}

}  // namespace

ChildOutcome run_child(const std::vector<std::string>& words, const std::filesystem::path& folder, double longest,
                       const std::function<bool()>& stop) {
  const std::filesystem::path here = std::filesystem::absolute(folder);
  const std::filesystem::path output = here / "child-output.txt", errors = here / "child-errors.txt";
  const Clock::time_point start = Clock::now();
  const pid_t child = Beginning(here, output, errors).spawn(words);
  ChildOutcome outcome;
  int status = 0;
  rusage used{};
  while (!has_ended(child, status, used)) {
    outcome.timed_out = since(start) > longest;
    outcome.stopped = stop();
    if (outcome.timed_out || outcome.stopped) {
      end_child(child, status, used);
      break;
    }
    std::this_thread::sleep_for(kPause);
  }
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.seconds = since(start);
  outcome.processor_seconds = processor_seconds(used);
  outcome.output = end_of(output);
  outcome.errors = end_of(errors);
  return outcome;
}

}  // namespace hidden_effects

#include "runs/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace hidden_effects {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPause{10};
constexpr std::chrono::seconds kGrace{5};  // between asking a child to end and ending it
constexpr off_t kMostText = 1 << 16;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A file in memory that a child writes to.
class Captured {
 public:
  explicit Captured(const char* name) : file_(memfd_create(name, MFD_CLOEXEC)) {
    if (file_ < 0) throw std::runtime_error(fmt::format("no room for a child's output: {}", strerror(errno)));
  }
  ~Captured() { close(file_); }
  Captured(const Captured&) = delete;
  Captured& operator=(const Captured&) = delete;

  int file() const { return file_; }

  std::string end() const {
    const off_t size = lseek(file_, 0, SEEK_END), from = std::max<off_t>(0, size - kMostText);
    std::string text(static_cast<std::size_t>(size - from), '\0');
    const ssize_t got = pread(file_, text.data(), text.size(), from);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return text;
  }

 private:
  int file_;
};

/// How a child begins: in its folder, with its output captured, in a process group of its own, so that an interrupt at
/// the terminal reaches the benchmark alone.
class Beginning {
 public:
  Beginning(const std::filesystem::path& folder, const Captured& output, const Captured& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output.file(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors.file(), STDERR_FILENO);
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
  const Captured output("output"), errors("errors");
  const Clock::time_point start = Clock::now();
  const pid_t child = Beginning(std::filesystem::absolute(folder), output, errors).spawn(words);
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
  outcome.output = output.end();
  outcome.errors = errors.end();
  return outcome;
}

}  // namespace hidden_effects

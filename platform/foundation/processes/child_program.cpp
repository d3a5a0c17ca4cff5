#include "foundation/processes/child_program.h"

#include "foundation/processes/processes.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstring>
#include <thread>

namespace lacuna {
namespace {

using Clock = std::chrono::steady_clock;

constexpr off_t kMostText = 1 << 16;
constexpr off_t kMostWritten = 1 << 24;
constexpr std::chrono::milliseconds kBetweenLooks{100};
constexpr double kLongestWait = 1e9;  // s, representable by a clock that counts nanoseconds
constexpr int kMostLooks = 50;
constexpr std::chrono::milliseconds kShortestPause{1}, kLongestPause{10};

/// The settings of `posix_spawn`.
class SpawnOrders {
 public:
  explicit SpawnOrders(const ChildBeginning& beginning) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    if (!beginning.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, beginning.folder.c_str());
    connect(beginning.input, STDIN_FILENO, O_RDONLY);
    connect(beginning.output, STDOUT_FILENO, O_WRONLY);
    connect(beginning.errors, STDERR_FILENO, O_WRONLY);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~SpawnOrders() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnOrders(const SpawnOrders&) = delete;
  SpawnOrders& operator=(const SpawnOrders&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  void connect(int descriptor, int stream, int how) {
    if (descriptor < 0)
      posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", how, 0);
    else
      posix_spawn_file_actions_adddup2(&actions_, descriptor, stream);
  }

  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// Words as a C array with a null at its end.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// A variable that all descendants of a child inherit.
std::string new_mark() {
  static std::atomic<unsigned> children = 0;
  static const auto begun = std::chrono::system_clock::now().time_since_epoch().count();
  return fmt::format("{}={}.{}.{}", kChildMark, begun, getpid(), ++children);
}

std::vector<std::string> environment_with(const std::map<std::string, std::string>& variables) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const std::string name = text.substr(0, text.find('='));
    if (name != kChildMark && !variables.contains(name)) all.push_back(text);
  }
  for (const auto& [name, value] : variables) all.push_back(fmt::format("{}={}", name, value));
  return all;
}

double processor_seconds(const rusage& used) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Whether it has ended. Its number stays reserved until it is waited for.
bool is_over(pid_t process) {
  siginfo_t told{};
  return waitid(P_PID, static_cast<id_t>(process), &told, WEXITED | WNOHANG | WNOWAIT) != 0 || told.si_pid == process;
}

}  // namespace

CapturedOutput::CapturedOutput(const char* name) : file_(memfd_create(name, MFD_CLOEXEC)) {
  if (file_ < 0) throw Error(fmt::format("no memory for a program's output: {}", strerror(errno)));
  fcntl(file_, F_SETFL, O_APPEND);  // a child shares the position in the file, which is moved here
  keeper_ = std::jthread([this](const std::stop_token& stop) {
    std::mutex unused;
    std::unique_lock lock(unused);
    for (std::condition_variable_any pause; !stop.stop_requested(); forget())
      pause.wait_for(lock, stop, kBetweenLooks, [] { return false; });
  });
}

CapturedOutput::~CapturedOutput() {
  keeper_ = {};  // has ended when the file is closed
  close(file_);
}

std::string CapturedOutput::end() const {
  const off_t size = lseek(file_, 0, SEEK_END), from = std::max<off_t>(0, size - kMostText);
  std::string text(static_cast<std::size_t>(size - from), '\0');
  const ssize_t got = pread(file_, text.data(), text.size(), from);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return text;
}

void CapturedOutput::forget() {
  const off_t to = lseek(file_, 0, SEEK_END) - kMostText;
  if (to - forgotten_ < kMostWritten) return;
  // Leaves a hole instead of truncating the file, which would lose bytes written between reading its end and truncating
  // it.
  if (fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, 0, to) == 0) forgotten_ = to;
}

int ChildEnding::code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

std::string ChildEnding::phrase() const {
  if (WIFEXITED(status)) return fmt::format("ended with exit code {}", WEXITSTATUS(status));
  return fmt::format("was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
}

std::string ChildEnding::deed() const {
  if (WIFEXITED(status)) return fmt::format("ended the program with exit code {}", WEXITSTATUS(status));
  return fmt::format("ended the program by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
}

ChildProgram::ChildProgram(const ChildBeginning& beginning) : mark_(new_mark()) {
  std::vector<std::string> words = beginning.words, variables = environment_with(beginning.environment);
  variables.push_back(mark_);
  const SpawnOrders orders(beginning);
  const int failed = posix_spawnp(&process_, words.front().c_str(), orders.actions(), orders.attributes(),
                                  pointers_to(words).data(), pointers_to(variables).data());
  if (failed != 0) throw Error(fmt::format("{} cannot be started: {}", beginning.words.front(), strerror(failed)));
}

ChildProgram::~ChildProgram() { end(0.0); }

std::optional<ChildEnding> ChildProgram::ended() {
  if (ending_ || !is_over(process_)) return ending_;
  end_what_it_began();
  rusage used{};
  ending_.emplace();
  wait4(process_, &ending_->status, 0, &used);
  ending_->processor_seconds = processor_seconds(used);
  return ending_;
}

std::optional<ChildEnding> ChildProgram::ended_within(double seconds) {
  const Clock::time_point until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                     std::chrono::duration<double>(std::min(seconds, kLongestWait)));
  for (auto pause = kShortestPause; !ended() && Clock::now() < until; pause = std::min(2 * pause, kLongestPause))
    std::this_thread::sleep_for(pause);
  return ended();
}

/// Its group, and processes that left the group. A process that starts during one pass is found by the next.
void ChildProgram::end_what_it_began() {
  kill(-process_, SIGKILL);
  for (int look = 0; look < kMostLooks; ++look) {
    const std::vector<pid_t> left = processes_with(mark_);
    bool found = false;
    for (const pid_t process : left) found |= process != process_ && kill(process, SIGKILL) == 0;
    if (!found) return;
    std::this_thread::sleep_for(kShortestPause);
  }
}

void ChildProgram::ask_to_end() {
  if (!ended()) kill(-process_, SIGTERM);
}

ChildEnding ChildProgram::end(double grace) {
  if (const std::optional<ChildEnding> before = ended()) return *before;
  if (grace > 0.0) ask_to_end();
  if (!ended_within(grace)) {
    kill(-process_, SIGKILL);
    while (!ended_within(1.0)) {
    }
  }
  return *ending_;
}

}  // namespace lacuna

#include "loading/child_process.h"

#include "foundation/processes/child_program.h"
#include "foundation/plugins/plugin_call.h"
#include "foundation/plugins/plugin_libraries.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>

namespace lacuna {
namespace {

void become_silent() {
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE}) std::signal(signal, SIG_DFL);
  CallPage::watch_this_process();
}

bool write_all(int pipe_end, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = write(pipe_end, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

/// An answer is sent as its length and its bytes.
bool send(int pipe_end, const std::string& answer) {
  const auto size = static_cast<std::uint32_t>(answer.size());
  return write_all(pipe_end, reinterpret_cast<const char*>(&size), sizeof(size)) &&
         write_all(pipe_end, answer.data(), size);
}

[[noreturn]] void serve(int pipe_end, std::size_t first, std::size_t count,
                        const std::function<std::string(std::size_t)>& work, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // the child ended before that
  become_silent();
  for (std::size_t index = first; index < count; ++index) {
    std::string answer;
    try {
      answer = work(index);
    } catch (...) {  // an exception does not end the child; the host meets it again and reports it
    }
    if (!send(pipe_end, answer)) _exit(1);
  }
  _exit(0);
}

constexpr std::chrono::milliseconds kBetweenLooks{100};

/// The child that does the work, as seen by the parent. The parent ends it when it has to wait too long: a process can
/// disable an alarm, and a stopped process receives none.
class WorkingChild {
 public:
  WorkingChild(pid_t process, int pipe_end, std::chrono::seconds limit)
      : process_(process), pipe_(pipe_end), limit_(limit) {}

  /// False: it ended, or was ended, before its answer was complete.
  bool receive(std::string& answer) {
    patience_ = limit_;
    std::uint32_t size = 0;
    if (!read_all(reinterpret_cast<char*>(&size), sizeof(size))) return false;
    answer.resize(size);
    return read_all(answer.data(), size);
  }

  /// How it ended; call this once, when no answer comes any more.
  std::string cause_of_death() {
    wait_for_end();
    if (!cause_.empty()) return cause_;
    return ChildEnding{*status_}.deed();
  }

  /// After its last answer its end no longer matters.
  void end() {
    kill(process_, SIGKILL);
    wait_for_end();
  }

 private:
  bool read_all(char* bytes, std::size_t count) {
    while (count > 0) {
      if (!wait_for_bytes()) return false;
      const ssize_t got = read(pipe_, bytes, count);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      bytes += got;
      count -= static_cast<std::size_t>(got);
    }
    return true;
  }

  /// A process that the child started may hold the pipe open after the child's end. Time in which this process was
  /// stopped does not count.
  bool wait_for_bytes() {
    for (;;) {
      pollfd pipe{pipe_, POLLIN, 0};
      const int ready = poll(&pipe, 1, static_cast<int>(kBetweenLooks.count()));
      if (ready > 0) return true;
      if (ready == 0) patience_ -= kBetweenLooks;
      if (patience_ <= std::chrono::milliseconds(0))
        return give_up("took longer than " + std::to_string(limit_.count()) + " s");
      look();
      if (status_ && poll(&pipe, 1, 0) <= 0) return false;
    }
  }

  bool give_up(const std::string& cause) {
    cause_ = cause;
    kill(process_, SIGKILL);
    return false;
  }

  /// Whether it has ended or stopped. A terminal stops it with its parent; it stops itself by SIGSTOP.
  void look() {
    int status = 0;
    if (status_ || waitpid(process_, &status, WNOHANG | WUNTRACED) != process_) return;
    if (!WIFSTOPPED(status))
      status_ = status;
    else if (WSTOPSIG(status) == SIGSTOP)
      give_up("stopped the program by signal 19 (SIGSTOP)");
    else
      kill(process_, SIGCONT);
  }

  void wait_for_end() {
    int status = 0;
    while (!status_) {
      const pid_t changed = waitpid(process_, &status, 0);
      if (changed == process_ || (changed < 0 && errno != EINTR)) status_ = status;
    }
  }

  pid_t process_;
  int pipe_;
  std::chrono::seconds limit_;
  std::chrono::milliseconds patience_{0};
  std::optional<int> status_;  ///< once it has ended
  std::string cause_;          ///< why it was ended
};

}  // namespace

std::vector<ChildAnswer> ask_in_child(std::size_t count, const std::function<std::string(std::size_t)>& work,
                                      unsigned seconds_each) {
  const HostCall call;  // the page is this process's and the child's
  const CallAllowance own_limit(std::numeric_limits<double>::infinity());
  std::vector<ChildAnswer> answers(count);
  std::fflush(nullptr);
  std::size_t next = 0;
  while (next < count) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw Error(std::string("no pipe to a child process could be made: ") + strerror(errno));
    const pid_t parent = getpid(), process = fork();
    if (process == 0) serve(ends[1], next, count, work, parent);
    const int why = errno;
    close(ends[1]);
    if (process < 0) {
      close(ends[0]);
      throw Error(std::string("no child process can be started: ") + strerror(why));
    }
    WorkingChild child(process, ends[0], std::chrono::seconds(seconds_each));
    while (next < count && child.receive(answers[next].answer)) ++next;
    if (next == count)
      child.end();
    else
      answers[next].death = child.cause_of_death();
    close(ends[0]);
    if (next == count) break;
    const std::vector<ActiveCall> calls = CallPage::active();
    answers[next] = {answers[next].death, calls.empty() ? "" : calls.front().call, PluginLibraries::culprit(), ""};
    CallPage::clear();
    PluginLibraries::forget_culprit();
    ++next;
  }
  return answers;
}

}  // namespace lacuna

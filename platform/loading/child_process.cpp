#include "loading/child_process.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace lacuna {
namespace {

void become_silent() {
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  for (const int signal : {SIGALRM, SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE}) std::signal(signal, SIG_DFL);
}

/// Writes one byte a piece of work done.
[[noreturn]] void serve(int pipe_end, std::size_t first, std::size_t count,
                        const std::function<void(std::size_t)>& work, unsigned seconds_each) {
  become_silent();
  for (std::size_t index = first; index < count; ++index) {
    alarm(seconds_each);
    try {
      work(index);
    } catch (...) {  // an exception is not a death; the host meets it again and says what it was
    }
    if (write(pipe_end, "+", 1) != 1) _exit(1);
  }
  _exit(0);
}

std::size_t count_bytes(int pipe_end) {
  std::size_t total = 0;
  std::array<char, 256> block{};
  for (;;) {
    const ssize_t got = read(pipe_end, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return total;
    total += static_cast<std::size_t>(got);
  }
}

std::string cause_of_death(int status, unsigned seconds_each) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return "takes longer than " + std::to_string(seconds_each) + " s";
  if (WIFSIGNALED(status))
    return "is ended by signal " + std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
  return "ends the process with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

std::vector<std::string> survive_in_child(std::size_t count, const std::function<void(std::size_t)>& work,
                                          unsigned seconds_each) {
  std::vector<std::string> endings(count);
  std::fflush(nullptr);
  std::size_t next = 0;
  while (next < count) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(std::string("no pipe to a child process: ") + strerror(errno));
    const pid_t child = fork();
    if (child == 0) serve(ends[1], next, count, work, seconds_each);
    close(ends[1]);
    const std::size_t survived = child > 0 ? count_bytes(ends[0]) : 0;
    close(ends[0]);
    if (child < 0) throw Error(std::string("no child process can be started: ") + strerror(errno));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    next += survived;
    if (next < count) endings[next++] = cause_of_death(status, seconds_each);
  }
  return endings;
}

}  // namespace lacuna

#include "loading/child_process.h"

#include "foundation/child_program.h"
#include "foundation/plugin_call.h"

#include <lacuna/error.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
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

/// False: the pipe ended before.
bool read_all(int pipe_end, char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = read(pipe_end, bytes, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

/// An answer travels as its length and its bytes.
bool send(int pipe_end, const std::string& answer) {
  const auto size = static_cast<std::uint32_t>(answer.size());
  return write_all(pipe_end, reinterpret_cast<const char*>(&size), sizeof(size)) &&
         write_all(pipe_end, answer.data(), size);
}

bool receive(int pipe_end, std::string& answer) {
  std::uint32_t size = 0;
  if (!read_all(pipe_end, reinterpret_cast<char*>(&size), sizeof(size))) return false;
  answer.resize(size);
  return read_all(pipe_end, answer.data(), size);
}

[[noreturn]] void serve(int pipe_end, std::size_t first, std::size_t count,
                        const std::function<std::string(std::size_t)>& work, unsigned seconds_each) {
  become_silent();
  for (std::size_t index = first; index < count; ++index) {
    alarm(seconds_each);
    std::string answer;
    try {
      answer = work(index);
    } catch (...) {  // an exception is not a death; the host meets it again and says what it was
    }
    if (!send(pipe_end, answer)) _exit(1);
  }
  _exit(0);
}

std::string cause_of_death(int status, unsigned seconds_each) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    return "took longer than " + std::to_string(seconds_each) + " s";
  return ChildEnding{status}.deed();
}

}  // namespace

std::vector<ChildAnswer> ask_in_child(std::size_t count, const std::function<std::string(std::size_t)>& work,
                                      unsigned seconds_each) {
  const HostCall call;  // the page is this process's and the child's
  std::vector<ChildAnswer> answers(count);
  std::fflush(nullptr);
  std::size_t next = 0;
  while (next < count) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(std::string("no pipe to a child process: ") + strerror(errno));
    const pid_t child = fork();
    if (child == 0) serve(ends[1], next, count, work, seconds_each);
    close(ends[1]);
    while (child > 0 && next < count && receive(ends[0], answers[next].answer)) ++next;
    close(ends[0]);
    if (child < 0) throw Error(std::string("no child process can be started: ") + strerror(errno));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (next == count) break;
    const std::vector<ActiveCall> calls = CallPage::active();
    answers[next] = {cause_of_death(status, seconds_each), calls.empty() ? "" : calls.front().call, ""};
    CallPage::clear();
    ++next;
  }
  return answers;
}

}  // namespace lacuna

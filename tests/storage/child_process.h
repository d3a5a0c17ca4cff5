#pragma once

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>

namespace lacuna::test {

/// A process of its own for what may end a process. What `work` writes to its file descriptor can be read
/// here; what it throws is written there, too.
class ChildProcess {
 public:
  explicit ChildProcess(const std::function<void(int to_parent)>& work) {
    int ends[2];
    if (pipe(ends) != 0) std::terminate();
    child_ = fork();
    if (child_ == 0) {
      close(ends[0]);
      try {
        work(ends[1]);
      } catch (const std::exception& error) {
        say(ends[1], error.what());
      }
      _exit(0);  // without the destructors and buffers that belong to the parent
    }
    close(ends[1]);
    from_child_ = ends[0];
  }
  ~ChildProcess() {
    kill();
    close(from_child_);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  static void say(int to_parent, const std::string& text) {
    if (write(to_parent, text.data(), text.size()) < 0) _exit(1);
  }

  /// The next character; 0 at the end.
  char next() {
    char c = 0;
    return read(from_child_, &c, 1) == 1 ? c : '\0';
  }
  /// Everything until it ends.
  std::string all() {
    std::string text;
    for (char c = next(); c != '\0'; c = next()) text += c;
    return text;
  }
  void interrupt() const { ::kill(child_, SIGINT); }
  /// SIGKILL.
  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  pid_t child_ = 0;
  int from_child_ = -1;
};

}  // namespace lacuna::test

#pragma once

#include "app/terminal/supervised.h"
#include "foundation/processes/interrupt.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

namespace lacuna {

using SupervisedWork = int (*)(int, char**);
inline constexpr auto kAWhile = std::chrono::milliseconds(200);

/// A process that supervises `work`; what it prints goes to files in a folder.
class Supervisor {
 public:
  explicit Supervisor(SupervisedWork work) {
    EXPECT_EQ(pipe2(said_.data(), O_CLOEXEC), 0);
    said_end() = said_[1];
    process_ = fork();
    if (process_ != 0) return;
    dup2(open((folder_.path() / "errors").c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    _exit(run_supervised(0, nullptr, work));
  }
  ~Supervisor() {
    for (const int end : said_) close(end);
  }
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// In the work: tells the test its process number.
  static void say_ready() {
    const pid_t process = getpid();
    EXPECT_EQ(write(said_end(), &process, sizeof(process)), static_cast<ssize_t>(sizeof(process)));
  }
  /// The process that does the work, once it is at it.
  pid_t worker() const {
    pid_t process = 0;
    EXPECT_EQ(read(said_[0], &process, sizeof(process)), static_cast<ssize_t>(sizeof(process)));
    return process;
  }
  /// In the work: where the test reads process numbers from.
  static int said() { return said_end(); }
  void send(int signal) const { kill(process_, signal); }
  int wait(int options = 0) const {
    int status = 0;
    waitpid(process_, &status, options);
    return status;
  }
  std::string errors() const { return read_bytes(folder_.path() / "errors"); }

 private:
  static int& said_end() {
    static int end = -1;
    return end;
  }

  TestFolder folder_;
  std::array<int, 2> said_{};
  pid_t process_ = 0;
};

/// Work that ends when it is asked to.
inline int until_interrupted(int, char**) {
  watch_for_interrupts();
  Supervisor::say_ready();
  for (;;) {
    try {
      when_interrupted().pause_for(60.0);
    } catch (const Interrupted&) {
      return 75;
    }
  }
}

inline void hang() {
  for (;;) std::this_thread::sleep_for(kAWhile);
}

}  // namespace lacuna

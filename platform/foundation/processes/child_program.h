#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace lacuna {

/// A file in memory that a child writes to. All but the end of the output is dropped again and again, so that a verbose
/// child fills no memory, whatever this program does meanwhile.
class CapturedOutput {
 public:
  /// Throws `Error` where there is no memory for it.
  explicit CapturedOutput(const char* name);
  ~CapturedOutput();
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  int file() const { return file_; }
  /// The last 64 KiB of the output.
  std::string end() const;

 private:
  void forget();

  int file_;
  off_t forgotten_ = 0;  ///< bytes at the beginning
  std::jthread keeper_;
};

/// Settings for starting a child.
struct ChildBeginning {
  std::vector<std::string> words;  ///< the program, with its path or to be looked for in PATH, and its arguments
  std::filesystem::path folder;    ///< working folder; empty: this process's
  std::map<std::string, std::string> environment;  ///< variables besides those of this process
  int input = -1;                                  ///< descriptor; -1: nothing to read
  int output = -1, errors = -1;                    ///< -1: nowhere
};

/// How a child ended.
struct ChildEnding {
  int status = 0;  ///< status from `wait`
  double processor_seconds = 0.0;

  int code() const;            ///< of the exit; 128 + signal where a signal ended it
  std::string phrase() const;  ///< "ended with exit code 3", "was ended by signal 11 (Segmentation fault)"
  /// The cause of the end of a process of this program: "ended the program with exit code 3", "ended the program by
  /// signal 11 (Segmentation fault)".
  std::string deed() const;
};

/// The variable that all descendants of a child have in their environment.
inline constexpr const char* kChildMark = "LACUNA_CHILD";

/// A program that runs beside this one, in a separate process group, so that an interrupt at the terminal reaches only
/// this process, and the child's descendants end with it, even those in another group or session. One thread.
class ChildProgram {
 public:
  /// Throws `Error` where it cannot be started.
  explicit ChildProgram(const ChildBeginning& beginning);
  /// Ends it at once, if it still runs.
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// How it ended; nothing while it runs. Processes that it left running are ended, too.
  std::optional<ChildEnding> ended();
  /// The same, after waiting for at most `seconds`.
  std::optional<ChildEnding> ended_within(double seconds);
  /// Asks it and its group to end (SIGTERM), and does not wait.
  void ask_to_end();
  /// Asks it to end (SIGTERM), and ends it (SIGKILL) if it still runs after `grace` s.
  ChildEnding end(double grace);

 private:
  void end_what_it_began();

  std::string mark_;
  pid_t process_ = 0;
  std::optional<ChildEnding> ending_;
};

}  // namespace lacuna

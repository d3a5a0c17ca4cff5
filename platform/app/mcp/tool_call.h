#pragma once

#include "app/mcp/conclusion.h"
#include "foundation/processes/child_program.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {

/// Where calls work, and what holds for all of them.
struct CallPlace {
  std::filesystem::path folder;   ///< that commands work in, and may read and write in
  std::filesystem::path scratch;  ///< of the server's own, for results and what libraries put aside
  double seconds = 3600.0;        ///< that a call may take
};

/// A command of this program that carries a tool out, in a process of its own: what ends that process, be it a plugin,
/// a signal or the limit, ends this call alone.
class ToolCall {
 public:
  using Clock = std::chrono::steady_clock;

  /// Begins it. `words`: the command line without the program's name; `results`: the file in which --json puts the
  /// results, empty where the command has none. Throws `Error` where no process can be begun.
  ToolCall(const CallPlace& place, std::vector<std::string> words, std::filesystem::path results);
  /// Asks it to end, where it still runs, and ends it two seconds later.
  ~ToolCall();
  ToolCall(const ToolCall&) = delete;
  ToolCall& operator=(const ToolCall&) = delete;

  /// Asks the command to end, as Ctrl-C does: what it has found so far is stored. A command that does not react is
  /// ended.
  void cancel();
  /// What it came to; nothing while it runs.
  std::optional<CallOutcome> look();
  /// The last line about progress, as "refits of candidates · 40 % · 1 min 15 s left"; empty: none yet.
  std::string progress() const;
  double seconds() const;

 private:
  CallOutcome outcome(const ChildEnding& ending) const;

  std::filesystem::path results_;
  bool results_are_ours_;
  double limit_;
  CapturedOutput printed_, errors_;
  Clock::time_point begun_ = Clock::now();
  std::optional<Clock::time_point> asked_to_end_;
  bool was_late_ = false;
  ChildProgram child_;
};

}  // namespace lacuna

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// What became of a piece of work in a child process.
struct ChildAnswer {
  /// Empty where it returned, else what ended the child, as in "ended the program by signal 7 (Bus error)", "took
  /// longer than 10 s" or "stopped the program by signal 19 (SIGSTOP)".
  std::string death;
  /// The plugin call (foundation/plugins/plugin_call.h) that the child died in, as in "describe"; empty: in none.
  std::string call;
  /// The plugin library whose code ended the child outside of all calls, as in a thread that it started; empty: none,
  /// or not known.
  std::string library;
  std::string answer;  ///< what the work returned
};

/// Calls `work(index)` for every index below `count` in a child process and tells what it answered and how it ended.
/// One child does all; only after a death does another one go on with the next index, so that the usual price is one
/// fork. The child prints nothing and leaves no core file. What the work throws counts as an empty answer. One that
/// lets this process wait for an answer for `seconds_each`, or stops, is ended.
///
/// Call it before the process has threads: the child of a threaded process may hang in a lock that
/// one of them held (the time limit then ends it).
std::vector<ChildAnswer> ask_in_child(std::size_t count, const std::function<std::string(std::size_t index)>& work,
                                      unsigned seconds_each = 10);

}  // namespace lacuna

#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace lacuna {

/// The result of work in a child process.
struct ChildAnswer {
  /// Empty where the work returned, else how the child ended, as in "ended the program by signal 7 (Bus error)", "took
  /// longer than 10 s" or "stopped the program by signal 19 (SIGSTOP)".
  std::string death;
  /// The plugin call (foundation/plugins/plugin_call.h) in which the child ended, as in "describe"; empty: in none.
  std::string call;
  /// The plugin library whose code ended the child outside all calls, as in a thread that it started; empty: none, or
  /// not known.
  std::string library;
  std::string answer;  ///< what the work returned
};

/// Calls `work(index)` for every index below `count` in a child process and returns its answers and how it ended. One
/// child does all; only after its end does another one continue with the next index, so that the usual cost is one
/// fork. The child prints nothing and leaves no core file. An exception of the work counts as an empty answer. A child
/// that takes longer than `seconds_each` for an answer, or stops, is ended.
///
/// Call it before the process has threads: the child of a threaded process may block on a lock that one of them held
/// (the time limit then ends it).
std::vector<ChildAnswer> ask_in_child(std::size_t count, const std::function<std::string(std::size_t index)>& work,
                                      unsigned seconds_each = 10);

}  // namespace lacuna

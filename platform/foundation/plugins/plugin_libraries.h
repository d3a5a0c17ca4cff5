#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// The plugin libraries of a process, where its code lies in memory, and which of them ended it outside of all calls:
/// in a thread that it started, a destructor or an exit handler. The process that forked it reads that afterwards.
class PluginLibraries {
 public:
  /// Before a process is forked that is to be watched; what an earlier one left is forgotten.
  static void prepare();
  /// A library that has been loaded, by an address of its code. `of_program`: it was installed with the program.
  static void add(const void* address, const std::string& file, bool of_program);

  /// Called by what ends the process, such as a handler of a signal: the innermost library that this thread is in is
  /// remembered as the culprit, once.
  static void blame_this_thread() noexcept;

  /// The file of the culprit; empty: not known.
  static std::string culprit();
  /// For the next process that is forked.
  static void forget_culprit();
  /// The files of libraries that others wrote.
  static std::vector<std::string> of_others();
};

}  // namespace lacuna

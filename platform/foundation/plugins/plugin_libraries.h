#pragma once

#include <string>
#include <vector>

namespace lacuna {

/// The plugin libraries of a process, the address ranges of their code, and which of them ended it outside all calls:
/// in a thread that it started, a destructor or an exit handler. The process that forked it reads this afterwards.
class PluginLibraries {
 public:
  /// Call before forking a process to be watched; clears the record of an earlier one.
  static void prepare();
  /// A library that has been loaded, by an address of its code. `of_program`: it was installed with the program.
  static void add(const void* address, const std::string& file, bool of_program);

  /// Called where the process ends, such as by a signal handler: records the innermost library that this thread is in
  /// as the cause, once.
  static void blame_this_thread() noexcept;

  /// The file of that library; empty: not known.
  static std::string culprit();
  /// For the next process that is forked.
  static void forget_culprit();
  /// The files of libraries that did not come with the program.
  static std::vector<std::string> of_others();
};

}  // namespace lacuna

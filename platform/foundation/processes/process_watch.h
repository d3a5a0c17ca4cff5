#pragma once

#include "foundation/processes/floating_point.h"

#include <lacuna/error.h>

#include <string>
#include <vector>

namespace lacuna {

/// A call of a plugin changed the process.
class ProcessChanged : public Error {
 public:
  /// `deed`: "describe changed the current folder (/tmp), which other code relies on".
  explicit ProcessChanged(const std::string& deed);
  const std::string& deed() const { return deed_; }

 private:
  std::string deed_;
};

/// Plugins must leave the process as they find it: a change is set back after the call and reported.
class ProcessWatch {
 public:
  /// The current state is the one in which plugins must leave the process. Call it before the first of them is loaded;
  /// later calls change nothing.
  static void begin();
  /// For a program that carries out several commands: call it before a command, while no plugin is called.
  static void forget();
  /// From now on everything is compared after each call: for a process with one thread that only tries plugins, where
  /// microseconds do not matter. The current state is the one in which plugins must leave the process.
  static void look_closely();

  /// Changes by the call that has just returned, set back: "the locale (de_DE.UTF-8) and the current folder (/tmp)";
  /// empty: none. Arithmetic and locale are compared each time, the rest every 50 ms, so that a change by a slightly
  /// earlier call is found then.
  static std::string changed();
};

/// "A, B and C".
std::string enumerated(const std::vector<std::string>& changes);

/// Throws `ProcessChanged` where the call `what` changed the process; sets the change back.
void throw_if_process_changed(const char* what);
/// The same for this thread's floating-point arithmetic alone, in a few instructions where it is unchanged.
inline void throw_if_arithmetic_changed(const char* what) {
  if (!floating_point_is_usual()) [[unlikely]]
    throw_if_process_changed(what);
}

/// During its lifetime, a call of a plugin is in progress. However that ends, the process is restored.
class CallAftermath {
 public:
  explicit CallAftermath(const char* what) noexcept : what_(what) {}
  ~CallAftermath() {
    if (!checked_) set_back();
  }
  CallAftermath(const CallAftermath&) = delete;
  CallAftermath& operator=(const CallAftermath&) = delete;

  /// Throws `ProcessChanged` where the call that has returned changed the process.
  void check() {
    checked_ = true;
    throw_if_process_changed(what_);
  }

 private:
  static void set_back() noexcept;

  const char* what_;
  bool checked_ = false;
};

}  // namespace lacuna

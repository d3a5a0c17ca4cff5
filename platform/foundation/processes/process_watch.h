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

/// Plugins leave the process as they find it: what one of them changes is set back after its call and named.
class ProcessWatch {
 public:
  /// As the process is now, plugins are to leave it: before the first of them is loaded. Later calls change nothing.
  static void begin();
  /// In a program that carries out one command after another: before a command, while no plugin is called.
  static void forget();
  /// From now on everything is looked at after each call: in a process with one thread that only tries plugins, where
  /// microseconds do not matter. As the process is now, plugins are to leave it.
  static void look_closely();

  /// What the call that has just returned left changed, set back: "the locale (de_DE.UTF-8) and the current folder
  /// (/tmp)"; empty: nothing. Arithmetic and locale are looked at each time, the rest every 50 ms, and then found of
  /// calls shortly before as well.
  static std::string changed();
};

/// "A, B and C".
std::string enumerated(const std::vector<std::string>& changes);

/// Throws `ProcessChanged` where the call `what` left the process changed, which is set back.
void throw_if_process_changed(const char* what);
/// The same of this thread's floating-point arithmetic alone, in a few instructions where it is as usual.
inline void throw_if_arithmetic_changed(const char* what) {
  if (!floating_point_is_usual()) [[unlikely]]
    throw_if_process_changed(what);
}

/// While it lives, a call of a plugin is under way. However that ends, the process is afterwards as it was.
class CallAftermath {
 public:
  explicit CallAftermath(const char* what) noexcept : what_(what) {}
  ~CallAftermath() {
    if (!checked_) set_back();
  }
  CallAftermath(const CallAftermath&) = delete;
  CallAftermath& operator=(const CallAftermath&) = delete;

  /// Throws `ProcessChanged` where the call that has returned left the process changed.
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

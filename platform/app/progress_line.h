#pragma once

#include "fitting/progress.h"

#include <chrono>
#include <string>

namespace lacuna {

/// One live line on standard error: what is done, how far, how long still. Silent where standard
/// error is no terminal or the user asked for quiet. Wiped when it goes out of scope.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  /// For those who take a callback; the line must outlive it.
  ProgressCallback callback();

 private:
  bool live_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_{};
};

/// "segments of 0.5 s · 40 % · 1.2 s left"; without a time while none is known.
std::string progress_text(const Progress& progress);
/// Shows a line on the terminal of standard error, as much of it as fits, in the place of the last one.
void show_live_line(const std::string& line);
void wipe_live_line();
/// The first `width` characters of a text, which may take several bytes each.
std::string first_characters(const std::string& text, std::size_t width);

/// "3 min 20 s", "1.2 s".
std::string format_duration(double seconds);

}  // namespace lacuna

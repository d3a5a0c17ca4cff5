#pragma once

#include "foundation/work.h"

#include <chrono>
#include <string>

namespace lacuna {

/// Tells when a line of progress is due where lines cannot be wiped: at most one each interval, the first when one has
/// passed, so that short work prints none.
class LinePacer {
 public:
  using Clock = std::chrono::steady_clock;

  explicit LinePacer(Clock::duration interval, Clock::time_point begin = Clock::now())
      : interval_(interval), last_(begin) {}
  /// Whether a line is due; if so, the next interval begins.
  bool take(Clock::time_point now);

 private:
  Clock::duration interval_;
  Clock::time_point last_;
};

/// The process's own, 10 s: what it does one after the other shares the interval.
LinePacer& progress_pacer();
/// The same for lines that a program reads, 0.2 s.
LinePacer& json_progress_pacer();

/// What is done, how far, how long still, on standard error: one live line on a terminal, which is wiped when this goes
/// out of scope; elsewhere a plain line as often as `pacer` allows, or a line of JSON as often as `json_pacer` does
/// (`messages_are_json`). Silent where the user asked for quiet.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet, LinePacer& pacer = progress_pacer(), LinePacer& json_pacer = json_progress_pacer());
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  /// For those who take a callback; the line must outlive it.
  ProgressCallback callback();

 private:
  bool json_, live_, plain_;
  LinePacer &pacer_, &json_pacer_;
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

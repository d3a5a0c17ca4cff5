#pragma once

#include "foundation/processes/child_program.h"
#include "foundation/processes/process_source.h"
#include "foundation/processes/stop.h"

#include <lacuna/error.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lacuna {

/// Thrown where a program is late.
class TookTooLong : public Error {
 public:
  using Error::Error;
};

/// A program that is spoken to in lines of text: what is sent goes to its standard input, what it answers comes from
/// its standard output, and what it writes to standard error is kept. It sees the end of its input when this object,
/// or this process, ends. One thread. All that fails is an `Error` whose text continues "the program ...".
class ChildLines {
 public:
  using Clock = std::chrono::steady_clock;

  /// A moment `seconds` from now, at most some thirty years.
  static Clock::time_point in(double seconds);

  /// `stop` ends every wait for the program.
  ChildLines(const ProcessSource& source, const Stop& stop);
  /// Ends the program: by the end of its input, after a second by SIGTERM, then by SIGKILL.
  ~ChildLines();
  ChildLines(const ChildLines&) = delete;
  ChildLines& operator=(const ChildLines&) = delete;

  /// Sends a line, which has no newline of its own. Reads meanwhile, so that neither waits for the other. Throws
  /// `Interrupted`.
  void send(std::string_view line, Clock::time_point until);
  /// The next line, without its newline.
  std::string receive(Clock::time_point until);
  /// A line that has come without being asked for; empty where there is none.
  std::string unasked();
  bool has_ended();
  /// The last lines that it wrote to standard error; empty where it wrote none.
  std::string last_words();

 private:
  void wait(Clock::time_point until, std::string_view& unsent);
  void look_for_end();
  void read_some();
  bool take_line(std::string& line);
  [[noreturn]] void throw_lateness(bool reads_nothing) const;
  [[noreturn]] void throw_ending();

  Stop stop_;
  CapturedOutput errors_;
  int to_child_ = -1, from_child_ = -1;
  std::optional<ChildProgram> child_;
  std::string received_;
  std::size_t searched_ = 0;  ///< so many characters of `received_` are known to be of one line
  bool closed_ = false;       ///< its standard output
};

}  // namespace lacuna

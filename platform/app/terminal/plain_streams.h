#pragma once

#include <ostream>
#include <string>

namespace lacuna {

/// From now on, control characters that this process prints by `stdout`, `stderr`, `std::cout` or `std::cerr` arrive
/// as spaces, but for ends of lines and tabs: names in a stranger's files and databases must not steer the terminal.
/// Call it before there are threads.
void make_streams_plain();

/// Standard output as it was before: for data (JSON, CSV), which are passed on exactly.
std::ostream& exact_output();

/// Standard error as it was before: for what steers the terminal on purpose.
std::ostream& exact_errors();

/// What makes the text of one stream plain, in the pieces in which it comes. Lengths stay: the control characters of
/// two bytes (U+0080 to U+009F) become no-break spaces.
class PlainPieces {
 public:
  void make_plain(std::string& piece);

 private:
  bool after_c2_ = false;
};

}  // namespace lacuna

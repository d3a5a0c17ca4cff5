#pragma once

#include <chrono>
#include <optional>

struct sqlite3;

namespace lacuna {

/// Puts a connection into the state in which statements of a user, or of a page, may run, and back: what the read-only
/// file itself would let pass is refused, too (other files, pragmas that set something, extensions), and a statement
/// ends with SQLITE_INTERRUPT when the user interrupts the program or `longest` is over.
class ReadingOnly {
 public:
  explicit ReadingOnly(sqlite3* handle, std::optional<std::chrono::milliseconds> longest = std::nullopt);
  ~ReadingOnly();
  ReadingOnly(const ReadingOnly&) = delete;
  ReadingOnly& operator=(const ReadingOnly&) = delete;

  bool out_of_time() const;
  std::chrono::milliseconds longest() const { return longest_.value_or(std::chrono::milliseconds::max()); }

 private:
  sqlite3* handle_;
  std::optional<std::chrono::milliseconds> longest_;
  std::optional<std::chrono::steady_clock::time_point> end_;
};

}  // namespace lacuna

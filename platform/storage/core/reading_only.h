#pragma once

#include "foundation/processes/stop.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

struct sqlite3;

namespace lacuna {

/// Puts a connection into the state in which statements of a user, or of a page, may run, and back: what the read-only
/// file itself would let pass is refused, too (other files, pragmas that set something, extensions, functions that are
/// not on a list of SQLite's harmless ones), and a statement ends with SQLITE_INTERRUPT when `stop` is due or `longest`
/// is over. Within one function nothing can interrupt it, so values, texts and patterns have a
/// longest length, and functions that compare long texts with each other are replaced (bounded_functions.h). From the
/// first of these objects on, SQLite takes no more than `kMostQueryMemory` in this process.
class ReadingOnly {
 public:
  static constexpr std::int64_t kMostQueryMemory = std::int64_t{1} << 30;  ///< bytes
  static constexpr int kLongestValue = 128 << 20;                          ///< bytes of a value or a row

  ReadingOnly(sqlite3* handle, const Stop& stop, std::optional<std::chrono::milliseconds> longest = std::nullopt);
  ~ReadingOnly();
  ReadingOnly(const ReadingOnly&) = delete;
  ReadingOnly& operator=(const ReadingOnly&) = delete;

  const Stop& stop() const { return stop_; }
  bool out_of_time() const;
  std::chrono::milliseconds longest() const { return longest_.value_or(std::chrono::milliseconds::max()); }

 private:
  sqlite3* handle_;
  Stop stop_;
  std::optional<std::chrono::milliseconds> longest_;
  std::optional<std::chrono::steady_clock::time_point> end_;
  std::vector<std::pair<int, int>> limits_;  ///< those of the connection before, by their numbers in SQLite
};

}  // namespace lacuna

#pragma once

#include <filesystem>

namespace lacuna {

/// Who may only read a database leaves the empty files of its write-ahead log behind, which SQLite takes away when the
/// last connection that may write is closed. This opens such a connection at its end where there was no log at its
/// beginning and what there is then is empty; nothing is written. Must outlive the connections that read.
class LogLeft {
 public:
  explicit LogLeft(const std::filesystem::path& database);
  ~LogLeft();
  LogLeft(const LogLeft&) = delete;
  LogLeft& operator=(const LogLeft&) = delete;

 private:
  std::filesystem::path database_;
  bool was_there_;
};

}  // namespace lacuna

#pragma once

#include "storage/files/file_marks.h"
#include "storage/files/log_content.h"

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <string>

struct sqlite3;

namespace lacuna {

/// Tells whether the file of a connection that writes still holds that database. Another program can copy a file over
/// it or cut it, which SQLite does not notice: it would go on with pages of both. Only checkpoints write to the file,
/// and what they write has a mark of the log beside it (log_content.h). The file is looked into only after its size
/// or its time has changed. As long as this object lives, the log is brought into the file only where the file is
/// found to be its own; otherwise as SQLite does it.
class ContentWatch {
 public:
  /// From now on; the database has its first mark.
  ContentWatch(std::filesystem::path file, sqlite3* handle);
  ~ContentWatch();
  ContentWatch(const ContentWatch&) = delete;
  ContentWatch& operator=(const ContentWatch&) = delete;

  /// Once it is not, it never is again.
  bool is_own();
  /// Whether what SQLite reads now comes from what it read last by commits of ours, here or in other processes, and not
  /// from another program that brought other content in by SQLite itself (`.restore`).
  bool is_continued();
  /// This connection has committed with this mark.
  void committed(std::string mark) { go_on_to(std::move(mark)); }

 private:
  /// What the system says of a file without reading it.
  struct Stamp {
    std::int64_t size = -1, seconds = 0, nanoseconds = 0;
    bool operator==(const Stamp&) const = default;
  };
  Stamp stamp() const;
  Marks marks_there() const;
  bool marks_follow(const Marks& marks, std::uint32_t frames_in_file) const;
  bool marks_fit_without_log(const Marks& marks) const;
  bool others_committed() const;
  bool looks_own();
  bool comes_after_latest(const LogMark& now) const;
  void go_on_to(std::string mark);

  std::filesystem::path file_, log_;
  sqlite3* handle_;
  std::uint32_t page_size_, page_of_mark_;
  Stamp stamp_;         ///< when the file was last found to be its own
  Marks seen_;          ///< then
  int version_ = 0;     ///< then: a number that another connection's commit changes
  std::string latest_;  ///< mark that was read or committed
  Marks earlier_;       ///< than that one
  bool own_ = true;
};

}  // namespace lacuna

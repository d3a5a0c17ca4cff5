#pragma once

#include <lacuna/time_series.h>

#include "storage/database.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct sqlite3;

namespace lacuna {

/// Robots in motion: a trial of a run simulated again, for the pages to show. Poses are series of the channels
/// `body.x`, `.y`, `.z` (m, of the body frame's origin in the world) and `body.qw`, `.qx`, `.qy`, `.qz` (body to
/// world).
struct ReplayRecord {
  std::string experiment;
  std::int64_t run = 0;
  std::int64_t trial = 0;  ///< number within the run
  std::int64_t pass = 0;   ///< whose best model it is
  std::int64_t model = 0;
  std::string robot;                                       ///< `canonical_text` of the model's
  std::string target_robot = {};                           ///< of the target's; empty: it is not shown
  std::vector<std::pair<std::string, TimeSeries>> traces;  ///< "model", "target": poses; "predicted", "measured"
};

/// A database with what the pages of a report or of the server show besides what a user's file has: tables
/// `page_about`, `page_note`, `page_view`, `page_replay`, `page_replay_trace`. For a report it also gets the content of
/// the file and is kept as bytes. One thread at a time. Throws `Error`.
class PageDatabase {
 public:
  /// In memory.
  PageDatabase();
  /// In a new file, which other connections can attach.
  explicit PageDatabase(const std::filesystem::path& file);
  PageDatabase(const PageDatabase&) = delete;
  PageDatabase& operator=(const PageDatabase&) = delete;
  ~PageDatabase();

  /// Copies all tables and views, without the states of checkpoints. If the file has more than `most_bytes`, models and
  /// tests that are no pass's best are left out with their scores, then series, the oldest first; each
  /// is told by a note.
  void copy(const Database& source, std::size_t most_bytes);
  void add_about(const std::string& name, const std::string& value);
  void add_note(const std::string& sentence);
  void add(const ReplayRecord& replay);
  bool has_replay(std::int64_t run, std::int64_t trial, std::int64_t model) const;
  std::int64_t replays() const;
  std::size_t size() const;
  /// As a database file.
  std::vector<std::byte> bytes() const;

 private:
  void open(const char* name);
  void execute(const std::string& sql) const;
  std::int64_t number(const std::string& sql) const;
  sqlite3* handle_ = nullptr;
};

}  // namespace lacuna

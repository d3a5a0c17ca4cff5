#pragma once

#include <lacuna/time_series.h>

#include "storage/core/database.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lacuna {

/// Robots in motion: a trial of a run simulated again, for the pages to show. Poses are series of the channels
/// `body.x`, `.y`, `.z` (m, of the body frame's origin in the world) and `body.qw`, `.qx`, `.qy`, `.qz` (body to
/// world).
struct ReplayRecord {
  std::string experiment;
  std::string identity;  ///< of the run, whatever file it is in
  std::int64_t run = 0;
  std::int64_t trial = 0;  ///< number within the run
  std::int64_t pass = 0;   ///< whose best model it is
  std::int64_t model = 0;
  std::string robot;                                       ///< `canonical_text` of the model's
  std::string target_robot = {};                           ///< of the target's; empty: it is not shown
  std::vector<std::pair<std::string, TimeSeries>> traces;  ///< "model", "target": poses; "model contacts", "target
                                                           ///< contacts": a channel a body, positive while it touches
                                                           ///< the ground; "predicted", "measured"
};

/// A database with what the pages of a report or of the server show besides what a user's file has: tables
/// `page_about`, `page_note`, `page_view`, `page_run` (how many models and tests a run has of which a report has a
/// selection), `page_replay`, `page_replay_trace`. For a report it also gets the content of the file and is kept as
/// bytes. One thread at a time. Throws `Error`.
class PageDatabase {
 public:
  /// In memory.
  PageDatabase();
  /// In a new file, which other connections can attach.
  explicit PageDatabase(const std::filesystem::path& file);
  PageDatabase(const PageDatabase&) = delete;
  PageDatabase& operator=(const PageDatabase&) = delete;

  /// Copies all tables and views, without the states of checkpoints and without the folders of files. If that takes
  /// more than `most_bytes`, models and tests that are no pass's best are left out with their scores, of the oldest
  /// runs first, then series, the oldest first; each is told by a note.
  void copy(const Database& source, std::size_t most_bytes);
  void add_about(const std::string& name, const std::string& value);
  void add_note(const std::string& sentence);
  /// Returns its key. At a fault nothing of it is kept.
  std::int64_t add(const ReplayRecord& replay);
  /// The key of what was added for a trial of a run.
  std::optional<std::int64_t> find_replay(const std::string& identity, std::int64_t trial, std::int64_t model) const;
  std::size_t size() const;
  /// As a database file.
  std::vector<std::byte> bytes() const;

 private:
  explicit PageDatabase(Database database);
  Database database_;
};

}  // namespace lacuna

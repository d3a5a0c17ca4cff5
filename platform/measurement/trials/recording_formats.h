#pragma once

#include <lacuna/recording_format.h>

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// Formats of recordings other than CSV, passed in by code that knows plugins (evaluation/recording_files.h). A null
/// pointer: every file is CSV.
class RecordingFormats {
 public:
  virtual ~RecordingFormats() = default;

  /// Whether one of them reads files of that name.
  virtual bool reads(const std::filesystem::path& file) const = 0;
  /// Like `RecordingFormat`, for an existing file.
  virtual RecordingContents contents(const std::filesystem::path& file) const = 0;
  virtual ReadRows read(const std::filesystem::path& file, const std::vector<TableQuery>& queries) const = 0;
};

/// "/joint_states.position[shoulder]": the experiment's name of a table's column, "" without tables.
std::string column_path(const std::string& table, const std::string& column);

}  // namespace lacuna

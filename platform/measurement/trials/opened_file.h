#pragma once

#include "foundation/name_index.h"
#include "measurement/csv/csv_format.h"
#include "measurement/csv/file_report.h"
#include "measurement/trials/recording_formats.h"
#include "measurement/trials/trial_builder.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lacuna {

/// A table whose columns are known: a CSV file, or a table in a file of another format.
struct OpenedFile {
  std::filesystem::path path;
  FileReport report;
  std::string time_column;
  std::string time_unit;
  Encoding time_encoding;
  std::vector<std::string> only;  ///< the columns to be taken from it; empty: those that are requested
  std::string text = {};          ///< of a CSV file
  CsvFormat format = {};
  NameIndex columns = {};              ///< of the format's names
  std::string run = {};                ///< of a CSV file with several side by side (csv_runs.h); empty: the whole file
  std::vector<std::string> runs = {};  ///< of a CSV file
  bool shares_clock = false;           ///< all runs of a CSV file have one column of times
  std::optional<std::string> table = {};  ///< of another format: the table's name, empty where a file is one
  bool has_own_clock = false;             ///< the format knows its time, in s, since 1970 or since a start
  bool is_found = false;                  ///< a further table of its file, named only by whole paths
  std::vector<std::string> paths = {};    ///< of all columns of the file, where it has tables
  std::vector<std::size_t> given = {};    ///< which of the requested columns it has
  std::set<std::string> told = {};        ///< columns reported as missing

  /// A column's name within the table.
  std::string own_name(const std::string& column) const;
  std::size_t count(const std::string& column) const { return columns.count(own_name(column)); }
  bool has(const std::string& column) const { return count(column) > 0; }
  bool is_named(const std::string& column) const;
};

/// A recording with all of its tables open.
struct OpenedRecording {
  MeasuredFile file;  ///< its `with` has an entry for each table except the first
  std::vector<OpenedFile> tables;

  bool has_problems() const;
};

/// Opens the files of a recording. Of a file with tables the first is the one that the experiment names, else that of
/// the first sensor's column; the others of that file, which share its clock, follow where the `wanted` columns name
/// them.
OpenedRecording open_recording(const RecordingSource& source, const RecordingPlan& plan, const MeasuredFile& file,
                               const std::vector<std::string>& wanted, const RecordingFormats* formats);

}  // namespace lacuna

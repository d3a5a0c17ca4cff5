#pragma once

#include "measurement/csv/csv_format.h"
#include "measurement/trials/recording_formats.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// The beginning of a measured file with all of its columns, for guessing their roles.
struct FileSample {
  std::filesystem::path path;
  std::string run = {};  ///< of a file with several side by side (csv_runs.h); empty: the whole file
  CsvFormat format;
  /// One per column name: up to some ten thousand values; NaN where a cell is not a number.
  std::vector<std::vector<double>> columns;
  std::vector<double> numeric_share;  ///< of the cells that are not empty
  std::vector<bool> in_si = {};       ///< columns without a known unit, assumed SI; empty: none

  /// "pendulum.csv", "pendulum.csv[Run #2]"
  std::string label() const;
  /// Index of a column, or -1.
  int find(const std::string& name) const;
  bool is_numeric(std::size_t column) const { return numeric_share[column] > 0.5; }
  bool is_in_si(std::size_t column) const { return column < in_si.size() && in_si[column]; }
  /// Line for messages about its columns: its first line, if it has lines.
  int first_place() const { return format.header_line > 0 ? 1 : 0; }
};

/// Throws `BadInput` for a file that is readable neither as CSV nor by one of the other `formats`. Of a file with
/// several tables, which have their own clocks, the columns are those of the one with most joint positions, and those
/// of the others at its times.
FileSample sample_file(const std::filesystem::path& path, const RecordingFormats* formats = nullptr);

/// For files with several runs side by side, or with runs of other names, a sample for each run of each file, with the
/// columns of that run's table; else the samples as they are.
std::vector<FileSample> samples_of_runs(std::vector<FileSample> samples);

}  // namespace lacuna

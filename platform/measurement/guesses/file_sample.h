#pragma once

#include "measurement/csv/csv_format.h"
#include "measurement/trials/recording_formats.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// The beginning of a measured file, all columns of it, to guess from what they are.
struct FileSample {
  std::filesystem::path path;
  std::string run = {};  ///< of a file with several side by side (csv_runs.h); empty: all of it
  CsvFormat format;
  /// One a column name: up to some ten thousand values; NaN where a cell is no number.
  std::vector<std::vector<double>> columns;
  std::vector<double> numeric_share;  ///< of the cells that are not empty
  std::vector<bool> in_si = {};       ///< columns without a unit that is known, but SI; empty: none

  /// "pendulum.csv", "pendulum.csv[Run #2]"
  std::string label() const;
  /// Index of a column, or -1.
  int find(const std::string& name) const;
  bool is_numeric(std::size_t column) const { return numeric_share[column] > 0.5; }
  bool is_in_si(std::size_t column) const { return column < in_si.size() && in_si[column]; }
  /// Where what is wrong with its columns is said: its first line, if it has lines.
  int first_place() const { return format.header_line > 0 ? 1 : 0; }
};

/// Throws `BadInput` for a file that is readable neither as CSV nor by one of the other `formats`. Of a file with
/// several tables, which have clocks of their own, the columns are those of the one with most joint positions, and the
/// others' as they are at its times.
FileSample sample_file(const std::filesystem::path& path, const RecordingFormats* formats = nullptr);

/// Of files with several runs side by side, or with runs of other names, a sample for each run of each file, with the
/// columns of that run as its table has them; else the samples as they are.
std::vector<FileSample> samples_of_runs(std::vector<FileSample> samples);

}  // namespace lacuna

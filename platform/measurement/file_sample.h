#pragma once

#include "measurement/csv_format.h"

#include <filesystem>
#include <string>
#include <vector>

namespace lacuna {

/// The beginning of a measured file, all columns of it, to guess from what they are.
struct FileSample {
  std::filesystem::path path;
  CsvFormat format;
  /// One a column name: up to some ten thousand values; NaN where a cell is no number.
  std::vector<std::vector<double>> columns;
  std::vector<double> numeric_share;  ///< of the cells that are not empty

  /// Index of a column, or -1.
  int find(const std::string& name) const;
  bool is_numeric(std::size_t column) const { return numeric_share[column] > 0.5; }
};

/// Throws `BadInput` for a file that is not readable as CSV.
FileSample sample_file(const std::filesystem::path& path);

}  // namespace lacuna

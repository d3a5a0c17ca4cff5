#pragma once

#include "measurement/csv/csv_format.h"
#include "measurement/csv/file_report.h"

#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A column of numbers that is requested from a file.
struct WantedColumn {
  std::string name;
  bool may_be_missing = true;  ///< whether empty cells and NaN are missing samples (allowed), or a problem
};

struct CsvQuery {
  std::string time_column;
  std::string trial_column;  ///< empty: the file is one trial
  std::vector<WantedColumn> columns;
  /// Column of fractions, added to the time stamps where these are whole seconds and it has a fraction in each row;
  /// empty: none.
  std::string fraction_column = {};
  double fraction_unit = 0.0;  ///< s
  /// For a file with runs side by side, which may have different lengths: rows with neither a time nor a value of the
  /// columns do not belong to the run. With a `shared_clock` all runs have the same times.
  bool has_other_runs = false;
  bool shared_clock = false;
};

/// Numbers of the requested columns, as written (no units applied), row by row.
struct CsvTable {
  double time_origin = 0.0;                  ///< to be added to `times`; see `TimeStampReader`
  bool dated = false;                        ///< time stamps are dates or times of day: `times` are in s
  double first_date = 0.0;                   ///< for those, the value of `times` at which the file's time begins
  bool has_fractions = false;                ///< the fraction column was added to `times`
  double period = 0.0;                       ///< s, period of times of day; 0: none
  std::vector<double> times;                 ///< column's unit
  std::vector<std::vector<double>> columns;  ///< as in the query; NaN where the file has no value
  std::vector<int> lines;                    ///< line of each row in the file
  std::vector<int> trials;                   ///< index into `trial_names` of each row; empty without a trial column
  std::vector<std::string> trial_names;      ///< values of the trial column, in the order of their first rows
};

/// Reads the rows below the header in one pass. Rows with a wrong number of cells, text instead of a number,
/// infinities, and missing time stamps are problems; an incomplete last line is left out with a note. The columns must
/// be in `format.names`.
CsvTable read_csv_table(std::string_view text, const CsvFormat& format, const CsvQuery& query, FileReport& report);

}  // namespace lacuna

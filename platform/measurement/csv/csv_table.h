#pragma once

#include "measurement/csv/csv_format.h"
#include "measurement/csv/file_report.h"

#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// A column of numbers that is wanted from a file.
struct WantedColumn {
  std::string name;
  bool may_be_missing = true;  ///< whether empty cells and NaN are missing samples, or a problem
};

struct CsvQuery {
  std::string time_column;
  std::string trial_column;  ///< empty: the file is one trial
  std::vector<WantedColumn> columns;
  /// Added to the time stamps where they are whole seconds and it has a part of a second in each row; empty: none.
  std::string fraction_column = {};
  double fraction_unit = 0.0;  ///< s
  /// Of a file with runs side by side, which need not be as long as each other: rows with neither a time nor a value of
  /// the columns are no rows of the run. With a `shared_clock` all runs have the same times.
  bool has_other_runs = false;
  bool shared_clock = false;
};

/// Numbers of the wanted columns, as written (no units applied), row by row.
struct CsvTable {
  double time_origin = 0.0;                  ///< to be added to `times`; see `TimeStampReader`
  bool dated = false;                        ///< time stamps are dates or times of day: `times` are in s
  double first_date = 0.0;                   ///< where they are, what of `times` the file's own time begins with
  bool has_fractions = false;                ///< the fraction column was added to `times`
  double period = 0.0;                       ///< s, after which times of day start again; 0: they do not
  std::vector<double> times;                 ///< column's unit
  std::vector<std::vector<double>> columns;  ///< as in the query; NaN where the file has no value
  std::vector<int> lines;                    ///< line of each row in the file
  std::vector<int> trials;                   ///< index into `trial_names` of each row; empty without a trial column
  std::vector<std::string> trial_names;      ///< values of the trial column, in the order of their first rows
};

/// Reads the rows below the header in one pass. Rows with the wrong number of cells, text where
/// a number should be, infinities, and time stamps that are missing are problems; a last line that
/// breaks off is left out with a note. The columns must be in `format.names`.
CsvTable read_csv_table(std::string_view text, const CsvFormat& format, const CsvQuery& query, FileReport& report);

}  // namespace lacuna

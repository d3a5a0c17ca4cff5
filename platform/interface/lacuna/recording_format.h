#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace lacuna {

/// The unit of a column that is in SI units by its format's convention, where its name does not determine the unit: the
/// position of a joint, rad or m.
inline constexpr const char* kSomeSiUnit = "SI";

/// A column of a table: the values at one path in each of its rows.
struct RecordedColumn {
  std::string name;  ///< within the table, such as "position[shoulder]" or "wrench.force.x"
  std::string unit;  ///< as in "rad/s", or `kSomeSiUnit`; empty: the file does not say
};

/// Rows with a common clock: a whole file, or a topic of it.
struct RecordedTable {
  std::string name;  ///< "/joint_states"; empty where a file is one table
  std::vector<RecordedColumn> columns;
  std::string time_column;  ///< the column of its time; empty: the format does not know it
};

/// A sentence about a recording. `line` counts from 1; 0: the whole file, as in formats without lines.
struct RecordingSentence {
  int line = 0;
  std::string text;  ///< where in the file, what, and what to do; without a full stop
};

/// The contents of a recording.
struct RecordingContents {
  std::vector<RecordedTable> tables;
  std::vector<RecordingSentence> remarks;   ///< notes on the readings, and on other content of the file
  std::vector<RecordingSentence> problems;  ///< with any of them the tables are invalid
};

/// The columns that are requested from a table.
struct TableQuery {
  std::string table;
  std::vector<std::string> columns;  ///< columns named by `contents`, each once
  std::size_t most_rows = std::numeric_limits<std::size_t>::max();
};

/// Numbers of the requested columns, as written, row by row. For a time with more digits than a double, such as
/// nanoseconds since 1970, a whole number is subtracted from each value: value = origin + number.
struct RecordedRows {
  std::vector<std::vector<double>> columns;  ///< as in the query, of equal lengths; NaN where a row has no value
  std::vector<double> origins;               ///< one a column
  std::vector<int> lines;                    ///< of each row; empty: the format has no lines
};

/// A recording that was read. Every command repeats its `doubts`: the data may be incomplete.
struct ReadRows {
  std::vector<RecordedRows> tables;  ///< as in the queries
  std::vector<RecordingSentence> remarks;
  std::vector<RecordingSentence> doubts;
  std::vector<RecordingSentence> problems;  ///< with any of them the numbers are invalid
};

/// Reads recordings of one format, `[target] files = ["run.mcap"]`. Const and shared by threads; the same file gives
/// the same rows. No other file is opened, none is written, and nothing in the file is executed. A violation of the
/// format is a problem with its place, never a crash. Memory is not allocated by a size that a file states but as data
/// are read, and `read` keeps only the requested columns.
class RecordingFormat {
 public:
  virtual ~RecordingFormat() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  /// File endings such as ".jsonl". Files with other endings are not read, whatever they contain.
  virtual std::vector<std::string> endings() const = 0;
  /// The tables and columns of a file, by its path. A column that begins late in a long file may be missing.
  virtual RecordingContents contents(const std::string& file) const = 0;
  /// The rows of some tables, in the order of the file, in one pass.
  virtual ReadRows read(const std::string& file, const std::vector<TableQuery>& queries) const = 0;
};

}  // namespace lacuna

#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace lacuna {

/// The unit of a column that is in SI units by its format's convention where its name does not tell which: the position
/// of a joint, rad or m.
inline constexpr const char* kSomeSiUnit = "SI";

/// A column of a table: what stands at one path in each of its rows.
struct RecordedColumn {
  std::string name;  ///< within the table, such as "position[shoulder]" or "wrench.force.x"
  std::string unit;  ///< as in "rad/s", or `kSomeSiUnit`; empty: the file does not say
};

/// Rows that share one clock: a whole file, or a topic of it.
struct RecordedTable {
  std::string name;  ///< "/joint_states"; empty where a file is one table
  std::vector<RecordedColumn> columns;
  std::string time_column;  ///< the one that is its time; empty: the format does not know
};

/// A sentence about a recording. `line` counts from 1; 0: the whole file, as in every format that has no lines.
struct RecordingSentence {
  int line = 0;
  std::string text;  ///< where in the file, what, and what to do; without its end
};

/// What may be asked of a recording.
struct RecordingContents {
  std::vector<RecordedTable> tables;
  std::vector<RecordingSentence> remarks;   ///< documented readings, and what else lies in the file
  std::vector<RecordingSentence> problems;  ///< with any of them the tables mean nothing
};

/// What is wanted of a table.
struct TableQuery {
  std::string table;
  std::vector<std::string> columns;  ///< of those that `contents` named, each once
  std::size_t most_rows = std::numeric_limits<std::size_t>::max();
};

/// Numbers of the wanted columns, as written, row by row. Of a time that has more digits than a double, such as
/// nanoseconds since 1970, a whole number is taken off each value: value = origin + number.
struct RecordedRows {
  std::vector<std::vector<double>> columns;  ///< as in the query, of equal lengths; NaN where a row has no value
  std::vector<double> origins;               ///< one a column
  std::vector<int> lines;                    ///< of each row; empty: the format has no lines
};

/// A recording, read. `doubts` are remarks that every command repeats: what was read may not be all.
struct ReadRows {
  std::vector<RecordedRows> tables;  ///< as in the queries
  std::vector<RecordingSentence> remarks;
  std::vector<RecordingSentence> doubts;
  std::vector<RecordingSentence> problems;  ///< with any of them the numbers mean nothing
};

/// Reads recordings of one format, `[target] files = ["run.mcap"]`. Const and shared by threads; the same file gives
/// the same rows. No other file is opened, none is written, and nothing of it is executed. What does not keep to the
/// format is a problem with its place, never a crash, and no memory is taken because a file says how much it needs:
/// memory goes with what is read, and `read` keeps no more than the columns that are wanted.
class RecordingFormat {
 public:
  virtual ~RecordingFormat() = default;

  /// One sentence for `lacuna plugins`.
  virtual std::string summary() const = 0;
  /// Endings of such files, ".jsonl". A file of another ending is none, whatever is in it.
  virtual std::vector<std::string> endings() const = 0;
  /// The tables and columns of a file, by its path. A column that begins late in a long file may be missing.
  virtual RecordingContents contents(const std::string& file) const = 0;
  /// The rows of some tables, in the order of the file, in one pass over it.
  virtual ReadRows read(const std::string& file, const std::vector<TableQuery>& queries) const = 0;
};

}  // namespace lacuna

#include "mat_file.h"

#include "mat_variables.h"

#include <lacuna/row_columns.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace lacuna::mat {
namespace {

constexpr std::uint64_t kMostColumns = 4096;  ///< of one array

/// Orientation of an array in the table: one sample per row, or one per column, as in a row vector.
struct Layout {
  bool is_transposed = false;
  std::uint64_t columns = 0;

  static Layout of(const MatArray& array, std::uint64_t samples) {
    if (array.rows == samples) return {false, array.columns};
    return {true, array.rows};
  }
};

bool has_samples(const MatArray& array, std::uint64_t samples) {
  return (array.rows == samples && array.columns <= kMostColumns) ||
         (array.columns == samples && array.rows <= kMostColumns);
}

/// "q" of a vector, "q(:,2)" of a matrix, as in MATLAB.
std::string column_name(const MatArray& array, const Layout& layout, std::uint64_t column) {
  if (layout.columns == 1) return array.path;
  const std::string number = std::to_string(column + 1);
  return array.path + (layout.is_transposed ? "(" + number + ",:)" : "(:," + number + ")");
}

/// The shape of an array if its longer side is time.
std::uint64_t length_of(const MatArray& array) { return std::max(array.rows, array.columns); }

bool names_time(const MatArray& array) {
  constexpr std::array<std::string_view, 7> kTimes = {"t", "time", "Time", "times", "tout", "timestamp", "timestamps"};
  const std::string_view last = std::string_view(array.path).substr(array.path.rfind('.') + 1);
  return std::min(array.rows, array.columns) == 1 && std::find(kTimes.begin(), kTimes.end(), last) != kTimes.end();
}

/// Number of samples of the array that is the time, else of most arrays, else the largest.
std::uint64_t samples_of(const std::vector<MatArray>& arrays) {
  std::map<std::uint64_t, int> counts;
  for (const MatArray& array : arrays) {
    if (names_time(array)) return length_of(array);
    if (length_of(array) > 1) ++counts[length_of(array)];
  }
  std::pair<int, std::uint64_t> most{0, 0};
  for (const auto& [samples, count] : counts) most = std::max(most, {count, samples});
  return most.second;
}

/// Lists the contents.
class ContentsVisitor : public MatVisitor {
 public:
  bool begin_array(const MatArray& array) override {
    arrays.push_back(array);
    return false;
  }
  void take_number(std::uint64_t, LongNumber) override {}
  void leave_out(const std::string& path, const std::string& reason) override {
    remarks.push_back({0, "`" + path + "` is left out: it " + reason});
  }

  std::vector<MatArray> arrays;
  std::vector<RecordingSentence> remarks;
};

/// Puts the numbers of requested columns into the table.
class RowsVisitor : public MatVisitor {
 public:
  RowsVisitor(std::uint64_t samples, const std::vector<TableQuery>& queries) : samples_(samples), queries_(queries) {
    for (const TableQuery& query : queries) columns_.emplace_back(query.columns.size());
  }

  bool begin_array(const MatArray& array) override {
    targets_.clear();
    array_ = array;
    if (!has_samples(array, samples_)) return false;
    layout_ = Layout::of(array, samples_);
    bool is_wanted = false;
    targets_.resize(static_cast<std::size_t>(layout_.columns));
    for (std::uint64_t column = 0; column < layout_.columns; ++column)
      is_wanted =
          find_targets(column_name(array, layout_, column), targets_[static_cast<std::size_t>(column)]) || is_wanted;
    return is_wanted;
  }

  /// Numbers arrive column by column of the array.
  void take_number(std::uint64_t index, LongNumber number) override {
    const std::uint64_t row = index % array_.rows, column = index / array_.rows;
    const std::uint64_t sample = layout_.is_transposed ? column : row;
    for (const Target& target : targets_[static_cast<std::size_t>(layout_.is_transposed ? row : column)])
      if (sample < target.most) target.numbers->add(number);
  }
  void leave_out(const std::string&, const std::string&) override {}

  ReadRows take() {
    ReadRows read;
    for (std::vector<NumberColumn>& columns : columns_) {
      RecordedRows& rows = read.tables.emplace_back();
      for (NumberColumn& column : columns) {
        rows.origins.push_back(column.origin());
        rows.columns.push_back(column.take());
      }
    }
    return read;
  }

 private:
  struct Target {
    NumberColumn* numbers = nullptr;
    std::size_t most = 0;
  };

  /// Of a name that occurs again only the first is read.
  bool find_targets(const std::string& name, std::vector<Target>& targets) {
    if (!seen_.insert(name).second) return false;
    for (std::size_t q = 0; q < queries_.size(); ++q)
      for (std::size_t c = 0; c < queries_[q].columns.size(); ++c)
        if (queries_[q].columns[c] == name) targets.push_back({&columns_[q][c], queries_[q].most_rows});
    return !targets.empty();
  }

  std::uint64_t samples_;
  const std::vector<TableQuery>& queries_;
  std::vector<std::vector<NumberColumn>> columns_;
  std::set<std::string> seen_;
  MatArray array_;
  Layout layout_;
  std::vector<std::vector<Target>> targets_;  ///< of each column of the array
};

RecordingContents contents_from(ContentsVisitor visitor) {
  RecordingContents contents;
  contents.remarks = std::move(visitor.remarks);
  const std::uint64_t samples = samples_of(visitor.arrays);
  ColumnNames names;
  for (const MatArray& array : visitor.arrays) {
    if (has_samples(array, samples)) {
      const Layout layout = Layout::of(array, samples);
      for (std::uint64_t column = 0; column < layout.columns; ++column)
        names.add_single(column_name(array, layout, column));
    } else if (length_of(array) > 1) {
      contents.remarks.push_back({0, "`" + array.path + "` is left out: it has " + std::to_string(array.rows) + " × " +
                                         std::to_string(array.columns) + " numbers, but the others have " +
                                         std::to_string(samples) + " samples"});
    }
  }
  if (const std::string repeated = names.repeated(); !repeated.empty()) contents.remarks.push_back({0, repeated});
  if (names.size() > 0) contents.tables.push_back({"", names.columns(), ""});
  return contents;
}

}  // namespace

RecordingContents contents_of(const std::string& path) {
  try {
    ContentsVisitor visitor;
    visit_variables(path, visitor);
    return contents_from(std::move(visitor));
  } catch (const BadFile& bad) {
    RecordingContents contents;
    contents.problems.push_back({0, bad.what()});
    return contents;
  }
}

ReadRows rows_of(const std::string& path, const std::vector<TableQuery>& queries) {
  try {
    ContentsVisitor contents;
    visit_variables(path, contents);
    RowsVisitor rows(samples_of(contents.arrays), queries);
    visit_variables(path, rows);
    return rows.take();
  } catch (const BadFile& bad) {
    ReadRows read;
    read.problems.push_back({0, bad.what()});
    return read;
  }
}

}  // namespace lacuna::mat

#pragma once

#include <lacuna/recording_format.h>
#include <lacuna/value_tree.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace lacuna {

/// The columns of a table in the order in which they first occur, each once. Columns without a name are left out,
/// because they cannot be requested.
class ColumnNames {
 public:
  static constexpr std::size_t kMostColumns = 4096;

  /// False: there are already too many columns.
  bool add(std::string_view name, std::string_view unit = {}) {
    if (name.empty() || known_.contains(std::string(name))) return true;
    if (columns_.size() == kMostColumns) return false;
    known_.emplace(name);
    columns_.push_back({std::string(name), std::string(unit)});
    return true;
  }
  /// As `add`, in a format that has each column only once: remembers a name that occurs again.
  void add_single(std::string_view name) {
    if (has(name)) repeated_.emplace(name);
    add(name);
  }
  bool has(std::string_view name) const { return known_.contains(std::string(name)); }
  /// "column `q` occurs more than once; the first one is used"; empty where no name occurred again.
  std::string repeated() const {
    if (repeated_.empty()) return {};
    const std::string others =
        repeated_.size() == 1 ? "" : " (and " + std::to_string(repeated_.size() - 1) + " other names)";
    return "column `" + *repeated_.begin() + "`" + others + " occurs more than once; the first one is used";
  }
  std::size_t size() const { return columns_.size(); }
  std::vector<RecordedColumn> columns() const { return columns_; }

 private:
  std::unordered_set<std::string> known_;
  std::set<std::string> repeated_;
  std::vector<RecordedColumn> columns_;
};

/// The numbers of one column. Where the first is large, like a time since 1970, its whole number becomes the origin, so
/// that all numbers keep their digits.
class NumberColumn {
 public:
  void add_missing() { values_.push_back(std::numeric_limits<double>::quiet_NaN()); }
  void add(LongNumber number) {
    add_missing();
    set_last(number);
  }
  /// Nothing where the last one is already known.
  void set_last(LongNumber number) {
    if (!std::isnan(values_.back())) return;
    if (!is_begun_ && (number.whole >= kLarge || number.whole <= -kLarge)) origin_ = number.whole;
    is_begun_ = true;
    values_.back() = number.part;  // which keeps the sign of zero
    if (number.whole == origin_) return;
    std::int64_t since = 0;
    const bool is_far = __builtin_sub_overflow(number.whole, origin_, &since);
    values_.back() += is_far ? static_cast<double>(number.whole) - origin() : static_cast<double>(since);
  }
  double origin() const { return static_cast<double>(origin_); }
  std::vector<double> take() { return std::move(values_); }

 private:
  static constexpr std::int64_t kLarge = 1'000'000;

  std::vector<double> values_;
  std::int64_t origin_ = 0;
  bool is_begun_ = false;
};

/// Collects the numbers of the requested columns row by row.
class RowColumns {
 public:
  explicit RowColumns(const TableQuery& query) : names_(query.columns), most_rows_(query.most_rows) {
    for (std::size_t i = 0; i < names_.size(); ++i) places_.emplace(names_[i], i);
    columns_.resize(names_.size());
  }
  RowColumns(RowColumns&&) = default;  // keys of `places_` are views of strings, which do not move with it
  RowColumns(const RowColumns&) = delete;

  bool is_full() const { return count_ >= most_rows_; }
  /// Begins a row without numbers. `line`: 0 in formats without lines.
  void begin_row(int line = 0) {
    for (NumberColumn& column : columns_) column.add_missing();
    if (line > 0) lines_.push_back(line);
    ++count_;
  }
  /// Adds a number to the row; ignored for columns that are not requested or already have a number.
  void put(std::string_view name, LongNumber number) {
    const auto place = places_.find(name);
    if (place != places_.end()) columns_[place->second].set_last(number);
  }
  RecordedRows take() {
    RecordedRows rows;
    rows.lines = std::move(lines_);
    for (NumberColumn& column : columns_) {
      rows.origins.push_back(column.origin());
      rows.columns.push_back(column.take());
    }
    return rows;
  }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string_view, std::size_t> places_;  ///< of `names_`
  std::size_t most_rows_, count_ = 0;
  std::vector<NumberColumn> columns_;
  std::vector<int> lines_;
};

}  // namespace lacuna

#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lacuna {

/// A prepared statement whose parameters `?` are given in order. NaN becomes NULL on the way in,
/// NULL becomes NaN on the way out. Only for sources of storage/.
class Statement {
 public:
  Statement(const Database& database, const char* sql);

  /// Binds all parameters, from the first.
  template <class... Values>
  Statement& with(const Values&... values) {
    restart();
    int index = 0;
    (bind(++index, values), ...);
    return *this;
  }

  /// To the next row; false after the last.
  bool step();
  /// For statements without rows; afterwards the statement can be used again.
  void run();
  template <class... Values>
  void run_with(const Values&... values) {
    with(values...).run();
  }

  /// The same one after the other, from 1: from the beginning, a value, that of another row's column as it is.
  void begin_again() { restart(); }
  template <class Value>
  void give(int index, const Value& value) {
    bind(index, value);
  }
  void take(int index, Statement& row, int column);

  std::int64_t integer(int column) { return statement_.getColumn(column).getInt64(); }
  int number(int column) { return statement_.getColumn(column).getInt(); }
  std::optional<int> optional_number(int column) { return null(column) ? std::nullopt : std::optional(number(column)); }
  bool flag(int column) { return integer(column) != 0; }
  double real(int column);
  std::string text(int column) { return statement_.getColumn(column).getString(); }
  std::vector<std::byte> bytes(int column);
  /// Adds what identifies the value of a column to `bytes`: its type, its length and its bits.
  void append_bits(int column, std::string& bytes);
  int columns() const { return statement_.getColumnCount(); }
  bool null(int column) { return statement_.getColumn(column).isNull(); }

 private:
  void restart();
  void bind(int index, std::int64_t value);
  void bind(int index, int value) { bind(index, std::int64_t{value}); }
  void bind(int index, bool value) { bind(index, std::int64_t{value ? 1 : 0}); }
  void bind(int index, double value);
  void bind(int index, const std::string& value);
  void bind(int index, const char* value) { bind(index, std::string(value)); }
  void bind(int index, std::span<const std::byte> blob);
  void bind_null(int index);
  template <class Table>
  void bind(int index, Id<Table> id) {
    bind(index, id.value);
  }
  template <class Value>
  void bind(int index, const std::optional<Value>& value) {
    value ? bind(index, *value) : bind_null(index);
  }

  const Database& database_;
  SQLite::Statement statement_;
};

/// The name of a table or view, which may be a stranger's, as it stands in SQL.
std::string name_in_sql(const std::string& name);

}  // namespace lacuna

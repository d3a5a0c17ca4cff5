#include "storage/queries/query.h"

#include "foundation/text/problem.h"
#include "storage/core/reading_only.h"
#include "storage/core/storage_error.h"
#include "storage/files/callback.h"
#include "storage/traces/trace_samples.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <memory>
#include <string_view>

namespace lacuna {
namespace {

SourceLocation place_in(const std::string& sql, std::size_t offset) {
  const std::string_view before = std::string_view(sql).substr(0, offset);
  const auto line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t start_of_line = line == 1 ? 0 : before.rfind('\n') + 1;
  return {"SQL", line, static_cast<int>(offset - start_of_line) + 1};
}

std::vector<std::string> names_of_tables(sqlite3* handle) {
  std::vector<std::string> names;
  const auto take = [](void* list, int, char** values, char**) {
    return called_back([&] { static_cast<std::vector<std::string>*>(list)->emplace_back(values[0]); });
  };
  sqlite3_exec(handle, "SELECT name FROM sqlite_master WHERE type IN ('view', 'table') ORDER BY name", take, &names,
               nullptr);
  return names;
}

std::string advice(sqlite3* handle, const std::string& message) {
  static constexpr std::string_view kNoTable = "no such table: ";
  static constexpr std::string_view kNoFunction = "not authorized to use function: ";
  static constexpr std::string_view kNoModule = "no such module: ";
  if (message.starts_with(kNoTable)) {
    const std::string near = did_you_mean(message.substr(kNoTable.size()), names_of_tables(handle));
    return near.empty() ? "; to list the views: `lacuna sql FILE --views`" : near;
  }
  if (message.starts_with(kNoFunction))
    return "; a query may use SQLite's functions for numbers, texts, times, JSON, aggregates and windows";
  if (message.starts_with(kNoModule)) return "; of table modules only json_each and json_tree are allowed";
  if (message == "string or blob too big")
    return fmt::format("; a value may have at most {} MB", ReadingOnly::kLongestValue / 1'000'000);
  if (message.starts_with("not authorized") || message == "authorization denied") return "; only reading is allowed";
  return "";
}

bool is_fault_of_sql(int primary_code) {
  switch (primary_code) {
    case SQLITE_ERROR:
    case SQLITE_AUTH:
    case SQLITE_SCHEMA:  // how a refusal ends when the tables had not been looked at before
    case SQLITE_READONLY:
    case SQLITE_TOOBIG:
    case SQLITE_MISMATCH: return true;
    default: return false;
  }
}

/// `start`: where in the text the failing statement begins.
[[noreturn]] void fail(const Database& database, const std::string& sql, std::size_t start,
                       const ReadingOnly& reading) {
  sqlite3* handle = database.handle();
  const int code = sqlite3_extended_errcode(handle);
  const int offset = sqlite3_error_offset(handle);
  const std::string message = sqlite3_errmsg(handle);
  if (reading.out_of_time())
    throw_problem({}, fmt::format("the query took longer than {} s and was stopped",
                                  std::chrono::duration<double>(reading.longest()).count()));
  if ((code & 0xff) == SQLITE_INTERRUPT) throw Interrupted("interrupted; the query was stopped");
  if ((code & 0xff) == SQLITE_NOMEM)
    throw_problem(
        {}, fmt::format("the query needs more than {} MB of memory and was stopped; select fewer or shorter values",
                        ReadingOnly::kMostQueryMemory / 1'000'000));
  if (!is_fault_of_sql(code & 0xff)) throw_storage_error(database.file(), code, message);
  const std::size_t place = start + (offset > 0 ? static_cast<std::size_t>(offset) : 0);
  throw BadInput({Problem{place_in(sql, std::min(place, sql.size())), message + advice(handle, message)}});
}

Cell cell_of(sqlite3_stmt* statement, int column) {
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER: return std::int64_t{sqlite3_column_int64(statement, column)};
    case SQLITE_FLOAT: return sqlite3_column_double(statement, column);
    case SQLITE_TEXT: {
      const auto* first = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
      if (first == nullptr) return std::string();  // no memory: `has_no_memory`
      return std::string(first, static_cast<std::size_t>(sqlite3_column_bytes(statement, column)));
    }
    case SQLITE_BLOB: return Blob{static_cast<std::size_t>(sqlite3_column_bytes(statement, column))};
    default: return std::monostate{};
  }
}

using StatementHandle = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

/// False at a fault, whose description the connection holds.
bool run_one(sqlite3_stmt* statement, QueryOutput& output) {
  const int count = sqlite3_column_count(statement);
  std::vector<std::string> columns;
  columns.reserve(static_cast<std::size_t>(count));
  for (int column = 0; column < count; ++column) columns.emplace_back(sqlite3_column_name(statement, column));
  // The first row comes before anything is written: many faults show only when a statement runs.
  int result = sqlite3_step(statement);
  if (result != SQLITE_ROW && result != SQLITE_DONE) return false;
  output.begin(columns);
  std::vector<Cell> cells(columns.size());
  for (; result == SQLITE_ROW; result = sqlite3_step(statement)) {
    for (int column = 0; column < count; ++column) cells[static_cast<std::size_t>(column)] = cell_of(statement, column);
    if (has_no_memory(statement)) return false;
    output.row(cells);
  }
  if (result != SQLITE_DONE) return false;
  output.end();
  return true;
}

}  // namespace

bool has_no_memory(sqlite3_stmt* statement) {
  return (sqlite3_errcode(sqlite3_db_handle(statement)) & 0xff) == SQLITE_NOMEM;
}

void for_each_statement(const Database& database, const std::string& sql, const ReadingOnly& reading,
                        const std::function<bool(sqlite3_stmt*)>& run) {
  const char* const text = sql.c_str();
  bool any = false;
  for (const char* rest = text; *rest != '\0';) {
    reading.stop().throw_if_due();
    const auto start = static_cast<std::size_t>(rest - text);
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(database.handle(), rest, -1, &prepared, &rest) != SQLITE_OK)
      fail(database, sql, start, reading);
    const StatementHandle statement(prepared, &sqlite3_finalize);
    if (!statement) continue;  // a comment or nothing between two semicolons
    any = true;
    if (!run(statement.get())) fail(database, sql, start, reading);
  }
  if (!any)
    throw BadInput({Problem{place_in(sql, 0), "there is no statement; try \"SELECT * FROM error_by_revision\""}});
}

void run_queries(const Database& database, const std::string& sql, QueryOutput& output) {
  const TraceSamples traces(database);
  const ReadingOnly reading(database.handle(), database.stop());
  for_each_statement(database, sql, reading, [&](sqlite3_stmt* statement) { return run_one(statement, output); });
}

std::vector<ViewDescription> view_descriptions() {
  static constexpr std::string_view kComment = "-- ";
  static constexpr std::string_view kExample = "-- example: ";
  static constexpr std::string_view kView = "CREATE VIEW ";
  std::vector<ViewDescription> views;
  ViewDescription next;
  for (std::size_t at = 0; at < schema_views().size();) {
    const std::size_t end = std::min(schema_views().find('\n', at), schema_views().size());
    const std::string line = schema_views().substr(at, end - at);
    at = end + 1;
    if (line.starts_with(kExample)) {
      next.example = line.substr(kExample.size());
    } else if (line.starts_with(kComment)) {
      next.sentence += (next.sentence.empty() ? "" : " ") + line.substr(kComment.size());
    } else if (line.starts_with(kView)) {
      next.name = line.substr(kView.size(), line.find(' ', kView.size()) - kView.size());
      views.push_back(next);
    }
    if (!line.starts_with(kComment)) next = {};
  }
  return views;
}

}  // namespace lacuna

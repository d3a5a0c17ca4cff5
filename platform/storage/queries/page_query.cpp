#include "storage/queries/page_query.h"

#include "storage/core/reading_only.h"
#include "storage/traces/trace_samples.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <algorithm>

namespace lacuna {
namespace {

std::string quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

void add_pages(Database& database, const std::filesystem::path& pages) {
  database.execute("PRAGMA query_only = OFF; ATTACH " + quoted(pages.string()) +
                   " AS pages;"
                   "CREATE TEMP VIEW samples AS SELECT trace.id AS trace, sample.sample, sample.time, sample.channel, "
                   "sample.value FROM trace, trace_samples(trace.id) AS sample; PRAGMA query_only = ON");
}

int bind_value(sqlite3_stmt* statement, int index, const PageCell& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return sqlite3_bind_int64(statement, index, *integer);
  if (const auto* number = std::get_if<double>(&value)) return sqlite3_bind_double(statement, index, *number);
  if (const auto* text = std::get_if<std::string>(&value))
    return sqlite3_bind_text(statement, index, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
  return sqlite3_bind_null(statement, index);
}

/// The result is empty if there is no memory; `has_no_memory` tells this case.
PageCell page_cell(sqlite3_stmt* statement, int column, bool sizes) {
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER: return std::int64_t{sqlite3_column_int64(statement, column)};
    case SQLITE_FLOAT: return sqlite3_column_double(statement, column);
    case SQLITE_TEXT: {
      const auto* first = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
      if (first == nullptr) return std::string();
      return std::string(first, static_cast<std::size_t>(sqlite3_column_bytes(statement, column)));
    }
    case SQLITE_BLOB: {
      if (sizes) return Blob{static_cast<std::size_t>(sqlite3_column_bytes(statement, column))};
      const auto* first = static_cast<const std::byte*>(sqlite3_column_blob(statement, column));
      if (first == nullptr) return std::vector<std::byte>{};
      return std::vector<std::byte>(first, first + sqlite3_column_bytes(statement, column));
    }
    default: return std::monostate{};
  }
}

std::size_t bytes_of(const PageCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return sizeof cell + text->size();
  if (const auto* bytes = std::get_if<std::vector<std::byte>>(&cell)) return sizeof cell + bytes->size();
  return sizeof cell;
}

/// False at a fault, whose description the connection holds.
bool fill(sqlite3_stmt* statement, const PageQuery& query, PageTable& table) {
  const int count = sqlite3_column_count(statement);
  table = {};
  for (int column = 0; column < count; ++column) table.columns.emplace_back(sqlite3_column_name(statement, column));
  std::size_t bytes = 0;
  for (int result = sqlite3_step(statement);; result = sqlite3_step(statement)) {
    if (result != SQLITE_ROW) return result == SQLITE_DONE;
    if (table.rows.size() == query.most_rows || bytes > query.most_bytes) {
      table.cut = true;
      return true;
    }
    std::vector<PageCell>& row = table.rows.emplace_back();
    for (int column = 0; column < count; ++column)
      bytes += bytes_of(row.emplace_back(page_cell(statement, column, query.sizes)));
    if (has_no_memory(statement)) return false;
  }
}

}  // namespace

PageTable ask_for_page(const std::filesystem::path& database_file, const std::filesystem::path& pages,
                       const PageQuery& query, const Stop& stop) {
  Database database = Database::open_read_only(database_file, stop);
  const TraceSamples traces(database);
  add_pages(database, pages);
  const ReadingOnly reading(database.handle(), stop, query.longest);
  PageTable table;
  for_each_statement(database, query.sql, reading, [&](sqlite3_stmt* statement) {
    const int wanted = std::min(sqlite3_bind_parameter_count(statement), static_cast<int>(query.values.size()));
    for (int i = 0; i < wanted; ++i) bind_value(statement, i + 1, query.values[static_cast<std::size_t>(i)]);
    return fill(statement, query, table);
  });
  return table;
}

std::string stamp_of(const std::filesystem::path& database) {
  std::string stamp;
  for (const std::string& file : {database.string(), database.string() + "-wal"}) {
    struct stat state {};
    if (::stat(file.c_str(), &state) != 0) continue;
    if (state.st_size == 0) continue;  // a log that readers leave behind
    stamp += fmt::format("{}.{}.{}.{} ", state.st_ino, state.st_size, state.st_mtim.tv_sec, state.st_mtim.tv_nsec);
  }
  return stamp;
}

}  // namespace lacuna

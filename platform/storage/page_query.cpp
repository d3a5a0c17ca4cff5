#include "storage/page_query.h"

#include "foundation/problem.h"
#include "storage/reading_only.h"
#include "storage/storage_error.h"
#include "storage/trace_samples.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <memory>

namespace lacuna {
namespace {

using PagePrepared = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

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

[[noreturn]] void refuse(const Database& database, const ReadingOnly& reading, std::chrono::milliseconds longest) {
  sqlite3* const handle = database.handle();
  if (reading.out_of_time())
    throw_problem({}, fmt::format("the query takes longer than {} s and was ended", longest.count() / 1000));
  throw_problem({}, sqlite3_errmsg(handle));
}

int bind_value(sqlite3_stmt* statement, int index, const PageCell& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return sqlite3_bind_int64(statement, index, *integer);
  if (const auto* number = std::get_if<double>(&value)) return sqlite3_bind_double(statement, index, *number);
  if (const auto* text = std::get_if<std::string>(&value))
    return sqlite3_bind_text(statement, index, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
  return sqlite3_bind_null(statement, index);
}

PageCell page_cell(sqlite3_stmt* statement, int column) {
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER: return std::int64_t{sqlite3_column_int64(statement, column)};
    case SQLITE_FLOAT: return sqlite3_column_double(statement, column);
    case SQLITE_TEXT: return std::string(reinterpret_cast<const char*>(sqlite3_column_text(statement, column)), size);
    case SQLITE_BLOB: {
      const auto* first = static_cast<const std::byte*>(sqlite3_column_blob(statement, column));
      return size == 0 ? std::vector<std::byte>{} : std::vector<std::byte>(first, first + size);
    }
    default: return std::monostate{};
  }
}

/// False at a fault, whose description the connection holds.
bool fill(sqlite3_stmt* statement, std::size_t most_rows, PageTable& table) {
  const int count = sqlite3_column_count(statement);
  table = {};
  for (int column = 0; column < count; ++column) table.columns.emplace_back(sqlite3_column_name(statement, column));
  for (int result = sqlite3_step(statement);; result = sqlite3_step(statement)) {
    if (result != SQLITE_ROW) return result == SQLITE_DONE;
    if (table.rows.size() == most_rows) {
      table.cut = true;
      return true;
    }
    std::vector<PageCell>& row = table.rows.emplace_back();
    for (int column = 0; column < count; ++column) row.push_back(page_cell(statement, column));
  }
}

}  // namespace

PageTable ask_for_page(const std::filesystem::path& database_file, const std::filesystem::path& pages,
                       const PageQuery& query) {
  Database database = Database::open_read_only(database_file);
  const TraceSamples traces(database);
  add_pages(database, pages);
  const ReadingOnly reading(database.handle(), query.longest);
  PageTable table;
  bool any = false;
  for (const char* rest = query.sql.c_str(); *rest != '\0';) {
    sqlite3_stmt* made = nullptr;
    if (sqlite3_prepare_v2(database.handle(), rest, -1, &made, &rest) != SQLITE_OK)
      refuse(database, reading, query.longest);
    const PagePrepared statement(made, &sqlite3_finalize);
    if (!statement) continue;
    any = true;
    const int wanted = sqlite3_bind_parameter_count(made);
    for (int i = 0; i < std::min(wanted, static_cast<int>(query.values.size())); ++i)
      bind_value(made, i + 1, query.values[static_cast<std::size_t>(i)]);
    if (!fill(made, query.most_rows, table)) refuse(database, reading, query.longest);
  }
  if (!any) throw_problem({}, "there is no statement; try SELECT * FROM error_by_revision");
  return table;
}

std::string stamp_of(const std::filesystem::path& database) {
  std::string stamp;
  for (const std::string& file : {database.string(), database.string() + "-wal"}) {
    struct stat state {};
    if (::stat(file.c_str(), &state) != 0) continue;
    stamp += fmt::format("{}.{}.{}.{} ", state.st_ino, state.st_size, state.st_mtim.tv_sec, state.st_mtim.tv_nsec);
  }
  return stamp;
}

}  // namespace lacuna

#include "runs/database.h"

#include "runs/embedded.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include <limits>
#include <stdexcept>

namespace hidden_effects {
namespace {

constexpr int kApplicationId = 0x4C61636F;  // "Laco"; Lacuna's own files have "Lacn"
constexpr int kSchema = 1;
constexpr int kBusyTimeoutMs = 60'000;

void bind(SQLite::Statement& statement, int index, const Cell& cell) {
  if (const auto* number = std::get_if<std::int64_t>(&cell)) return statement.bind(index, *number);
  if (const auto* value = std::get_if<double>(&cell)) return statement.bind(index, *value);
  if (const auto* words = std::get_if<std::string>(&cell)) return statement.bind(index, *words);
  statement.bind(index);
}

Cell cell_of(const SQLite::Column& column) {
  if (column.isInteger()) return column.getInt64();
  if (column.isFloat()) return column.getDouble();
  if (column.isNull()) return {};
  return column.getString();
}

/// The tables that the schema makes.
std::vector<std::string> tables_of_schema() {
  SQLite::Database made(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  made.exec(schema_sql());
  std::vector<std::string> names;
  SQLite::Statement tables(made, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
  while (tables.executeStep()) names.push_back(tables.getColumn(0).getString());
  return names;
}

}  // namespace

double real(const Cell& cell) {
  if (const auto* number = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*number);
  const auto* value = std::get_if<double>(&cell);
  return value ? *value : std::numeric_limits<double>::quiet_NaN();
}

std::int64_t integer(const Cell& cell) { return std::get<std::int64_t>(cell); }

std::string text(const Cell& cell) {
  const auto* words = std::get_if<std::string>(&cell);
  return words ? *words : "";
}

Cell list_cell(const std::vector<std::string>& texts) { return nlohmann::json(texts).dump(); }

Database::Database(const std::filesystem::path& file, Access access) : file_(file) {
  if (std::filesystem::is_directory(file)) refuse("is a folder; name the database in it");
  const int how = access == Access::read ? SQLite::OPEN_READONLY : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE;
  try {
    connection_ = std::make_unique<SQLite::Database>(file.string(), how, kBusyTimeoutMs);
    connection_->exec("SELECT count(*) FROM sqlite_master");
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() != SQLITE_CANTOPEN && error.getErrorCode() != SQLITE_NOTADB) complain(error.what());
    refuse(error.what());
  }
  if (access == Access::write) make_if_empty();
  check();
  if (access == Access::write)
    execute("PRAGMA foreign_keys = ON; PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
  execute(views_sql());
}

Database::~Database() = default;

void Database::make_if_empty() {
  if (integer(query("SELECT count(*) FROM sqlite_master")[0][0]) > 0) return;
  Transaction transaction(*this);
  if (integer(query("SELECT count(*) FROM sqlite_master")[0][0]) > 0) return;  // another process was faster
  execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplicationId, kSchema));
  execute(schema_sql());
  transaction.commit();
}

void Database::check() const {
  if (integer(query("PRAGMA application_id")[0][0]) != kApplicationId) refuse("is not a database of the benchmark");
  if (integer(query("PRAGMA user_version")[0][0]) != kSchema) refuse("is of another version of the benchmark");
  std::string missing;
  for (const std::string& table : tables_of_schema())
    if (query("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?", {table}).empty())
      missing += (missing.empty() ? "" : ", ") + table;
  if (!missing.empty()) refuse("lacks tables, so its figures would be false: " + missing);
}

void Database::execute(const std::string& statements) try {
  connection_->exec(statements);
} catch (const SQLite::Exception& error) {
  complain(error.what());
}

std::vector<Row> Database::query(const std::string& statement, const Row& values) const try {
  SQLite::Statement prepared(*connection_, statement);
  for (std::size_t i = 0; i < values.size(); ++i) bind(prepared, static_cast<int>(i) + 1, values[i]);
  std::vector<Row> rows;
  while (prepared.executeStep()) {
    rows.emplace_back();
    for (int column = 0; column < prepared.getColumnCount(); ++column)
      rows.back().push_back(cell_of(prepared.getColumn(column)));
  }
  return rows;
} catch (const SQLite::Exception& error) {
  complain(error.what());
}

void Database::refuse(const std::string& reason) const {
  throw std::invalid_argument(fmt::format("{}: {}", file_.string(), reason));
}

void Database::complain(const char* reason) const {
  throw std::runtime_error(fmt::format("{}: {}", file_.string(), reason));
}

Transaction::Transaction(Database& database) : database_(database) { database_.execute("BEGIN IMMEDIATE"); }

Transaction::~Transaction() {
  if (!open_) return;
  try {
    database_.execute("ROLLBACK");
  } catch (const std::runtime_error&) {
    // SQLite rolls back by itself when the connection is closed.
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace hidden_effects

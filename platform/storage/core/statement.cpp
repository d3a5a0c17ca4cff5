#include "storage/core/statement.h"

#include "storage/core/storage_error.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <cmath>

namespace lacuna {
namespace {

SQLite::Statement prepare(const Database& database, const char* sql) {
  try {
    return {database.connection(), sql};
  } catch (const SQLite::Exception& error) {
    throw_storage_error(database.file(), error);
  }
}

}  // namespace

Statement::Statement(const Database& database, const char* sql)
    : database_(database), statement_(prepare(database, sql)) {}

bool Statement::step() try { return statement_.executeStep(); } catch (const SQLite::Exception& error) {
  throw_storage_error(database_.file(), error);
}

void Statement::run() {
  while (step()) {
  }
  restart();
}

double Statement::real(int column) { return null(column) ? kNotKnown : statement_.getColumn(column).getDouble(); }

std::vector<std::byte> Statement::bytes(int column) {
  const SQLite::Column blob = statement_.getColumn(column);
  const auto* first = static_cast<const std::byte*>(blob.getBlob());
  return {first, first + blob.getBytes()};
}

void Statement::append_bits(int column, std::string& bytes) {
  const SQLite::Column value = statement_.getColumn(column);
  const auto add = [&](const void* first, std::size_t size) { bytes.append(static_cast<const char*>(first), size); };
  const int type = value.getType();
  bytes += static_cast<char>(type);
  if (type == SQLite::INTEGER) {
    const std::int64_t integer = value.getInt64();
    add(&integer, sizeof integer);
  } else if (type == SQLite::FLOAT) {
    const double number = value.getDouble();
    add(&number, sizeof number);
  } else if (type != SQLite::Null) {
    const void* const first = value.getBlob();
    const std::int64_t size = value.getBytes();
    add(&size, sizeof size);
    if (size > 0) add(first, static_cast<std::size_t>(size));
  }
}

void Statement::take(int index, Statement& row, int column) {
  const SQLite::Column value = row.statement_.getColumn(column);
  if (value.isInteger()) return statement_.bind(index, value.getInt64());
  if (value.isFloat()) return statement_.bind(index, value.getDouble());
  if (value.isText()) return statement_.bind(index, value.getString());
  value.isBlob() ? bind(index, row.bytes(column)) : bind_null(index);
}

void Statement::restart() {
  statement_.tryReset();
  statement_.clearBindings();
}

void Statement::bind(int index, std::int64_t value) { statement_.bind(index, value); }

void Statement::bind(int index, double value) {
  if (std::isnan(value)) {
    bind_null(index);
  } else {
    statement_.bind(index, value);
  }
}

void Statement::bind(int index, const std::string& value) { statement_.bind(index, value); }

void Statement::bind(int index, std::span<const std::byte> blob) {
  // An empty span has no address, which SQLite would take for NULL.
  statement_.bind(index, blob.empty() ? "" : static_cast<const void*>(blob.data()), static_cast<int>(blob.size()));
}

void Statement::bind_null(int index) { statement_.bind(index); }

std::string name_in_sql(const std::string& name) {
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace lacuna

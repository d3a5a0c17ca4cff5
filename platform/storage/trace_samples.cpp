#include "storage/trace_samples.h"

#include "storage/read_trace.h"
#include "storage/storage_error.h"

#include <sqlite3.h>

#include <cmath>
#include <exception>
#include <iterator>

/// The callbacks of SQLite's interface for virtual tables; no exception may leave them.
namespace lacuna {
namespace {

constexpr const char* kName = "trace_samples";
constexpr const char* kDeclaration =
    "CREATE TABLE x (sample INTEGER, time REAL, channel TEXT, value REAL, trace INTEGER HIDDEN)";
enum Column { kSample, kTime, kChannel, kValue, kTrace };
constexpr double kCostOfATrace = 1000.0;  ///< in the planner's unit, about a row

/// Each begins with SQLite's own part, as its interface wants it.
struct Table {
  sqlite3_vtab base{};
  const Database* database = nullptr;
};
struct Cursor {
  sqlite3_vtab_cursor base{};
  TraceId trace;
  TimeSeries series;
  Eigen::Index cell = 0;  ///< sample by sample, within it channel by channel
};

Cursor& cursor_of(sqlite3_vtab_cursor* base) { return *reinterpret_cast<Cursor*>(base); }

int connect(sqlite3* handle, void* database, int, const char* const*, sqlite3_vtab** table, char**) {
  const int result = sqlite3_declare_vtab(handle, kDeclaration);
  if (result != SQLITE_OK) return result;
  auto* made = new Table;  // SQLite hands it back to `disconnect`
  made->database = static_cast<const Database*>(database);
  *table = &made->base;
  return SQLITE_OK;
}

int disconnect(sqlite3_vtab* table) {
  delete reinterpret_cast<Table*>(table);
  return SQLITE_OK;
}

/// The one way to ask: for the samples of a given trace.
int choose_plan(sqlite3_vtab* table, sqlite3_index_info* plan) {
  for (int i = 0; i < plan->nConstraint; ++i) {
    const auto& constraint = plan->aConstraint[i];
    if (constraint.iColumn != kTrace || constraint.op != SQLITE_INDEX_CONSTRAINT_EQ) continue;
    if (constraint.usable == 0) return SQLITE_CONSTRAINT;  // another order of the join
    plan->aConstraintUsage[i].argvIndex = 1;
    plan->aConstraintUsage[i].omit = 1;
    plan->estimatedCost = kCostOfATrace;
    return SQLITE_OK;
  }
  sqlite3_free(table->zErrMsg);
  table->zErrMsg = sqlite3_mprintf("%s", "trace_samples needs the key of a trace: trace_samples(traces.id)");
  return SQLITE_ERROR;
}

int open_cursor(sqlite3_vtab*, sqlite3_vtab_cursor** cursor) {
  *cursor = &(new Cursor)->base;  // SQLite hands it back to `close_cursor`
  return SQLITE_OK;
}

int close_cursor(sqlite3_vtab_cursor* cursor) {
  delete &cursor_of(cursor);
  return SQLITE_OK;
}

int start(sqlite3_vtab_cursor* base, int, const char*, int, sqlite3_value** arguments) {
  Cursor& cursor = cursor_of(base);
  try {
    cursor.trace = {sqlite3_value_int64(arguments[0])};
    cursor.series = read_trace(*reinterpret_cast<Table*>(base->pVtab)->database, cursor.trace);
    cursor.cell = 0;
    return SQLITE_OK;
  } catch (const std::exception& error) {
    sqlite3_free(base->pVtab->zErrMsg);
    base->pVtab->zErrMsg = sqlite3_mprintf("%s", error.what());
    return SQLITE_ERROR;
  }
}

int advance(sqlite3_vtab_cursor* cursor) {
  ++cursor_of(cursor).cell;
  return SQLITE_OK;
}

int at_end(sqlite3_vtab_cursor* base) {
  const Cursor& cursor = cursor_of(base);
  return cursor.cell >= cursor.series.samples.size() ? 1 : 0;
}

int give_column(sqlite3_vtab_cursor* base, sqlite3_context* result, int column) {
  const Cursor& cursor = cursor_of(base);
  const Eigen::Index channels = cursor.series.samples.cols();
  const Eigen::Index sample = cursor.cell / channels;
  switch (column) {
    case kSample: sqlite3_result_int64(result, sample); break;
    case kTime: sqlite3_result_double(result, cursor.series.times[sample]); break;
    case kChannel: {
      const std::string& name = cursor.series.channels[static_cast<std::size_t>(cursor.cell % channels)].name;
      sqlite3_result_text(result, name.c_str(), static_cast<int>(name.size()), SQLITE_TRANSIENT);
      break;
    }
    case kValue: sqlite3_result_double(result, cursor.series.samples.data()[cursor.cell]); break;  // NaN: NULL
    default: sqlite3_result_int64(result, cursor.trace.value); break;
  }
  return SQLITE_OK;
}

int give_row_number(sqlite3_vtab_cursor* cursor, sqlite3_int64* row) {
  *row = cursor_of(cursor).cell;
  return SQLITE_OK;
}

sqlite3_module make_module() {
  sqlite3_module module{};  // without xCreate it is there by its name alone
  module.xConnect = connect;
  module.xDisconnect = disconnect;
  module.xBestIndex = choose_plan;
  module.xOpen = open_cursor;
  module.xClose = close_cursor;
  module.xFilter = start;
  module.xNext = advance;
  module.xEof = at_end;
  module.xColumn = give_column;
  module.xRowid = give_row_number;
  return module;
}

}  // namespace

TraceSamples::TraceSamples(const Database& database) : database_(database) {
  static const sqlite3_module kModule = make_module();
  // SQLite does not change what it hands back to `connect`.
  const int result = sqlite3_create_module(database.handle(), kName, &kModule, const_cast<Database*>(&database));
  if (result != SQLITE_OK) throw_storage_error(database.file(), result, sqlite3_errmsg(database.handle()));
}

TraceSamples::~TraceSamples() { sqlite3_create_module(database_.handle(), kName, nullptr, nullptr); }

}  // namespace lacuna

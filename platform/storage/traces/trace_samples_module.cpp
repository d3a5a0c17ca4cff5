#include "storage/traces/trace_samples_module.h"

#include "storage/traces/trace_codec.h"

#include <lacuna/error.h>

#ifdef LACUNA_SQLITE_EXTENSION  // the program that loads it has SQLite
#include <sqlite3ext.h>
SQLITE_EXTENSION_INIT3
#else
#include <sqlite3.h>
#endif

#include <exception>
#include <memory>
#include <new>

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
  sqlite3* handle = nullptr;
};
struct Cursor {
  sqlite3_vtab_cursor base{};
  sqlite3_int64 trace = 0;
  TimeSeries series;
  Eigen::Index cell = 0;  ///< sample by sample, within it channel by channel
};

Cursor& cursor_of(sqlite3_vtab_cursor* base) { return *reinterpret_cast<Cursor*>(base); }

using Query = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

std::vector<std::byte> bytes_of(const Query& row, int column) {
  const auto* first = static_cast<const std::byte*>(sqlite3_column_blob(row.get(), column));
  return {first, first + sqlite3_column_bytes(row.get(), column)};
}

std::string text_of(const Query& row, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row.get(), column));
  return text == nullptr ? std::string() : std::string(text);
}

thread_local bool samples_are_read = false;

/// In a file of a stranger, `trace` may be a view that asks for samples itself.
class ReadingOnce {
 public:
  ReadingOnce() {
    if (samples_are_read) throw Error("not a Lacuna database: its table trace is made of samples");
    samples_are_read = true;
  }
  ~ReadingOnce() { samples_are_read = false; }
  ReadingOnce(const ReadingOnce&) = delete;
  ReadingOnce& operator=(const ReadingOnce&) = delete;
};

TimeSeries read(sqlite3* handle, sqlite3_int64 trace) {
  const ReadingOnce once;
  static constexpr const char* kQuery =
      "SELECT channels, sample_count, precision, times, samples, digest FROM trace WHERE id = ?";
  sqlite3_stmt* prepared = nullptr;
  const int result = sqlite3_prepare_v2(handle, kQuery, -1, &prepared, nullptr);
  const Query row(prepared, [](sqlite3_stmt* statement) { return sqlite3_finalize(statement); });
  if (result != SQLITE_OK) throw Error(std::string("not a Lacuna database: ") + sqlite3_errmsg(handle));
  sqlite3_bind_int64(row.get(), 1, trace);
  switch (sqlite3_step(row.get())) {
    case SQLITE_ROW: break;
    case SQLITE_DONE: throw Error("the database has no trace " + std::to_string(trace));
    default: throw Error(sqlite3_errmsg(handle));
  }
  return decode_trace({.channels = text_of(row, 0),
                       .sample_count = sqlite3_column_int64(row.get(), 1),
                       .precision = text_of(row, 2) == "float32" ? TracePrecision::float32 : TracePrecision::float64,
                       .times = bytes_of(row, 3),
                       .samples = bytes_of(row, 4),
                       .digest = text_of(row, 5)});
}

int connect_table(sqlite3* handle, void*, int, const char* const*, sqlite3_vtab** table, char**) {
  const int result = sqlite3_declare_vtab(handle, kDeclaration);
  if (result != SQLITE_OK) return result;
  sqlite3_vtab_config(handle, SQLITE_VTAB_INNOCUOUS);  // it only reads, so views may use it
  auto* made = new (std::nothrow) Table;               // SQLite hands it back to `disconnect`
  if (made == nullptr) return SQLITE_NOMEM;
  made->handle = handle;
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
  auto* const made = new (std::nothrow) Cursor;  // SQLite hands it back to `close_cursor`
  if (made == nullptr) return SQLITE_NOMEM;
  *cursor = &made->base;
  return SQLITE_OK;
}

int close_cursor(sqlite3_vtab_cursor* cursor) {
  delete &cursor_of(cursor);
  return SQLITE_OK;
}

int start(sqlite3_vtab_cursor* base, int, const char*, int, sqlite3_value** arguments) {
  Cursor& cursor = cursor_of(base);
  try {
    cursor.trace = sqlite3_value_int64(arguments[0]);
    cursor.series = read(reinterpret_cast<Table*>(base->pVtab)->handle, cursor.trace);
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
    default: sqlite3_result_int64(result, cursor.trace); break;
  }
  return SQLITE_OK;
}

int give_row_number(sqlite3_vtab_cursor* cursor, sqlite3_int64* row) {
  *row = cursor_of(cursor).cell;
  return SQLITE_OK;
}

sqlite3_module make_module() {
  sqlite3_module module{};  // without xCreate it is there by its name alone
  module.xConnect = connect_table;
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

int add_trace_samples(sqlite3* handle) {
  static const sqlite3_module kModule = make_module();
  return sqlite3_create_module(handle, kName, &kModule, nullptr);
}

int remove_trace_samples(sqlite3* handle) { return sqlite3_create_module(handle, kName, nullptr, nullptr); }

}  // namespace lacuna

#include "storage/core/reading_only.h"

#include "storage/core/bounded_functions.h"

#include <sqlite3.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace lacuna {
namespace {

constexpr int kOperationsBetweenQuestions = 100;  ///< of SQLite's machine: a call of a function may take 50 ms

constexpr std::pair<int, int> kLimits[] = {{SQLITE_LIMIT_LENGTH, ReadingOnly::kLongestValue},
                                           {SQLITE_LIMIT_SQL_LENGTH, 1 << 20},
                                           {SQLITE_LIMIT_EXPR_DEPTH, 200},
                                           {SQLITE_LIMIT_COMPOUND_SELECT, 200},
                                           {SQLITE_LIMIT_VDBE_OP, 1'000'000},
                                           {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 200}};

/// SQLite's functions of numbers, texts, times and JSON, aggregates and windows. Whatever else a build of SQLite or a
/// loaded library may have (fts3_tokenizer, readfile, edit ...) has no place in a question.
constexpr std::string_view kFunctions[] = {"->",
                                           "->>",
                                           "abs",
                                           "acos",
                                           "acosh",
                                           "asin",
                                           "asinh",
                                           "atan",
                                           "atan2",
                                           "atanh",
                                           "avg",
                                           "ceil",
                                           "ceiling",
                                           "changes",
                                           "char",
                                           "coalesce",
                                           "concat",
                                           "concat_ws",
                                           "cos",
                                           "cosh",
                                           "count",
                                           "cume_dist",
                                           "current_date",
                                           "current_time",
                                           "current_timestamp",
                                           "date",
                                           "datetime",
                                           "degrees",
                                           "dense_rank",
                                           "exp",
                                           "first_value",
                                           "floor",
                                           "format",
                                           "glob",
                                           "group_concat",
                                           "hex",
                                           "if",
                                           "ifnull",
                                           "iif",
                                           "instr",
                                           "julianday",
                                           "lag",
                                           "last_insert_rowid",
                                           "last_value",
                                           "lead",
                                           "length",
                                           "like",
                                           "likelihood",
                                           "likely",
                                           "ln",
                                           "log",
                                           "log10",
                                           "log2",
                                           "lower",
                                           "ltrim",
                                           "max",
                                           "median",
                                           "min",
                                           "mod",
                                           "nth_value",
                                           "ntile",
                                           "nullif",
                                           "octet_length",
                                           "percent_rank",
                                           "percentile",
                                           "percentile_cont",
                                           "percentile_disc",
                                           "pi",
                                           "pow",
                                           "power",
                                           "printf",
                                           "quote",
                                           "radians",
                                           "random",
                                           "randomblob",
                                           "rank",
                                           "replace",
                                           "round",
                                           "row_number",
                                           "rtrim",
                                           "sign",
                                           "sin",
                                           "sinh",
                                           "soundex",
                                           "sqlite_source_id",
                                           "sqlite_version",
                                           "sqrt",
                                           "strftime",
                                           "string_agg",
                                           "substr",
                                           "substring",
                                           "subtype",
                                           "sum",
                                           "tan",
                                           "tanh",
                                           "time",
                                           "timediff",
                                           "total",
                                           "total_changes",
                                           "trim",
                                           "trunc",
                                           "typeof",
                                           "unhex",
                                           "unicode",
                                           "unixepoch",
                                           "unlikely",
                                           "upper",
                                           "zeroblob"};

bool is_allowed(std::string_view function) {
  return function.starts_with("json_") || function.starts_with("jsonb_") || function == "json" || function == "jsonb" ||
         std::find(std::begin(kFunctions), std::end(kFunctions), function) != std::end(kFunctions);
}

int stop_if_due(void* asked) {
  const auto& reading = *static_cast<const ReadingOnly*>(asked);
  return reading.stop().is_due() || reading.out_of_time() ? 1 : 0;
}

/// Refuses what the read-only file itself would let pass: other files, pragmas that set something, extensions.
int allow_reading_only(void*, int action, const char* first, const char* second, const char*, const char*) {
  switch (action) {
    case SQLITE_SELECT:
    case SQLITE_READ:
    case SQLITE_RECURSIVE: return SQLITE_OK;
    case SQLITE_UPDATE:  // how table-valued pragmas declare themselves; a true update of it is refused by SQLite
      return std::string_view(first) == "sqlite_master" ? SQLITE_OK : SQLITE_DENY;
    case SQLITE_FUNCTION: return second != nullptr && is_allowed(second) ? SQLITE_OK : SQLITE_DENY;
    case SQLITE_PRAGMA: {
      static constexpr std::string_view kAsking[] = {"table_info",      "table_xinfo", "table_list",
                                                     "index_list",      "index_info",  "foreign_key_list",
                                                     "integrity_check", "quick_check", "foreign_key_check"};
      static constexpr std::string_view kAskingWithoutValue[] = {"user_version", "application_id", "journal_mode",
                                                                 "page_count",   "page_size",      "encoding"};
      const auto among = [&](const auto& names) {
        return std::find(std::begin(names), std::end(names), first) != std::end(names);
      };
      return among(kAsking) || (second == nullptr && among(kAskingWithoutValue)) ? SQLITE_OK : SQLITE_DENY;
    }
    default: return SQLITE_DENY;
  }
}

}  // namespace

ReadingOnly::ReadingOnly(sqlite3* handle, const Stop& stop, std::optional<std::chrono::milliseconds> longest)
    : handle_(handle), stop_(stop), longest_(longest) {
  if (longest) end_ = std::chrono::steady_clock::now() + *longest;
  sqlite3_hard_heap_limit64(kMostQueryMemory);
  add_bounded_functions(handle_);
  for (const auto& [limit, most] : kLimits) limits_.emplace_back(limit, sqlite3_limit(handle_, limit, most));
  sqlite3_set_authorizer(handle_, allow_reading_only, nullptr);
  sqlite3_progress_handler(handle_, kOperationsBetweenQuestions, stop_if_due, this);
}

ReadingOnly::~ReadingOnly() {
  sqlite3_set_authorizer(handle_, nullptr, nullptr);
  sqlite3_progress_handler(handle_, 0, nullptr, nullptr);
  for (const auto& [limit, before] : limits_) sqlite3_limit(handle_, limit, before);
}

bool ReadingOnly::out_of_time() const { return end_ && std::chrono::steady_clock::now() > *end_; }

}  // namespace lacuna

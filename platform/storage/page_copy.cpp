#include "storage/page_copy.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>

namespace lacuna {
namespace {

using Prepared = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

[[noreturn]] void fail_to_copy(sqlite3* handle) {
  throw Error(fmt::format("the database cannot be copied into the report: {}", sqlite3_errmsg(handle)));
}

Prepared prepared(sqlite3* handle, const std::string& sql) {
  sqlite3_stmt* made = nullptr;
  if (sqlite3_prepare_v2(handle, sql.c_str(), -1, &made, nullptr) != SQLITE_OK) fail_to_copy(handle);
  return {made, &sqlite3_finalize};
}

void run_on(sqlite3* handle, const std::string& sql) {
  if (sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail_to_copy(handle);
}

bool next_row(sqlite3* handle, const Prepared& statement) {
  const int result = sqlite3_step(statement.get());
  if (result != SQLITE_ROW && result != SQLITE_DONE) fail_to_copy(handle);
  return result == SQLITE_ROW;
}

std::string text_at(const Prepared& statement, int column) {
  return reinterpret_cast<const char*>(sqlite3_column_text(statement.get(), column));
}

std::int64_t number_of(sqlite3* handle, const std::string& sql) {
  const Prepared statement = prepared(handle, sql);
  return next_row(handle, statement) ? sqlite3_column_int64(statement.get(), 0) : 0;
}

struct SchemaItem {
  std::string name, sql;
};

std::vector<SchemaItem> items(sqlite3* handle, const char* type) {
  const Prepared statement = prepared(
      handle, fmt::format("SELECT name, sql FROM sqlite_master WHERE type = '{}' AND sql IS NOT NULL AND name NOT LIKE "
                          "'sqlite_%' ORDER BY rowid",
                          type));
  std::vector<SchemaItem> found;
  while (next_row(handle, statement)) found.push_back({text_at(statement, 0), text_at(statement, 1)});
  return found;
}

/// What of a table is copied: a SELECT. Tables that are not named are copied whole.
using Choices = std::map<std::string, std::string>;

Choices everything() { return {{"checkpoint", "SELECT run, commits, seconds, x'' AS state, digest FROM checkpoint"}}; }

/// Only what the best models and tests of passes and the tests of trials need.
void leave_out_candidates(Choices& choices) {
  const std::string models = "(SELECT best_model FROM pass WHERE best_model IS NOT NULL)";
  const std::string tests =
      "(SELECT best_test FROM pass WHERE best_test IS NOT NULL UNION SELECT test FROM target_trial WHERE test IS NOT "
      "NULL)";
  choices["model"] = "SELECT * FROM model WHERE id IN " + models;
  choices["model_score"] = "SELECT * FROM model_score WHERE model IN " + models;
  choices["invalid_model"] = "SELECT * FROM invalid_model WHERE model IN " + models;
  choices["test"] = "SELECT * FROM test WHERE id IN " + tests;
  choices["test_score"] = "SELECT * FROM test_score WHERE test IN " + tests;
  choices["invalid_test"] = "SELECT * FROM invalid_test WHERE test IN " + tests;
}

std::int64_t row_count(sqlite3* from, const std::string& table) {
  return number_of(from, "SELECT count(*) FROM " + table);
}

/// Series of the latest comparisons first, then newer before older, until they take `most_bytes`; returns how many are
/// left out.
std::int64_t leave_out_series(sqlite3* from, std::int64_t most_bytes, Choices& choices) {
  const std::string kept = fmt::format(
      "SELECT id FROM (SELECT id, sum(length(times) + length(samples)) OVER (ORDER BY rank, -id) AS so_far FROM "
      "(SELECT "
      "*, iif(comparison IN (SELECT comparison FROM latest_comparison) OR comparison IS NULL AND trial IN (SELECT "
      "trial "
      "FROM comparison_score), 0, 1) AS rank FROM trace)) WHERE so_far <= {}",
      most_bytes);
  const std::int64_t left = number_of(from, "SELECT count(*) FROM trace WHERE id NOT IN (" + kept + ")");
  if (left > 0) choices["trace"] = "SELECT * FROM trace WHERE id IN (" + kept + ")";
  return left;
}

std::int64_t bytes_of_series(sqlite3* from) {
  return number_of(from, "SELECT coalesce(sum(length(times) + length(samples)), 0) FROM trace");
}

/// Sizes are estimates from what schema/database.md says of the tables.
std::int64_t bytes_of_candidates(sqlite3* from) {
  constexpr std::int64_t kScoreBytes = 40, kRowBytes = 60;
  const auto genomes = [&](const char* table) {
    return number_of(from, fmt::format("SELECT coalesce(sum(length(genome) + {}), 0) FROM {}", kRowBytes, table));
  };
  return kScoreBytes * (row_count(from, "model_score") + row_count(from, "test_score")) + genomes("model") +
         genomes("test");
}

std::vector<std::string> choose_what_fits(sqlite3* from, std::int64_t most_bytes, Choices& choices) {
  constexpr double kMegabyte = 1e6;
  const std::int64_t pages = number_of(from, "PRAGMA page_count") - number_of(from, "PRAGMA freelist_count");
  std::int64_t size = pages * number_of(from, "PRAGMA page_size");
  if (size <= most_bytes) return {};
  std::vector<std::string> notes = {
      fmt::format("The database has {:.0f} MB and this report shows a selection of at most {:.0f} MB; lacuna serve "
                  "shows all of it.",
                  static_cast<double>(size) / kMegabyte, static_cast<double>(most_bytes) / kMegabyte)};
  const std::int64_t candidates = bytes_of_candidates(from);
  if (candidates > 0) {
    leave_out_candidates(choices);
    size -= candidates;
    notes.push_back(fmt::format("Left out: of {} models and {} tests all that are no pass's best, with their scores.",
                                row_count(from, "model"), row_count(from, "test")));
  }
  if (size > most_bytes) {
    const std::int64_t series = bytes_of_series(from);
    const std::int64_t room = std::max<std::int64_t>(most_bytes - (size - series), most_bytes / 4);
    const std::int64_t left = leave_out_series(from, room, choices);
    if (left > 0) notes.push_back(fmt::format("Left out: {} of {} time series.", left, row_count(from, "trace")));
  }
  return notes;
}

void copy_rows(sqlite3* from, sqlite3* to, const std::string& table, const std::string& choice) {
  const Prepared source = prepared(from, choice);
  const int columns = sqlite3_column_count(source.get());
  std::string marks = "?";
  for (int i = 1; i < columns; ++i) marks += ", ?";
  const Prepared into = prepared(to, fmt::format("INSERT INTO \"{}\" VALUES ({})", table, marks));
  while (next_row(from, source)) {
    for (int i = 0; i < columns; ++i) sqlite3_bind_value(into.get(), i + 1, sqlite3_column_value(source.get(), i));
    next_row(to, into);
    sqlite3_reset(into.get());
  }
}

}  // namespace

std::vector<std::string> copy_for_pages(sqlite3* from, sqlite3* to, std::size_t most_bytes) {
  run_on(from, "BEGIN");  // one state of the file, whoever writes to it meanwhile
  Choices choices = everything();
  std::vector<std::string> notes = choose_what_fits(from, static_cast<std::int64_t>(most_bytes), choices);
  run_on(to, "PRAGMA foreign_keys = OFF; BEGIN");
  for (const SchemaItem& table : items(from, "table")) {
    run_on(to, table.sql);
    const auto choice = choices.find(table.name);
    copy_rows(from, to, table.name,
              choice == choices.end() ? fmt::format("SELECT * FROM \"{}\"", table.name) : choice->second);
  }
  for (const char* type : {"index", "view"})
    for (const SchemaItem& item : items(from, type)) run_on(to, item.sql);
  for (const char* header : {"application_id", "user_version"})
    run_on(to, fmt::format("PRAGMA {} = {}", header, number_of(from, fmt::format("PRAGMA {}", header))));
  run_on(to, "COMMIT");
  run_on(from, "COMMIT");
  return notes;
}

}  // namespace lacuna

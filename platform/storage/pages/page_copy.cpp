#include "storage/pages/page_copy.h"

#include "storage/core/statement.h"
#include "storage/core/storage_error.h"
#include "storage/core/without_folders.h"
#include "storage/pages/page_candidates.h"
#include "storage/results/stored_run.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace lacuna {
namespace {

/// Uses SQLite directly: rows are copied unchanged, whatever their types.
using RowStatement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

[[noreturn]] void fail_to_copy(const Database& database) {
  throw_storage_error(database.file(), sqlite3_extended_errcode(database.handle()), sqlite3_errmsg(database.handle()));
}

RowStatement row_statement(const Database& database, const std::string& sql) {
  sqlite3_stmt* made = nullptr;
  if (sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &made, nullptr) != SQLITE_OK) fail_to_copy(database);
  return {made, &sqlite3_finalize};
}

bool next_row(const Database& database, const RowStatement& statement) {
  const int result = sqlite3_step(statement.get());
  if (result != SQLITE_ROW && result != SQLITE_DONE) fail_to_copy(database);
  return result == SQLITE_ROW;
}

std::int64_t number_of(const Database& database, const std::string& sql) {
  Statement statement(database, sql.c_str());
  return statement.step() ? statement.integer(0) : 0;
}

struct SchemaItem {
  std::string name, sql;
};

std::vector<SchemaItem> items(const Database& database, const char* type) {
  Statement statement(database,
                      "SELECT name, sql FROM sqlite_master WHERE type = ? AND sql IS NOT NULL AND name NOT LIKE "
                      "'sqlite_%' ORDER BY rowid");
  statement.with(type);
  std::vector<SchemaItem> found;
  while (statement.step()) found.push_back({statement.text(0), statement.text(1)});
  return found;
}

/// The part of a table that is copied, as a SELECT. Tables that are not named are copied completely.
using Choices = std::map<std::string, std::string>;

Choices everything() { return {{"checkpoint", "SELECT run, commits, seconds, x'' AS state, digest FROM checkpoint"}}; }

/// The one column of a table that names files of this machine, if there is one.
std::string_view column_with_paths(std::string_view table) {
  static constexpr std::pair<std::string_view, std::string_view> kColumns[] = {{"experiment_text", "file"},
                                                                               {"failed_trial", "reason"},
                                                                               {"holdout_look", "command"},
                                                                               {"plugin_file", "file"},
                                                                               {"robot_file", "file"},
                                                                               {"run", "command"},
                                                                               {"trial", "file"}};
  for (const auto& [name, column] : kColumns)
    if (name == table) return column;
  return {};
}

void bind_without_folders(sqlite3_stmt* into, int index, sqlite3_stmt* from, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(from, column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(from, column));
  const std::string kept = without_folders({text, size});
  sqlite3_bind_text(into, index, kept.data(), static_cast<int>(kept.size()), SQLITE_TRANSIENT);
}

/// Rows of a table from one database to another. Files of one name in several folders become one.
class RowCopy {
 public:
  RowCopy(const Database& from, const Database& to, const std::string& table, const std::string& choice)
      : from_(from), to_(to), source_(row_statement(from, choice)), into_(nullptr, &sqlite3_finalize) {
    const int columns = sqlite3_column_count(source_.get());
    std::string marks = "?";
    for (int i = 1; i < columns; ++i) marks += ", ?";
    const std::string_view paths = column_with_paths(table);
    for (int i = 0; i < columns; ++i)
      if (sqlite3_column_name(source_.get(), i) == paths) with_path_ = i;
    into_ = row_statement(
        to, fmt::format("INSERT {}INTO {} VALUES ({})", with_path_ < 0 ? "" : "OR IGNORE ", name_in_sql(table), marks));
  }

  void copy_all() {
    while (next_row(from_, source_)) copy_row();
    sqlite3_reset(source_.get());
  }

  /// The rows for which the choice's one parameter has this value.
  void copy_for(std::int64_t value) {
    sqlite3_bind_int64(source_.get(), 1, value);
    copy_all();
  }

 private:
  void copy_row() {
    for (int i = 0; i < sqlite3_column_count(source_.get()); ++i) {
      if (i == with_path_)
        bind_without_folders(into_.get(), i + 1, source_.get(), i);
      else
        sqlite3_bind_value(into_.get(), i + 1, sqlite3_column_value(source_.get(), i));
    }
    next_row(to_, into_);
    sqlite3_reset(into_.get());
  }

  const Database& from_;
  const Database& to_;
  RowStatement source_, into_;
  int with_path_ = -1;
};

std::int64_t bytes_of(const Database& database) {
  return (number_of(database, "PRAGMA page_count") - number_of(database, "PRAGMA freelist_count")) *
         number_of(database, "PRAGMA page_size");
}

/// One statement: in a file of unknown origin others may stand behind it, which SQLite did not look at when it read the
/// schema.
void make(const Database& to, const SchemaItem& item) { Statement(to, item.sql.c_str()).run(); }

void make_tables(const Database& from, Database& to) {
  for (const char* type : {"table", "index"})
    for (const SchemaItem& item : items(from, type)) make(to, item);
}

/// Of all tables but series that `is_wanted` accepts.
template <class Accept>
void copy_rows(const Database& from, const Database& to, const Choices& choices, Accept is_wanted) {
  for (const SchemaItem& table : items(from, "table")) {
    if (table.name == "trace" || !is_wanted(table.name)) continue;
    const auto choice = choices.find(table.name);
    const std::string all = "SELECT * FROM " + name_in_sql(table.name);
    RowCopy(from, to, table.name, choice == choices.end() ? all : choice->second).copy_all();
  }
}

/// Series of the latest comparisons first, then newer before older, as long as there is room for them. Returns how many
/// are left out.
std::int64_t copy_series(const Database& from, Database& to, std::int64_t room) {
  constexpr const char* kByWorth =
      "SELECT id, length(times) + length(samples) + length(channels) FROM trace "
      "ORDER BY iif(comparison IN (SELECT comparison FROM latest_comparison) OR comparison IS NULL AND trial IN "
      "(SELECT trial FROM comparison_score), 0, 1), id DESC";
  constexpr std::int64_t kRowBytes = 5000;  ///< what a row takes besides: its last page is not full
  std::set<std::int64_t> kept;
  std::int64_t left_out = 0;
  for (Statement series(from, kByWorth); series.step();) {
    room -= series.integer(1) + kRowBytes;
    if (room >= 0)
      kept.insert(series.integer(0));
    else
      ++left_out;
  }
  RowCopy rows(from, to, "trace", "SELECT * FROM trace WHERE id = ?");
  for (const std::int64_t id : kept) rows.copy_for(id);
  return left_out;
}

/// Of the runs of which not everything is copied.
void keep_counts(const Database& from, const Database& to, std::int64_t first_whole_run) {
  Statement insert(to, "INSERT INTO page_run VALUES (?, ?, ?)");
  Statement run(from, "SELECT run, models, tests FROM eea_runs WHERE run < ?");
  for (run.with(first_whole_run); run.step();) insert.run_with(run.integer(0), run.integer(1), run.integer(2));
}

double megabytes(std::int64_t bytes) { return static_cast<double>(bytes) / 1e6; }

std::string selection_note(std::int64_t whole, std::int64_t taken, std::int64_t most) {
  return fmt::format(
      "The database has {:.1f} MB; this report shows a selection of it, {:.1f} MB{}. To see everything: lacuna serve.",
      megabytes(whole), megabytes(taken),
      taken > most
          ? fmt::format(", more than the limit of {:.1f} MB, because nothing else can be left out", megabytes(most))
          : "");
}

/// What is copied where not everything has room.
std::vector<std::string> copy_selection(const Database& from, Database& to, std::int64_t whole, std::int64_t most) {
  copy_rows(from, to, everything(), [](const std::string& table) { return !has_candidates(table); });
  const std::int64_t best = bytes_of_best_candidates(from);
  const std::int64_t left_out = copy_series(from, to, most - bytes_of(to) - best);
  const CandidateSelection candidates = select_candidates(from, most - bytes_of(to) - best);
  copy_rows(from, to, candidates.choices, has_candidates);
  keep_counts(from, to, candidates.first_whole_run);
  if (left_out == 0 && candidates.note.empty()) return {};  // a copy is smaller than a file that was written to
  std::vector<std::string> notes = {selection_note(whole, bytes_of(to), most)};
  if (!candidates.note.empty()) notes.push_back(candidates.note);
  if (left_out > 0)
    notes.push_back(
        fmt::format("Left out: {} of {} time series.", left_out, number_of(from, "SELECT count(*) FROM trace")));
  return notes;
}

std::vector<std::string> copy_what_fits(const Database& from, Database& to, std::int64_t most) {
  make_tables(from, to);
  const std::int64_t whole = bytes_of(from);
  const std::int64_t states = number_of(from, "SELECT coalesce(sum(length(state)), 0) FROM checkpoint");
  if (whole - states > most) return copy_selection(from, to, whole, most);
  copy_rows(from, to, everything(), [](const std::string&) { return true; });
  copy_series(from, to, std::numeric_limits<std::int64_t>::max());
  return {};
}

/// Of texts whose file's name is without its folder now.
void renew_digests(const Database& to) {
  std::vector<std::pair<std::int64_t, std::string>> digests;
  Statement texts(to, "SELECT id, file, text, overrides, decided FROM experiment_text");
  while (texts.step())
    digests.emplace_back(texts.integer(0), digest_of_text(texts.text(1), texts.text(2), texts.text(3), texts.text(4)));
  Statement renew(to, "UPDATE OR IGNORE experiment_text SET digest = ? WHERE id = ?");
  for (const auto& [id, digest] : digests) renew.run_with(digest, id);
}

}  // namespace

std::vector<std::string> copy_for_pages(const Database& from, Database& to, std::size_t most_bytes) {
  to.execute("PRAGMA foreign_keys = OFF");
  Transaction writing(to);
  Statement(from, "BEGIN").run();  // one state of the file, whoever writes to it meanwhile
  std::vector<std::string> notes = copy_what_fits(from, to, static_cast<std::int64_t>(most_bytes));
  renew_digests(to);
  for (const SchemaItem& view : items(from, "view")) make(to, view);
  for (const char* header : {"application_id", "user_version"})
    to.execute(fmt::format("PRAGMA {} = {}", header, number_of(from, fmt::format("PRAGMA {}", header))));
  writing.commit();
  Statement(from, "COMMIT").run();
  return notes;
}

}  // namespace lacuna

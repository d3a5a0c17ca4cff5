#include "storage/merge/copy_runs.h"

#include "storage/integrity/run_rows.h"
#include "storage/integrity/seal.h"
#include "storage/core/statement.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lacuna {
namespace {

/// What a column holds, as far as it changes with the numbers of runs.
enum class Meaning { value, run, key, shared, trial_name, revision_number, look_number, later };

struct CopiedColumn {
  std::string name;
  Meaning meaning = Meaning::value;
  std::string table;  ///< that a shared row stands in
};

/// Columns that hold numbers of runs or keys without being declared as references.
Meaning undeclared_meaning(const std::string& table, const std::string& column) {
  if (table == "run" && column == "number") return Meaning::run;
  if (table == "trial" && column == "name") return Meaning::trial_name;
  if (table == "revision" && column == "number") return Meaning::revision_number;
  if ((table == "holdout_look" && column == "number") || (table == "comparison" && column == "look"))
    return Meaning::look_number;
  if (column == "id") return Renumbering::is_shared(table) ? Meaning::shared : Meaning::key;
  return Meaning::value;
}

std::map<std::string, std::string> references_of(const Database& database, const std::string& table) {
  enum Field { kTable = 2, kFrom = 3 };
  std::map<std::string, std::string> references;
  Statement row(database, fmt::format("PRAGMA foreign_key_list({})", table).c_str());
  while (row.step()) references[row.text(kFrom)] = row.text(kTable);
  return references;
}

std::vector<CopiedColumn> columns_with_meaning(const Database& database, const std::string& table) {
  const std::map<std::string, std::string> references = references_of(database, table);
  std::vector<CopiedColumn> columns;
  for (const std::string& name : columns_of(database, table).all) {
    const auto reference = references.find(name);
    if (reference == references.end())
      columns.push_back({name, undeclared_meaning(table, name), table});
    else if (table == "pass" && (reference->second == "model" || reference->second == "test"))
      columns.push_back({name, Meaning::later, ""});
    else if (reference->second == "run" || reference->second == "eea_run")
      columns.push_back({name, Meaning::run, ""});
    else
      columns.push_back(
          {name, Renumbering::is_shared(reference->second) ? Meaning::shared : Meaning::key, reference->second});
  }
  return columns;
}

/// A table's rows on their way.
class TableCopy {
 public:
  TableCopy(const Database& shard, Database& into, const Renumbering& numbers, const TableOfRuns& rule)
      : shard_(shard),
        numbers_(numbers),
        rule_(rule),
        table_(rule.name),
        columns_(columns_with_meaning(into, table_)),
        rows_(shard, fmt::format("SELECT {} FROM {} ORDER BY {}", joined_names(), table_,
                                 fmt::join(columns_of(into, table_).key, ", "))
                         .c_str()),
        insert_(into, fmt::format("INSERT OR {} INTO {} ({}) VALUES ({})", on_conflict(), table_, joined_names(),
                                  fmt::join(std::vector<const char*>(columns_.size(), "?"), ", "))
                          .c_str()),
        same_trace_(into,
                    "SELECT 1 FROM trace WHERE trial = ? AND kind = ? AND digest = ?"
                    " AND comparison IS NULL AND model IS NULL"),
        experiment_of_revision_(shard, "SELECT experiment FROM revision WHERE id = ?") {}

  void run() {
    constexpr int kRowsBetweenLooks = 10000;
    for (int count = 0; rows_.step(); ++count) {
      if (count % kRowsBetweenLooks == 0) shard_.stop().throw_if_due();
      if (!is_to_be_copied() || is_measured_already()) continue;
      insert_.begin_again();
      give_row();
      insert_.run();
    }
  }

 private:
  std::string joined_names() const {
    std::vector<std::string> names;
    for (const CopiedColumn& column : columns_) names.push_back(column.name);
    return fmt::format("{}", fmt::join(names, ", "));
  }

  /// Of a trial that was there its conditions were, too.
  const char* on_conflict() const {
    return table_ == "trial_condition" || table_ == "trial_setting" || table_ == "carried_out" ||
                   table_ == "unfinished_diagnosis"
               ? "IGNORE"
               : "ABORT";
  }

  int position(const char* name) const {
    const auto found =
        std::find_if(columns_.begin(), columns_.end(), [&](const CopiedColumn& c) { return c.name == name; });
    return static_cast<int>(found - columns_.begin());
  }

  /// Rows of runs that the database has, and what it has of that which runs share, stay as they are there.
  bool is_to_be_copied() {
    if (Renumbering::is_shared(table_)) {
      const auto key = numbers_.shared(table_, rows_.integer(position("id")));
      return key && numbers_.is_new(table_, *key);
    }
    if (rule_.owner == RowOwner::number) return numbers_.run(rows_.integer(position(rule_.column))).has_value();
    const std::string shared = table_ == "unfinished_diagnosis" ? "revision" : "trial";
    if (rule_.owner == RowOwner::used || table_ == "trial_setting")
      return numbers_.shared(shared, rows_.integer(position(shared.c_str()))).has_value();
    return numbers_.key(rows_.integer(position(rule_.column))).has_value();
  }

  void give_row() {
    for (int i = 0; i < static_cast<int>(columns_.size()); ++i) {
      const CopiedColumn& column = columns_[static_cast<std::size_t>(i)];
      if (column.meaning == Meaning::later) continue;
      if (column.meaning == Meaning::value || rows_.null(i)) {
        insert_.take(i + 1, rows_, i);
      } else if (column.meaning == Meaning::trial_name) {
        give_trial_name(i);
      } else if (const auto renumbered = renumber(column, rows_.integer(i))) {
        insert_.give(i + 1, *renumbered);
      } else {
        throw Error(
            fmt::format("{}: a row of {} refers to {} {}, which the target database has in an earlier state; merge "
                        "into a new database",
                        shard_.file().string(), table_, column.name, rows_.integer(i)));
      }
    }
  }

  void give_trial_name(int i) {
    const std::string* const name = numbers_.trial_name(own_key().value_or(0));
    name ? insert_.give(i + 1, *name) : insert_.take(i + 1, rows_, i);
  }

  std::optional<std::int64_t> renumber(const CopiedColumn& column, std::int64_t old) {
    switch (column.meaning) {
      case Meaning::run: return numbers_.run(old);
      case Meaning::key: return numbers_.key(old);
      case Meaning::shared: return numbers_.shared(column.table, old);
      case Meaning::revision_number: return numbers_.needed(numbers_.revision_number(numbers_.needed(own_key())));
      case Meaning::look_number: return look_number(old);
      case Meaning::trial_name:
      case Meaning::later:
      case Meaning::value: break;
    }
    return old;
  }

  std::optional<std::int64_t> own_key() { return numbers_.shared(table_, rows_.integer(position("id"))); }

  std::optional<std::int64_t> look_number(std::int64_t old) {
    std::int64_t experiment = 0;
    if (table_ == "holdout_look") {
      experiment = rows_.integer(position("experiment"));
    } else {
      const bool is_there = experiment_of_revision_.with(rows_.integer(position("revision"))).step();
      experiment = numbers_.needed(is_there ? std::optional(experiment_of_revision_.integer(0)) : std::nullopt);
    }
    return numbers_.needed(numbers_.look_number(numbers_.needed(numbers_.shared("experiment", experiment)), old));
  }

  /// What was measured in a trial is stored once, whichever runs use it.
  bool is_measured_already() {
    if (table_ != "trace" || !rows_.null(position("comparison")) || !rows_.null(position("model"))) return false;
    const std::int64_t trial = numbers_.needed(numbers_.shared("trial", rows_.integer(position("trial"))));
    return !numbers_.is_new("trial", trial) &&
           same_trace_.with(trial, rows_.text(position("kind")), rows_.text(position("digest"))).step();
  }

  const Database& shard_;
  const Renumbering& numbers_;
  TableOfRuns rule_;
  std::string table_;
  std::vector<CopiedColumn> columns_;
  Statement rows_, insert_, same_trace_, experiment_of_revision_;
};

/// Passes come before their models and tests, which refer to them.
void name_best(const Database& shard, Database& into, const Renumbering& numbers) {
  Statement update(into, "UPDATE pass SET best_model = ?, best_test = ? WHERE id = ?");
  Statement row(shard, "SELECT id, best_model, best_test FROM pass");
  const auto renumbered = [&](int column) {
    return row.null(column) ? std::nullopt : numbers.key(row.integer(column));
  };
  while (row.step())
    if (const auto pass = renumbered(0)) update.run_with(renumbered(1), renumbered(2), *pass);
}

bool was_sealed(const Database& shard, std::int64_t run) {
  Statement seal(shard, "SELECT 1 FROM seal WHERE run = ? LIMIT 1");
  return seal.with(run).step();
}

}  // namespace

void copy_runs(const Database& shard, Database& into, const Renumbering& numbers) {
  for (const TableOfRuns& table : run_tables()) TableCopy(shard, into, numbers, table).run();
  TableCopy(shard, into, numbers, {"unfinished_diagnosis", "", RowOwner::used}).run();
  name_best(shard, into, numbers);
  for (const auto& [old, number] : numbers.runs())
    if (was_sealed(shard, old)) seal_run(into, RunId{number});
}

}  // namespace lacuna

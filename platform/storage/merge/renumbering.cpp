#include "storage/merge/renumbering.h"

#include "storage/integrity/row_key.h"
#include "storage/core/statement.h"
#include "storage/eea/eea_names.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace lacuna {
namespace {

struct SharedTable {
  const char* name;
  std::vector<const char*> content;  ///< columns that tell its rows; `experiment` is a key itself
};

/// Those that others refer to come first.
const std::vector<SharedTable>& shared_tables() {
  static const std::vector<SharedTable> tables = {{"experiment", {"name"}},
                                                  {"metric", {"name"}},
                                                  {"experiment_text", {"experiment", "digest"}},
                                                  {"revision", {"experiment", "digest"}},
                                                  {"trial", {"experiment", "digest", "name", "held_out"}}};
  return tables;
}

const SharedTable& shared_table(const std::string& name) {
  return *std::find_if(shared_tables().begin(), shared_tables().end(), [&](const auto& t) { return t.name == name; });
}

std::int64_t last_key_of(const Database& into, const std::string& table) {
  Statement largest(into, fmt::format("SELECT coalesce(max(id), 0) FROM {}", table).c_str());
  largest.step();
  return largest.integer(0);
}

std::map<std::int64_t, std::int64_t> last_numbers(const Database& into, const char* table) {
  std::map<std::int64_t, std::int64_t> last;
  Statement row(into, fmt::format("SELECT experiment, max(number) FROM {} GROUP BY experiment", table).c_str());
  while (row.step()) last[row.integer(0)] = row.integer(1);
  return last;
}

}  // namespace

Renumbering::Renumbering(const Database& shard, const Database& into) : file_(shard.file()) {
  find_runs(shard, into);
  find_tests(shard);
  for (const SharedTable& table : shared_tables()) find_rows(shard, into, table.name);
  number_revisions(shard, into);
  number_looks(shard, into);
}

void Renumbering::find_runs(const Database& shard, const Database& into) {
  Statement last(into, "SELECT coalesce(max(number), 0) FROM run");
  last.step();
  std::int64_t number = last.integer(0);
  Statement known(into, "SELECT 1 FROM run WHERE identity = ?");
  Statement run(shard, "SELECT number, identity FROM run ORDER BY number");
  while (run.step())
    if (!known.with(run.text(1)).step()) runs_[run.integer(0)] = ++number;
}

/// A trial in which a run carried out a test belongs to this run alone, and is named after it.
void Renumbering::find_tests(const Database& shard) {
  Table& trials = tables_["trial"];
  Statement row(shard, "SELECT trial, run, number FROM target_trial WHERE test IS NOT NULL");
  while (row.step()) {
    const auto renumbered = key(row.integer(0));
    if (!renumbered) continue;
    trials.keys[row.integer(0)] = *renumbered;
    trials.added.insert(*renumbered);
    trial_names_[*renumbered] = name_of_test_trial(RunId{needed(run(row.integer(1)))}, row.integer(2));
  }
}

bool Renumbering::give_content(Statement& row, const std::vector<const char*>& columns, Statement& same) const {
  same.begin_again();
  for (int i = 1; i <= static_cast<int>(columns.size()); ++i) {
    if (columns[static_cast<std::size_t>(i - 1)] != std::string("experiment")) {
      same.take(i, row, i);
    } else if (const auto experiment = shared("experiment", row.integer(i))) {
      same.give(i, *experiment);
    } else {
      return false;
    }
  }
  return true;
}

void Renumbering::find_rows(const Database& shard, const Database& into, const std::string& table) {
  const std::vector<const char*>& content = shared_table(table).content;
  Table& found = tables_[table];
  Statement row(shard, fmt::format("SELECT id, {} FROM {} ORDER BY id", fmt::join(content, ", "), table).c_str());
  Statement same(into, fmt::format("SELECT id FROM {} WHERE {} = ?", table, fmt::join(content, " = ? AND ")).c_str());
  std::int64_t last = last_key_of(into, table);
  while (row.step()) {
    if (found.keys.contains(row.integer(0)) || !give_content(row, content, same)) continue;
    if (same.step()) {
      found.keys[row.integer(0)] = same.integer(0);
    } else if (const auto added = table == "metric" ? std::optional(++last) : key(row.integer(0))) {
      found.keys[row.integer(0)] = *added;
      found.added.insert(*added);
    }
  }
}

std::optional<std::int64_t> Renumbering::run(std::int64_t number) const {
  const auto found = runs_.find(number);
  return found == runs_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::int64_t> Renumbering::key(std::int64_t key) const {
  const std::int64_t owner = key >> kCounterBits;
  const auto renumbered = run(owner);
  if (!renumbered) return std::nullopt;
  return key - key_base(RunId{owner}) + key_base(RunId{*renumbered});
}

std::optional<std::int64_t> Renumbering::shared(const std::string& table, std::int64_t key) const {
  const Table& rows = tables_.at(table);
  const auto found = rows.keys.find(key);
  return found == rows.keys.end() ? std::nullopt : std::optional(found->second);
}

std::int64_t Renumbering::needed(const std::optional<std::int64_t>& renumbered) const {
  if (renumbered) return *renumbered;
  throw Error(file_.string() + ": has a row that refers to a missing row; make the shard again");
}

std::optional<std::int64_t> Renumbering::revision_number(std::int64_t key) const {
  const auto found = revision_numbers_.find(key);
  return found == revision_numbers_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::int64_t> Renumbering::look_number(std::int64_t experiment, std::int64_t number) const {
  const auto found = look_numbers_.find({experiment, number});
  return found == look_numbers_.end() ? std::nullopt : std::optional(found->second);
}

bool Renumbering::is_shared(const std::string& table) {
  return std::any_of(shared_tables().begin(), shared_tables().end(), [&](const auto& t) { return t.name == table; });
}

const std::string* Renumbering::trial_name(std::int64_t key) const {
  const auto found = trial_names_.find(key);
  return found == trial_names_.end() ? nullptr : &found->second;
}

bool Renumbering::is_new(const std::string& table, std::int64_t key) const {
  return tables_.at(table).added.contains(key);
}

void Renumbering::number_revisions(const Database& shard, const Database& into) {
  auto last = last_numbers(into, "revision");
  Statement row(shard, "SELECT id, experiment FROM revision ORDER BY experiment, number");
  while (row.step()) {
    const auto key = shared("revision", row.integer(0));
    if (key && is_new("revision", *key)) revision_numbers_[*key] = ++last[needed(shared("experiment", row.integer(1)))];
  }
}

void Renumbering::number_looks(const Database& shard, const Database& into) {
  auto last = last_numbers(into, "holdout_look");
  Statement row(shard, "SELECT id, experiment, number FROM holdout_look ORDER BY experiment, number");
  while (row.step()) {
    if (!key(row.integer(0))) continue;
    const std::int64_t experiment = needed(shared("experiment", row.integer(1)));
    look_numbers_[{experiment, row.integer(2)}] = ++last[experiment];
  }
}

}  // namespace lacuna

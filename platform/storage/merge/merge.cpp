#include "storage/merge/merge.h"

#include "foundation/interrupt.h"
#include "foundation/plain_text.h"
#include "foundation/problem.h"
#include "storage/core/migrate.h"
#include "storage/core/one_state.h"
#include "storage/core/row_key.h"
#include "storage/core/run_claim.h"
#include "storage/core/run_rows.h"
#include "storage/core/seal.h"
#include "storage/core/statement.h"
#include "storage/files/log_left.h"
#include "storage/merge/copy_runs.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>

namespace lacuna {
namespace {

/// A plugin's file as an experiment's runs used it, and who did so first.
struct UsedPlugin {
  std::string sha256;
  std::string user;  ///< "run 3 of small in all.db"
};
using UsedPlugins = std::map<std::pair<std::string, std::string>, UsedPlugin>;  // by experiment, name of the file

constexpr const char* kUsedPlugins =
    "SELECT experiment.name, plugin_file.file, plugin_file.sha256, run.number FROM plugin_file"
    " JOIN run ON run.number = plugin_file.run JOIN experiment_text ON experiment_text.id = run.experiment_text"
    " JOIN experiment ON experiment.id = experiment_text.experiment ORDER BY run.number, plugin_file.file";

/// `problems`: null where what the database has is taken as it is.
void check_plugins(const Database& database, UsedPlugins& used, ProblemList* problems) {
  Statement row(database, kUsedPlugins);
  while (row.step()) {
    const std::string experiment = row.text(0), name = std::filesystem::path(row.text(1)).filename().string();
    const std::string user = fmt::format("run {} of {} in {}", row.integer(3), experiment, database.file().string());
    const auto [first, is_first] = used.try_emplace({experiment, name}, UsedPlugin{row.text(2), user});
    if (is_first || first->second.sha256 == row.text(2) || !problems) continue;
    problems->add({database.file().string()},
                  plain_text(fmt::format("{} used another build of {} than {}; merge them into separate "
                                         "databases",
                                         user, name, first->second.user)));
  }
}

void check_seals(const Database& shard, ProblemList& problems) {
  for (const BrokenSeal& broken : lacuna::check_seals(shard).broken)
    problems.add({shard.file().string()},
                 fmt::format("run {}, table {}: not what the run ended with: {}; make the shard anew", broken.run.value,
                             broken.table, plain_text(broken.reason)));
}

/// How many rows a run has in tables that are its alone.
std::int64_t own_rows(const Database& database, std::int64_t run) {
  std::int64_t rows = 0;
  for (const TableOfRuns& table : run_tables()) {
    const std::string name = table.name;
    if (Renumbering::is_shared(name) || name == "trace" || name == "trial_setting" || table.owner == RowOwner::used)
      continue;
    Statement count(database, fmt::format("SELECT count(*) FROM {} WHERE {}", name, rows_of_run(table)).c_str());
    table.owner == RowOwner::key ? count.with(key_base(RunId{run}), last_key(RunId{run})) : count.with(run);
    count.step();
    rows += count.integer(0);
  }
  return rows;
}

/// A run that the database has is left as it is, which must not hide that the shard has more of it.
void check_known_runs(const Database& into, const Database& shard, ProblemList& problems) {
  Statement there(into, "SELECT number, ended FROM run WHERE identity = ? AND coalesce(ending, '') <> 'done'");
  Statement run(shard, "SELECT number, identity, ended FROM run");
  while (run.step()) {
    if (!there.with(run.text(1)).step()) continue;
    if (there.text(1) == run.text(2) && own_rows(into, there.integer(0)) == own_rows(shard, run.integer(0))) continue;
    problems.add({shard.file().string()},
                 fmt::format("run {} is run {} of {}, which has an earlier state of it; merge into a new database",
                             run.integer(0), there.integer(0), into.file().string()));
  }
}

/// A merge would keep a process that writes to the database waiting for too long.
void check_no_run_is_carried_out(Database& into, ProblemList& problems) {
  std::vector<RunId> open;
  Statement run(into, "SELECT number FROM run JOIN eea_run ON eea_run.run = run.number WHERE ended IS NULL");
  while (run.step()) open.push_back({run.integer(0)});
  for (const RunId one : open)
    if (!RunClaim(into, one).held())
      problems.add({into.file().string()},
                   fmt::format("run {} is being carried out; merge when it has ended", one.value));
}

std::string text_of_table(const Database& database, const std::string& name) {
  Statement table(database, "SELECT sql FROM sqlite_schema WHERE type = 'table' AND name = ?");
  return table.with(name).step() ? table.text(0) : "";
}

/// What is taken for granted of tables, such as their references, their own text says.
void check_tables(const Database& shard, ProblemList& problems) {
  Database blank = Database::open_blank();
  bring_up_to_date(blank, schema_migrations());
  for (const TableOfRuns& table : run_tables())
    if (text_of_table(shard, table.name) != text_of_table(blank, table.name))
      problems.add({shard.file().string()},
                   fmt::format("table {} is not as this program makes it; make the shard anew", table.name));
}

void check_references(const Database& shard, ProblemList& problems) {
  std::set<std::pair<std::string, std::string>> told;
  Statement broken(shard, "PRAGMA foreign_key_check");
  while (broken.step())
    if (told.emplace(broken.text(0), broken.text(2)).second)
      problems.add({shard.file().string()},
                   plain_text(fmt::format("a row of {} refers to a row of {} that is not there; make the shard anew",
                                          broken.text(0), broken.text(2))));
}

/// Every problem of every shard, before anything is written.
void check(Database& into, const std::vector<std::filesystem::path>& shards) {
  ProblemList problems;
  UsedPlugins used;
  check_plugins(into, used, nullptr);
  check_no_run_is_carried_out(into, problems);
  for (const std::filesystem::path& file : shards) try {
      const LogLeft log(file);
      const Database shard = Database::open_read_only(file);
      hold_one_state(shard);
      check_tables(shard, problems);
      check_references(shard, problems);
      check_seals(shard, problems);
      check_known_runs(into, shard, problems);
      check_plugins(shard, used, &problems);
    } catch (const Interrupted&) {
      throw;
    } catch (const BadInput& unusable) {
      for (const Problem& problem : unusable.problems()) problems.add(problem);
    } catch (const Error& unusable) {
      problems.add({}, unusable.what());
    }
  problems.throw_if_any();
}

MergedShard merge_one(Database& into, const std::filesystem::path& file) {
  const LogLeft log(file);
  const Database shard = Database::open_read_only(file);
  hold_one_state(shard);
  MergedShard merged;
  Transaction transaction(into);
  const Renumbering numbers(shard, into);
  copy_runs(shard, into, numbers);
  transaction.commit();
  for (const auto& [old, number] : numbers.runs()) merged.added.push_back({number});
  Statement run(shard, "SELECT number FROM run ORDER BY number");
  while (run.step())
    if (!numbers.run(run.integer(0))) merged.known.push_back({run.integer(0)});
  return merged;
}

}  // namespace

std::vector<MergedShard> merge(Database& into, const std::vector<std::filesystem::path>& shards,
                               const std::function<void(double)>& progress) {
  check(into, shards);
  std::vector<MergedShard> merged;
  for (const std::filesystem::path& shard : shards) {
    merged.push_back(merge_one(into, shard));
    if (progress) progress(static_cast<double>(merged.size()) / static_cast<double>(shards.size()));
  }
  return merged;
}

}  // namespace lacuna

#include "storage/merge/merge.h"

#include "foundation/processes/stop.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "storage/core/one_state.h"
#include "storage/integrity/row_key.h"
#include "storage/core/run_claim.h"
#include "storage/integrity/run_rows.h"
#include "storage/core/schema_check.h"
#include "storage/integrity/seal.h"
#include "storage/core/statement.h"
#include "storage/core/storage_error.h"
#include "storage/files/log_left.h"
#include "storage/merge/copy_runs.h"

#include <fmt/format.h>

#include <functional>
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

/// `problems`: null for the database itself, which is not checked.
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
                 fmt::format("run {}, table {}: changed since the run ended: {}; make the shard again",
                             broken.run.value, broken.table, plain_text(broken.reason)));
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

/// A run that is not done.
struct OpenRun {
  std::string user;   ///< "run 3 of all.db"
  std::string ended;  ///< when; empty: it has not
  std::function<std::int64_t()> rows;
  const char* advice;
};
using OpenRuns = std::map<std::string, OpenRun>;  // by identity

/// `add`: takes the number, the identity, the name and the end of each.
template <class Add>
void for_open_runs(const Database& database, const Add& add) {
  Statement run(database, "SELECT number, identity, ended FROM run WHERE coalesce(ending, '') <> 'done'");
  while (run.step())
    add(run.integer(0), run.text(1), fmt::format("run {} of {}", run.integer(0), database.file().string()),
        run.text(2));
}

/// Of the database that others are merged into, which outlives what is returned.
OpenRuns open_runs(const Database& into) {
  OpenRuns known;
  for_open_runs(into, [&](std::int64_t number, const std::string& identity, std::string user, std::string ended) {
    known[identity] = {std::move(user), std::move(ended), [&into, number] { return own_rows(into, number); },
                       "merge into a new database"};
  });
  return known;
}

/// Of a shard that comes before others. Those that are known already stay.
void add_open_runs(const Database& shard, OpenRuns& known) {
  for_open_runs(shard, [&](std::int64_t number, const std::string& identity, std::string user, std::string ended) {
    if (known.contains(identity)) return;
    known[identity] = {std::move(user), std::move(ended), [rows = own_rows(shard, number)] { return rows; },
                       "leave out that one"};
  });
}

/// A run that is known is left as it is, which must not hide that the shard has more of it.
void check_known_runs(const OpenRuns& known, const Database& shard, ProblemList& problems) {
  Statement run(shard, "SELECT number, identity, ended FROM run");
  while (run.step()) {
    const auto there = known.find(run.text(1));
    if (there == known.end()) continue;
    const auto& [user, ended, rows, advice] = there->second;
    if (ended != run.text(2) || rows() != own_rows(shard, run.integer(0)))
      problems.add({shard.file().string()},
                   fmt::format("run {} is also {}, in an earlier state; {}", run.integer(0), user, advice));
  }
}

/// A merge would keep a process that writes to the database waiting for too long.
void check_no_run_is_carried_out(Database& into) {
  std::vector<RunId> open;
  Statement run(into, "SELECT number FROM run JOIN eea_run ON eea_run.run = run.number WHERE ended IS NULL");
  while (run.step()) open.push_back({run.integer(0)});
  const std::vector<ForeignClaim> silent = silent_claims(into, open);
  ProblemList problems;
  for (const RunId one : open)
    if (!RunClaim(into, one, silent).held())
      problems.add({into.file().string()}, fmt::format("run {} is not finished; merge after it has ended", one.value));
  problems.throw_if_any();
}

/// What is taken for granted of tables, such as their references, their own text says.
void check_schema(const Database& shard, ProblemList& problems) {
  for (const std::string& name : changed_schema(shard))
    problems.add({shard.file().string()}, name + " differs from the one that this program makes; make the shard again");
}

void check_references(const Database& shard, ProblemList& problems) {
  std::set<std::pair<std::string, std::string>> told;
  Statement broken(shard, "PRAGMA foreign_key_check");
  while (broken.step())
    if (told.emplace(broken.text(0), broken.text(2)).second)
      problems.add({shard.file().string()},
                   plain_text(fmt::format("a row of {} refers to a missing row of {}; make the shard again",
                                          broken.text(0), broken.text(2))));
}

/// Contents of the database and of the earlier shards, with which the next shard is compared.
struct Known {
  UsedPlugins plugins;
  OpenRuns runs;
};

/// Reports every problem of a shard. If there is none, adds its contents to the known ones.
MergedShard looked_at(const std::filesystem::path& file, const Stop& stop, Known& known) {
  ProblemList problems;
  MergedShard looked;
  Known with = known;
  try {
    const LogLeft log(file);
    const Database shard = Database::open_read_only(file, stop);
    hold_one_state(shard);
    check_schema(shard, problems);
    check_references(shard, problems);
    check_seals(shard, problems);
    looked.is_unsound = !problems.empty();
    check_known_runs(known.runs, shard, problems);
    check_plugins(shard, with.plugins, &problems);
    add_open_runs(shard, with.runs);
  } catch (const Interrupted&) {
    throw;
  } catch (const BadInput& unusable) {
    for (const Problem& problem : unusable.problems()) problems.add(problem);
  } catch (const DamagedDatabase& damaged) {
    looked.is_unsound = true;
    problems.add({}, damaged.what());
  } catch (const Error& unusable) {
    problems.add({}, unusable.what());
  }
  if (problems.empty()) known = std::move(with);
  looked.problems = problems.all();
  return looked;
}

/// The problems of each shard, before anything is written.
std::vector<MergedShard> looked_at(const Database& into, const std::vector<Shard>& shards) {
  Known known{.plugins = {}, .runs = open_runs(into)};
  check_plugins(into, known.plugins, nullptr);
  std::vector<MergedShard> all;
  all.reserve(shards.size());
  for (const Shard& shard : shards) all.push_back(looked_at(shard.file, into.stop(), known));
  return all;
}

/// Of the shards that refuse the merge.
void throw_problems(const std::vector<Shard>& shards, const std::vector<MergedShard>& looked) {
  ProblemList problems;
  for (std::size_t i = 0; i < shards.size(); ++i)
    if (shards[i].unusable == Unusable::refuses_all)
      for (const Problem& problem : looked[i].problems) problems.add(problem);
  problems.throw_if_any();
}

void merge_one(Database& into, const std::filesystem::path& file, MergedShard& merged) {
  const LogLeft log(file);
  const Database shard = Database::open_read_only(file, into.stop());
  hold_one_state(shard);
  ProblemList problems;
  check_known_runs(open_runs(into), shard, problems);  // it may be another file by now
  merged.problems = problems.all();
  if (!problems.empty()) return;
  Transaction transaction(into);
  const Renumbering numbers(shard, into);
  copy_runs(shard, into, numbers);
  transaction.commit();
  for (const auto& [old, number] : numbers.runs()) merged.added.push_back({number});
  Statement run(shard, "SELECT number FROM run ORDER BY number");
  while (run.step())
    if (!numbers.run(run.integer(0))) merged.known.push_back({run.integer(0)});
}

}  // namespace

std::vector<MergedShard> merge(Database& into, const std::vector<Shard>& shards,
                               const std::function<void(double)>& progress) {
  check_no_run_is_carried_out(into);
  std::vector<MergedShard> all = looked_at(into, shards);
  throw_problems(shards, all);
  for (std::size_t i = 0; i < shards.size(); ++i) {
    if (all[i].problems.empty()) merge_one(into, shards[i].file, all[i]);
    throw_problems({shards[i]}, {all[i]});
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(shards.size()));
  }
  return all;
}

}  // namespace lacuna

#include "storage/merge/merge.h"

#include "foundation/plain_text.h"
#include "foundation/problem.h"
#include "storage/core/seal.h"
#include "storage/core/statement.h"
#include "storage/files/log_left.h"
#include "storage/merge/copy_runs.h"

#include <fmt/format.h>

#include <map>
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

void check_plugins(const Database& database, UsedPlugins& used, ProblemList& problems) {
  Statement row(database, kUsedPlugins);
  while (row.step()) {
    const std::string experiment = row.text(0), name = std::filesystem::path(row.text(1)).filename().string();
    const std::string user = fmt::format("run {} of {} in {}", row.integer(3), experiment, database.file().string());
    const auto [first, is_first] = used.try_emplace({experiment, name}, UsedPlugin{row.text(2), user});
    if (is_first || first->second.sha256 == row.text(2)) continue;
    problems.add({database.file().string()},
                 plain_text(fmt::format("{} used another build of {} than {}; results of different programs stay in "
                                        "different databases",
                                        user, name, first->second.user)));
  }
}

void check_seals(const Database& shard, ProblemList& problems) {
  for (const BrokenSeal& broken : lacuna::check_seals(shard).broken)
    problems.add({shard.file().string()},
                 fmt::format("run {}, table {}: not what the run ended with: {}; make the shard anew", broken.run.value,
                             broken.table, plain_text(broken.reason)));
}

/// Every problem of every shard, before anything is written.
void check(const Database& into, const std::vector<std::filesystem::path>& shards) {
  ProblemList problems;
  UsedPlugins used;
  check_plugins(into, used, problems);
  for (const std::filesystem::path& file : shards) try {
      const LogLeft log(file);
      const Database shard = Database::open_read_only(file);
      check_seals(shard, problems);
      check_plugins(shard, used, problems);
    } catch (const BadInput& unusable) {
      for (const Problem& problem : unusable.problems()) problems.add(problem);
    }
  problems.throw_if_any();
}

MergedShard merge_one(Database& into, const std::filesystem::path& file) {
  const LogLeft log(file);
  const Database shard = Database::open_read_only(file);
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

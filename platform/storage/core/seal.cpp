#include "storage/core/seal.h"

#include "foundation/digest.h"
#include "foundation/interrupt.h"
#include "storage/core/row_key.h"
#include "storage/core/statement.h"

#include <lacuna/error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <optional>

namespace lacuna {
namespace {

/// How the rows of a run are told: by a column that has its number, by one whose upper bits have it (row_key.h), or by
/// a condition, for what several runs share: those that the run uses.
enum class Owner { number, key, used };

struct Part {
  const char* table;
  const char* column;  ///< or the condition, ?1 the run's number
  Owner owner;
};

/// A later run may add the conditions of a trial that an earlier one has stored without.
constexpr const char* kUsedTrials =
    "trial IN (SELECT trial FROM target_trial WHERE run = ?1 UNION SELECT trial FROM carried_out WHERE run = ?1)";
constexpr const char* kUsedMetrics =
    "id IN (SELECT metric FROM eea_run WHERE run = ?1 UNION SELECT fitness FROM eea_run WHERE run = ?1)";

/// Not here: what changes after a run has ended (`unfinished_diagnosis`, `schema_text`), and `claim`, which ends with
/// it.
constexpr Part kParts[] = {{"run", "number", Owner::number},
                           {"provenance", "run", Owner::number},
                           {"plugin_file", "run", Owner::number},
                           {"robot_file", "run", Owner::number},
                           {"experiment", "id", Owner::key},
                           {"experiment_text", "id", Owner::key},
                           {"revision", "id", Owner::key},
                           {"revision_use", "run", Owner::number},
                           {"trial", "id", Owner::key},
                           {"trial_condition", kUsedTrials, Owner::used},
                           {"trial_setting", "trial", Owner::key},
                           {"carried_out", "run", Owner::number},
                           {"failed_trial", "run", Owner::number},
                           {"trace", "id", Owner::key},
                           {"fit", "id", Owner::key},
                           {"fit_stage", "fit", Owner::key},
                           {"fitted_value", "fit", Owner::key},
                           {"holdout_look", "id", Owner::key},
                           {"comparison", "id", Owner::key},
                           {"comparison_score", "comparison", Owner::key},
                           {"noise_floor", "comparison", Owner::key},
                           {"numerical_error", "comparison", Owner::key},
                           {"where_it_fails", "comparison", Owner::key},
                           {"work_time", "id", Owner::key},
                           {"diagnosis", "id", Owner::key},
                           {"candidate_model", "diagnosis", Owner::key},
                           {"candidate_value", "diagnosis", Owner::key},
                           {"eea_run", "run", Owner::number},
                           {"free_value", "run", Owner::number},
                           {"pass", "run", Owner::number},
                           {"best_value", "pass", Owner::key},
                           {"objective_score", "pass", Owner::key},
                           {"ensemble_model", "pass", Owner::key},
                           {"ensemble_value", "pass", Owner::key},
                           {"set_aside", "pass", Owner::key},
                           {"test", "id", Owner::key},
                           {"test_score", "test", Owner::key},
                           {"invalid_test", "test", Owner::key},
                           {"target_trial", "run", Owner::number},
                           {"model", "id", Owner::key},
                           {"model_score", "model", Owner::key},
                           {"invalid_model", "model", Owner::key},
                           {"checkpoint", "run", Owner::number},
                           {"metric", kUsedMetrics, Owner::used}};

struct Columns {
  std::vector<std::string> all;
  std::vector<std::string> key;  ///< the primary key, in its order
};

Columns columns_of(const Database& database, const char* table) {
  enum Field { kName = 1, kKey = 5 };
  Columns columns;
  std::map<int, std::string> key;
  Statement row(database, fmt::format("PRAGMA table_info({})", table).c_str());
  while (row.step()) {
    columns.all.push_back(row.text(kName));
    if (row.number(kKey) > 0) key[row.number(kKey)] = row.text(kName);
  }
  for (const auto& [position, name] : key) columns.key.push_back(name);
  return columns;
}

std::string condition(const Part& part) {
  if (part.owner == Owner::used) return part.column;
  return part.owner == Owner::number ? fmt::format("{} = ?1", part.column)
                                     : fmt::format("{} BETWEEN ?1 AND ?2", part.column);
}

struct SealedRows {
  std::int64_t rows = 0;
  std::string sha256;
  bool operator==(const SealedRows&) const = default;
};

/// `columns`: those that were there when the run ended; later versions may have more.
SealedRows hash_rows(const Database& database, RunId run, const Part& part, const std::vector<std::string>& columns,
                     const std::vector<std::string>& key) {
  constexpr std::size_t kBlock = 1U << 20U;
  Statement row(database, fmt::format("SELECT {} FROM {} WHERE {} ORDER BY {}", fmt::join(columns, ", "), part.table,
                                      condition(part), fmt::join(key, ", "))
                              .c_str());
  part.owner == Owner::key ? row.with(key_base(run), last_key(run)) : row.with(run);
  Sha256 hash;
  SealedRows content;
  std::string bytes;
  for (; row.step(); ++content.rows) {
    for (int column = 0; column < row.columns(); ++column) row.append_bits(column, bytes);
    if (bytes.size() < kBlock) continue;
    throw_if_asked_to_stop();
    hash.add(bytes);
    bytes.clear();
  }
  hash.add(bytes);
  content.sha256 = hash.hex();
  return content;
}

struct Seal {
  std::vector<std::string> columns;
  SealedRows content;
};

/// By table. What cannot be read as a seal has no columns.
std::map<std::string, Seal> seals_of(const Database& database, RunId run) {
  std::map<std::string, Seal> seals;
  Statement row(database, "SELECT part, columns, rows, sha256 FROM seal WHERE run = ?");
  row.with(run);
  while (row.step()) {
    const nlohmann::json columns = nlohmann::json::parse(row.text(1), nullptr, false);
    Seal& seal = seals[row.text(0)];
    seal.content = {row.integer(2), row.text(3)};
    if (columns.is_array() && std::all_of(columns.begin(), columns.end(), [](const auto& c) { return c.is_string(); }))
      seal.columns = columns.get<std::vector<std::string>>();
  }
  return seals;
}

/// Why the rows are not those of the seal; nothing where they are.
std::optional<std::string> fault_of(const Database& database, RunId run, const Part& part, const Seal* seal) try {
  const Columns now = columns_of(database, part.table);
  const auto is_known = [&](const std::string& name) {
    return std::find(now.all.begin(), now.all.end(), name) != now.all.end();
  };
  if (seal && (seal->columns.empty() || !std::all_of(seal->columns.begin(), seal->columns.end(), is_known)))
    return "its seal is damaged";
  const SealedRows content = hash_rows(database, run, part, seal ? seal->columns : now.all, now.key);
  const std::int64_t sealed = seal ? seal->content.rows : 0;
  if (content.rows != sealed) return fmt::format("{} rows, {} were sealed", content.rows, sealed);
  if (seal && content.sha256 != seal->content.sha256) return "other content";
  return std::nullopt;
} catch (const Interrupted&) {
  throw;
} catch (const Error& unreadable) {
  return unreadable.what();
}

void check_run(const Database& database, RunId run, std::map<std::string, Seal> seals, SealCheck& check) {
  for (const Part& part : kParts) {
    const auto seal = seals.find(part.table);
    if (const auto fault = fault_of(database, run, part, seal == seals.end() ? nullptr : &seal->second))
      check.broken.push_back({run, part.table, *fault});
    if (seal != seals.end()) seals.erase(seal);
  }
  for (const auto& [name, seal] : seals) check.broken.push_back({run, name, "sealed, but no such table"});
}

}  // namespace

void seal_run(Database& database, RunId run) {
  unseal_run(database, run);
  Statement insert(database, "INSERT INTO seal (run, part, columns, rows, sha256) VALUES (?, ?, ?, ?, ?)");
  for (const Part& part : kParts) {
    const Columns columns = columns_of(database, part.table);
    const SealedRows content = hash_rows(database, run, part, columns.all, columns.key);
    if (content.rows > 0)
      insert.run_with(run, part.table, nlohmann::json(columns.all).dump(), content.rows, content.sha256);
  }
}

void unseal_run(Database& database, RunId run) { Statement(database, "DELETE FROM seal WHERE run = ?").run_with(run); }

SealCheck check_seals(const Database& database, const std::function<void(double)>& progress) {
  SealCheck check;
  std::map<std::int64_t, bool> ended;
  Statement runs(database, "SELECT number, ended IS NOT NULL FROM run ORDER BY number");
  while (runs.step()) ended[runs.integer(0)] = runs.flag(1);
  double done = 0.0;
  for (const auto& [number, has_ended] : ended) {
    const RunId run{number};
    std::map<std::string, Seal> seals = seals_of(database, run);
    if (!seals.empty()) {
      check.sealed.push_back(run);
      check_run(database, run, std::move(seals), check);
    } else {
      (has_ended ? check.ended_unsealed : check.not_ended).push_back(run);
    }
    if (progress) progress(++done / static_cast<double>(ended.size()));
  }
  Statement strays(database, "SELECT DISTINCT run FROM seal WHERE run NOT IN (SELECT number FROM run)");
  while (strays.step()) check.broken.push_back({RunId{strays.integer(0)}, "run", "0 rows, 1 was sealed"});
  return check;
}

std::vector<std::string> sealed_tables() {
  std::vector<std::string> names;
  for (const Part& part : kParts) names.emplace_back(part.table);
  return names;
}

}  // namespace lacuna

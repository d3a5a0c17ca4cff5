#include "storage/integrity/run_rows.h"

#include "storage/core/statement.h"

#include <fmt/format.h>

#include <map>

namespace lacuna {
namespace {

/// A later run may add the conditions of a trial that an earlier one has stored without.
constexpr const char* kUsedTrials =
    "trial IN (SELECT trial FROM target_trial WHERE run = ?1 UNION SELECT trial FROM carried_out WHERE run = ?1)";
constexpr const char* kUsedMetrics =
    "id IN (SELECT metric FROM eea_run WHERE run = ?1 UNION SELECT fitness FROM eea_run WHERE run = ?1)";

constexpr TableOfRuns kTables[] = {{"experiment", "id", RowOwner::key},
                                   {"experiment_text", "id", RowOwner::key},
                                   {"metric", kUsedMetrics, RowOwner::used},
                                   {"run", "number", RowOwner::number},
                                   {"provenance", "run", RowOwner::number},
                                   {"plugin_file", "run", RowOwner::number},
                                   {"robot_file", "run", RowOwner::number},
                                   {"revision", "id", RowOwner::key},
                                   {"revision_use", "run", RowOwner::number},
                                   {"trial", "id", RowOwner::key},
                                   {"trial_condition", kUsedTrials, RowOwner::used},
                                   {"trial_setting", "trial", RowOwner::key},
                                   {"carried_out", "run", RowOwner::number},
                                   {"failed_trial", "run", RowOwner::number},
                                   {"fit", "id", RowOwner::key},
                                   {"fit_stage", "fit", RowOwner::key},
                                   {"fitted_value", "fit", RowOwner::key},
                                   {"holdout_look", "id", RowOwner::key},
                                   {"comparison", "id", RowOwner::key},
                                   {"comparison_score", "comparison", RowOwner::key},
                                   {"noise_floor", "comparison", RowOwner::key},
                                   {"numerical_error", "comparison", RowOwner::key},
                                   {"where_it_fails", "comparison", RowOwner::key},
                                   {"work_time", "id", RowOwner::key},
                                   {"diagnosis", "id", RowOwner::key},
                                   {"candidate_model", "diagnosis", RowOwner::key},
                                   {"candidate_value", "diagnosis", RowOwner::key},
                                   {"eea_run", "run", RowOwner::number},
                                   {"free_value", "run", RowOwner::number},
                                   {"pass", "run", RowOwner::number},
                                   {"test", "id", RowOwner::key},
                                   {"test_score", "test", RowOwner::key},
                                   {"invalid_test", "test", RowOwner::key},
                                   {"target_trial", "run", RowOwner::number},
                                   {"model", "id", RowOwner::key},
                                   {"model_score", "model", RowOwner::key},
                                   {"invalid_model", "model", RowOwner::key},
                                   {"best_value", "pass", RowOwner::key},
                                   {"objective_score", "pass", RowOwner::key},
                                   {"ensemble_model", "pass", RowOwner::key},
                                   {"ensemble_value", "pass", RowOwner::key},
                                   {"set_aside", "pass", RowOwner::key},
                                   {"checkpoint", "run", RowOwner::number},
                                   {"trace", "id", RowOwner::key}};

}  // namespace

std::span<const TableOfRuns> run_tables() { return kTables; }

std::string rows_of_run(const TableOfRuns& table) {
  if (table.owner == RowOwner::used) return table.column;
  return table.owner == RowOwner::number ? fmt::format("{} = ?1", table.column)
                                         : fmt::format("{} BETWEEN ?1 AND ?2", table.column);
}

TableColumns columns_of(const Database& database, const std::string& table) {
  enum Field { kName = 1, kKey = 5 };
  TableColumns columns;
  std::map<int, std::string> key;
  Statement row(database, fmt::format("PRAGMA table_info({})", table).c_str());
  while (row.step()) {
    columns.all.push_back(row.text(kName));
    if (row.number(kKey) > 0) key[row.number(kKey)] = row.text(kName);
  }
  for (const auto& [position, name] : key) columns.key.push_back(name);
  return columns;
}

}  // namespace lacuna

#include "storage/core/statement.h"
#include "storage/eea/eea_store.h"

namespace lacuna {
namespace {

bool has_runs(const Database& database) {
  Statement table(database, "SELECT 1 FROM sqlite_master WHERE type = 'view' AND name = 'eea_runs'");
  return table.step();
}

}  // namespace

std::vector<EeaRunListing> eea_runs(const Database& database) {
  if (!has_runs(database)) return {};
  Statement row(
      database,
      "SELECT run, replicate, experiment, ending, passes_done, passes, best_score, models, evaluations,"
      " seconds, (SELECT identity FROM run WHERE run.number = eea_runs.run),"
      " (SELECT stopped FROM pass WHERE pass.run = eea_runs.run AND stopped IS NOT NULL) FROM eea_runs ORDER BY run");
  std::vector<EeaRunListing> runs;
  while (row.step()) {
    runs.push_back({.run = {row.integer(0)},
                    .replicate = row.number(1),
                    .experiment = row.text(2),
                    .ending = row.text(3),
                    .passes_done = row.number(4),
                    .passes = row.number(5),
                    .best_score = row.null(6) ? std::nullopt : std::optional(row.real(6)),
                    .models = static_cast<std::uint64_t>(row.integer(7)),
                    .evaluations = static_cast<std::uint64_t>(row.integer(8)),
                    .seconds = row.real(9),
                    .stopped = row.null(11) ? std::string() : row.text(11),
                    .identity = row.text(10)});
  }
  return runs;
}

}  // namespace lacuna

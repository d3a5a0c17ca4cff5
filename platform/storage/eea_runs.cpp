#include "storage/eea_store.h"
#include "storage/statement.h"

namespace lacuna {
namespace {

bool has_runs(const Database& database) {
  Statement table(database, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'eea_run'");
  return table.step();
}

}  // namespace

std::vector<EeaRunListing> eea_runs(const Database& database) {
  if (!has_runs(database)) return {};
  Statement row(database,
                "SELECT eea_run.run, replicate, experiment.name, coalesce(ending, 'not ended'),"
                " count(pass.id), passes, (SELECT best_score FROM pass WHERE pass.run = eea_run.run AND ended"
                "                          AND best_model IS NOT NULL ORDER BY id DESC LIMIT 1),"
                " (SELECT coalesce(max(id) - (eea_run.run << 40), 0) FROM model"
                "  WHERE id BETWEEN eea_run.run << 40 AND (eea_run.run + 1 << 40) - 1),"
                " coalesce(sum(evaluations), 0), checkpoint.seconds"
                " FROM eea_run JOIN run ON run.number = eea_run.run"
                " JOIN experiment ON experiment.id = eea_run.experiment"
                " LEFT JOIN checkpoint ON checkpoint.run = eea_run.run"
                " LEFT JOIN pass ON pass.run = eea_run.run AND pass.ended"
                " GROUP BY eea_run.run ORDER BY eea_run.run");
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
                    .seconds = row.real(9)});
  }
  return runs;
}

}  // namespace lacuna

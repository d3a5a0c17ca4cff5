#include "foundation/digest.h"
#include "storage/core/statement.h"
#include "storage/eea/eea_store.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

/// A table of content, its rows in key order. ?1 is the run's number, 1099511627775 is 2^40 - 1. Keys are told without
/// it; a trial, which several runs may share, by its number within the run. Why something is invalid is a sentence for
/// people, which may name a plugin's file, and no content.
struct Content {
  const char* table;
  const char* rows;
};

constexpr Content kContents[] = {
    {"eea_run",
     "SELECT replicate, passes, metric.name, fitness.name, model_genes, test_genes FROM eea_run"
     " JOIN metric ON metric.id = eea_run.metric LEFT JOIN metric AS fitness ON fitness.id = eea_run.fitness"
     " WHERE run = ?1"},
    {"free_value",
     "SELECT position, address, unit, lower, upper, start, truth FROM free_value WHERE run = ?1 ORDER BY position"},
    {"pass",
     "SELECT id - (?1 << 40), number, ended, best_model - (?1 << 40), best_score, best_test - (?1 << 40), best_fitness,"
     " evaluations, abandoned, reused, invalid, steps, test_evaluations, invalid_tests, test_steps, stopped FROM pass"
     " WHERE run = ?1 ORDER BY id"},
    {"best_value",
     "SELECT pass - (?1 << 40), position, value FROM best_value"
     " WHERE pass BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY pass, position"},
    {"objective_score",
     "SELECT pass - (?1 << 40), position, name, unit, value FROM objective_score"
     " WHERE pass BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY pass, position"},
    {"ensemble_model",
     "SELECT pass - (?1 << 40), rank, model - (?1 << 40), score, structure FROM ensemble_model"
     " WHERE pass BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY pass, rank"},
    {"ensemble_value",
     "SELECT pass - (?1 << 40), rank, position, value FROM ensemble_value"
     " WHERE pass BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY pass, rank, position"},
    {"set_aside",
     "SELECT pass - (?1 << 40), target_trial.number FROM set_aside"
     " JOIN target_trial ON target_trial.run = ?1 AND target_trial.trial = set_aside.trial"
     " WHERE pass BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY pass, target_trial.number"},
    {"test",
     "SELECT id - (?1 << 40), pass - (?1 << 40), generation, parent - (?1 << 40), other_parent - (?1 << 40), genome,"
     " valid FROM test WHERE id BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY id"},
    {"test_score",
     "SELECT test - (?1 << 40), metric.name, score FROM test_score JOIN metric ON metric.id = test_score.metric"
     " WHERE test BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY test, metric.name"},
    {"invalid_test",
     "SELECT test - (?1 << 40) FROM invalid_test"
     " WHERE test BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY test"},
    {"target_trial",
     "SELECT target_trial.number, test - (?1 << 40), for_transfer, predicted_fitness, measured_fitness, surprise,"
     " digest,"
     " held_out, duration, samples, hold, initial, sensor_noise,"
     " CASE commanded_before WHEN '[]' THEN command_noise ELSE command_noise || commanded_before END || trial.setup ||"
     " coalesce((SELECT group_concat(position || address || printf('%!.17g', value)) FROM"
     " (SELECT position, address, value FROM trial_setting WHERE trial_setting.trial = trial.id ORDER BY position)), "
     "'')"
     " FROM target_trial"
     " JOIN trial ON trial.id = target_trial.trial JOIN trial_condition ON trial_condition.trial = trial.id"
     " WHERE run = ?1 ORDER BY target_trial.number"},
    {"model",
     "SELECT id - (?1 << 40), pass - (?1 << 40), generation, parent - (?1 << 40), other_parent - (?1 << 40), genome,"
     " kind, reused, score FROM model WHERE id BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY id"},
    {"model_score",
     "SELECT model - (?1 << 40), target_trial.number, metric.name, score FROM model_score"
     " JOIN metric ON metric.id = model_score.metric"
     " LEFT JOIN target_trial ON target_trial.run = ?1 AND target_trial.trial = model_score.trial"
     " WHERE model BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY model, target_trial.number, metric.name"},
    {"invalid_model",
     "SELECT model - (?1 << 40) FROM invalid_model"
     " WHERE model BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775 ORDER BY model"},
    {"trace",
     "SELECT target_trial.number, kind, model - (?1 << 40), channels, sample_count, precision, times, trace.samples,"
     " trace.digest FROM target_trial JOIN trace ON trace.trial = target_trial.trial WHERE run = ?1"
     " AND comparison IS NULL AND (model IS NULL OR model BETWEEN ?1 << 40 AND (?1 << 40) + 1099511627775)"
     " ORDER BY target_trial.number, kind, model, trace.id"}};

constexpr std::size_t kBlock = 1U << 20U;

/// How many rows there were.
std::int64_t add_rows(const Database& database, RunId run, const Content& content, Sha256& hash) {
  Statement row(database, content.rows);
  row.with(run);
  std::string bytes = std::string(content.table) + '\n';
  std::int64_t rows = 0;
  for (; row.step(); ++rows) {
    for (int column = 0; column < row.columns(); ++column) row.append_bits(column, bytes);
    if (bytes.size() > kBlock) {
      hash.add(bytes);
      bytes.clear();
    }
  }
  hash.add(bytes);
  hash.add(std::to_string(rows) + '\n');
  return rows;
}

}  // namespace

std::string content_hash(const Database& database, RunId run) {
  Sha256 hash;
  for (const Content& content : kContents) {
    const std::int64_t rows = add_rows(database, run, content, hash);
    if (&content == kContents && rows == 0) {
      throw Error(database.file().string() + ": run " + std::to_string(run.value) +
                  " is not a run of the algorithm; view eea_runs lists these runs");
    }
  }
  return hash.hex();
}

}  // namespace lacuna

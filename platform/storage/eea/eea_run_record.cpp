#include "storage/eea/eea_run_record.h"

#include "storage/core/json_text.h"
#include "storage/core/statement.h"

#include <lacuna/error.h>

#include <cmath>

namespace lacuna {
namespace {

/// Few, and the same in all runs of a file.
std::int64_t metric_key(const Database& database, const std::string& name) {
  Statement(database, "INSERT INTO metric (name) VALUES (?) ON CONFLICT (name) DO NOTHING").run_with(name);
  Statement row(database, "SELECT id FROM metric WHERE name = ?");
  row.with(name).step();
  return row.integer(0);
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

double truth_at(const EeaRunRecord& record, std::size_t position) {
  return position < record.truth.size() ? record.truth[position] : kNotKnown;
}

void read_free_values(const Database& database, RunId run, EeaRunRecord& record) {
  Statement row(database,
                "SELECT address, unit, lower, upper, start, truth FROM free_value WHERE run = ? ORDER BY position");
  row.with(run);
  while (row.step()) {
    record.free.push_back({row.text(0), row.text(1), row.real(2), row.real(3), row.real(4)});
    record.truth.push_back(row.real(5));
  }
}

}  // namespace

void write_run_record(const Database& database, RunId run, ExperimentId experiment, const EeaRunRecord& record) {
  const std::int64_t metric = metric_key(database, record.metric);
  std::optional<std::int64_t> fitness;
  if (!record.fitness.empty()) fitness = metric_key(database, record.fitness);
  Statement(database,
            "INSERT INTO eea_run (run, experiment, replicate, passes, metric, fitness, fitness_unit, model_genes,"
            " test_genes) VALUES (?, ?, ?, ?, ?, ?, nullif(?, ''), ?, ?)")
      .run_with(run, experiment, record.replicate, record.passes, metric, fitness, record.fitness_unit,
                sentences_text(record.model_genes), sentences_text(record.test_genes));
  Statement value(database,
                  "INSERT INTO free_value (run, position, address, unit, lower, upper, start, truth)"
                  " VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < record.free.size(); ++i) {
    const FreeValueRecord& free = record.free[i];
    value.run_with(run, static_cast<std::int64_t>(i), free.address, free.unit, free.lower, free.upper, free.start,
                   truth_at(record, i));
  }
}

std::optional<EeaRunRecord> read_run_record(const Database& database, RunId run) {
  Statement row(database,
                "SELECT replicate, passes, metric.name, coalesce(fitness.name, ''), model_genes, test_genes,"
                " coalesce(fitness_unit, '') FROM eea_run"
                " JOIN metric ON metric.id = eea_run.metric LEFT JOIN metric AS fitness ON fitness.id = eea_run.fitness"
                " WHERE run = ?");
  if (!row.with(run).step()) return std::nullopt;
  EeaRunRecord record;
  record.replicate = row.number(0);
  record.passes = row.number(1);
  record.metric = row.text(2);
  record.fitness = row.text(3);
  record.model_genes = sentences_from(row.text(4));
  record.test_genes = sentences_from(row.text(5));
  record.fitness_unit = row.text(6);
  read_free_values(database, run, record);
  return record;
}

std::string difference(const EeaRunRecord& a, const EeaRunRecord& b) {
  if (a.replicate != b.replicate) return "another replicate";
  if (a.passes != b.passes) return "another number of passes";
  if (a.metric != b.metric) return "another metric";
  if (a.fitness != b.fitness) return "another fitness of tests";
  if (a.model_genes != b.model_genes) return "another genome of models";
  if (a.test_genes != b.test_genes) return "another genome of tests";
  if (a.free.size() != b.free.size()) return "other free values";
  for (std::size_t i = 0; i < a.free.size(); ++i) {
    const FreeValueRecord& left = a.free[i];
    const FreeValueRecord& right = b.free[i];
    if (left.address != right.address || left.unit != right.unit || !same(left.lower, right.lower) ||
        !same(left.upper, right.upper) || !same(left.start, right.start)) {
      return "other free values";
    }
    if (!same(truth_at(a, i), truth_at(b, i))) return "other hidden values";
  }
  return "";
}

}  // namespace lacuna

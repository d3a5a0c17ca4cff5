#include "storage/results/result_store.h"

#include "storage/core/json_text.h"
#include "storage/core/names.h"
#include "storage/core/statement.h"
#include "storage/core/work_time.h"

namespace lacuna {
namespace {

void insert_values(const Database& database, FitId fit, const std::vector<FittedValueRecord>& values) {
  Statement insert(database,
                   "INSERT INTO fitted_value (fit, position, address, unit, start, value, standard_error, lower, upper,"
                   " at_bound, identifiable) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  int position = 0;
  for (const FittedValueRecord& v : values) {
    insert.run_with(fit, position++, v.address, v.unit, v.start, v.value, v.standard_error, v.lower, v.upper,
                    text_of(v.at_bound), v.identifiable);
  }
}

std::vector<FittedValueRecord> values_of(const Database& database, FitId fit) {
  Statement row(database,
                "SELECT address, unit, start, value, standard_error, lower, upper, at_bound, identifiable"
                " FROM fitted_value WHERE fit = ? ORDER BY position");
  row.with(fit);
  std::vector<FittedValueRecord> values;
  while (row.step()) {
    values.push_back({.address = row.text(0),
                      .unit = row.text(1),
                      .start = row.real(2),
                      .value = row.real(3),
                      .standard_error = row.real(4),
                      .lower = row.real(5),
                      .upper = row.real(6),
                      .at_bound = bound_from(row.text(7)),
                      .identifiable = row.flag(8)});
  }
  return values;
}

void insert_stages(const Database& database, FitId fit, const std::vector<FitStageRecord>& stages) {
  Statement insert(database,
                   "INSERT INTO fit_stage (fit, position, name, segment, segments, starts, agreeing, iterations,"
                   " converged, residual, fitted) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  int position = 0;
  for (const FitStageRecord& s : stages) {
    insert.run_with(fit, position++, s.name, s.segment, s.segments, s.starts, s.agreeing, s.iterations, s.converged,
                    s.residual, numbers_text(s.values));
  }
}

std::vector<FitStageRecord> stages_of(const Database& database, FitId fit) {
  Statement row(database,
                "SELECT name, segment, segments, starts, agreeing, iterations, converged, residual, fitted"
                " FROM fit_stage WHERE fit = ? ORDER BY position");
  row.with(fit);
  std::vector<FitStageRecord> stages;
  while (row.step()) {
    stages.push_back({.name = row.text(0),
                      .segment = row.real(1),
                      .segments = row.integer(2),
                      .starts = row.integer(3),
                      .agreeing = row.integer(4),
                      .iterations = row.integer(5),
                      .converged = row.flag(6),
                      .residual = row.real(7),
                      .values = numbers_from(row.text(8))});
  }
  return stages;
}

}  // namespace

FitId ResultStore::record_fit(RevisionId revision, const FitRecord& f) {
  Transaction transaction(database_);
  const FitId id{next_id("fit")};
  const std::string covariance = matrix_text(f.covariance);
  Statement(database_,
            "INSERT INTO fit (id, revision, settings, method, loss, loss_scale, converged, residual, samples,"
            " simulations, invalid_simulations, starts, agreeing, correlation_time, covariance, cannot_tell, notes)"
            " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .run_with(id, revision, f.settings, f.method, f.loss, f.loss_scale, f.converged, f.residual, f.samples,
                f.simulations, f.invalid_simulations, f.starts, f.agreeing, f.correlation_time, covariance,
                sentences_text(f.cannot_tell), sentences_text(f.notes));
  insert_values(database_, id, f.values);
  insert_stages(database_, id, f.stages);
  record_seconds(database_, "fit", id.value, f.seconds);
  transaction.commit();
  return id;
}

std::optional<StoredFit> ResultStore::last_fit_of(RevisionId revision, const std::string& settings) const {
  Statement row(database_,
                "SELECT id, settings, method, loss, loss_scale, converged, residual, samples, simulations,"
                " invalid_simulations, starts, agreeing, correlation_time, covariance, cannot_tell, notes"
                " FROM fit WHERE revision = ? AND settings = ? ORDER BY id DESC LIMIT 1");
  if (!row.with(revision, settings).step()) return std::nullopt;
  const FitId id{row.integer(0)};
  return StoredFit{id,
                   {.settings = row.text(1),
                    .method = row.text(2),
                    .loss = row.text(3),
                    .loss_scale = row.real(4),
                    .converged = row.flag(5),
                    .residual = row.real(6),
                    .samples = row.integer(7),
                    .simulations = row.integer(8),
                    .invalid_simulations = row.integer(9),
                    .starts = row.integer(10),
                    .agreeing = row.integer(11),
                    .correlation_time = row.real(12),
                    .values = values_of(database_, id),
                    .stages = stages_of(database_, id),
                    .covariance = row.null(13) ? Eigen::MatrixXd() : matrix_from(row.text(13)),
                    .cannot_tell = sentences_from(row.text(14)),
                    .notes = sentences_from(row.text(15)),
                    .seconds = seconds_of(database_, "fit", id.value)}};
}

}  // namespace lacuna

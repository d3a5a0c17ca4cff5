#include "storage/results/result_store.h"

#include "storage/core/clock.h"
#include "storage/core/json_text.h"
#include "storage/core/names.h"
#include "storage/core/statement.h"
#include "storage/core/work_time.h"

#include <cmath>

namespace lacuna {
namespace {

void insert_scores(const Database& database, ComparisonId comparison, const std::vector<ScoreRecord>& scores) {
  Statement insert(
      database,
      "INSERT INTO comparison_score (comparison, trial, channel, horizon, unit, samples, rmse,"
      " normalised_rmse, theil_u, bias, bias_share, magnitude_share, phase_share, max_error,"
      " max_error_time, floor, as_written_rmse) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  Statement numerical(
      database, "INSERT INTO numerical_error (comparison, trial, channel, horizon, error) VALUES (?, ?, ?, ?, ?)");
  for (const ScoreRecord& s : scores) {
    insert.run_with(comparison, s.trial, s.channel, s.horizon, s.unit, s.samples, s.rmse, s.normalised_rmse, s.theil_u,
                    s.bias, s.bias_share, s.magnitude_share, s.phase_share, s.max_error, s.max_error_time, s.floor,
                    s.as_written_rmse);
    if (!std::isnan(s.numerical_error))
      numerical.run_with(comparison, s.trial, s.channel, s.horizon, s.numerical_error);
  }
}

void insert_floors(const Database& database, ComparisonId comparison, const std::vector<NoiseFloorRecord>& floors) {
  Statement insert(database,
                   "INSERT INTO noise_floor (comparison, trial, channel, unit, floor, sensor, input, process, origin)"
                   " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const NoiseFloorRecord& f : floors) {
    insert.run_with(comparison, f.trial, f.channel, f.unit, f.floor, f.sensor, f.input, f.process, f.origin);
  }
}

std::vector<ScoreRecord> scores_of(const Database& database, ComparisonId comparison) {
  Statement row(database,
                "SELECT s.trial, s.channel, s.unit, s.horizon, s.samples, s.rmse, s.normalised_rmse, s.theil_u, s.bias,"
                " s.bias_share, s.magnitude_share, s.phase_share, s.max_error, s.max_error_time, s.floor, n.error,"
                " s.as_written_rmse FROM comparison_score AS s LEFT JOIN numerical_error AS n ON"
                " n.comparison = s.comparison AND n.trial = s.trial AND n.channel = s.channel AND n.horizon = s.horizon"
                " WHERE s.comparison = ? ORDER BY s.trial, s.channel, s.horizon");
  row.with(comparison);
  std::vector<ScoreRecord> scores;
  while (row.step()) {
    scores.push_back({.trial = {row.integer(0)},
                      .channel = row.text(1),
                      .unit = row.text(2),
                      .horizon = row.real(3),
                      .samples = row.integer(4),
                      .rmse = row.real(5),
                      .normalised_rmse = row.real(6),
                      .theil_u = row.real(7),
                      .bias = row.real(8),
                      .bias_share = row.real(9),
                      .magnitude_share = row.real(10),
                      .phase_share = row.real(11),
                      .max_error = row.real(12),
                      .max_error_time = row.real(13),
                      .floor = row.real(14),
                      .numerical_error = row.real(15),
                      .as_written_rmse = row.real(16)});
  }
  return scores;
}

std::vector<NoiseFloorRecord> floors_of(const Database& database, ComparisonId comparison) {
  Statement row(database,
                "SELECT trial, channel, unit, floor, sensor, input, process, origin FROM noise_floor"
                " WHERE comparison = ? ORDER BY trial, channel");
  row.with(comparison);
  std::vector<NoiseFloorRecord> floors;
  while (row.step()) {
    floors.push_back({.trial = {row.integer(0)},
                      .channel = row.text(1),
                      .unit = row.text(2),
                      .floor = row.real(3),
                      .sensor = row.real(4),
                      .input = row.real(5),
                      .process = row.real(6),
                      .origin = row.text(7)});
  }
  return floors;
}

}  // namespace

int ResultStore::count_holdout_look(RevisionId revision, const std::string& command) {
  Transaction transaction(database_);
  const std::int64_t id = next_id("holdout_look");
  Statement(database_,
            "INSERT INTO holdout_look (id, experiment, number, revision, command, time)"
            " SELECT ?1, experiment,"
            "   (SELECT coalesce(max(number), 0) + 1 FROM holdout_look WHERE experiment = revision.experiment),"
            "   id, ?2, ?3 FROM revision WHERE id = ?4")
      .run_with(id, command, utc_now(), revision);
  Statement number(database_, "SELECT number FROM holdout_look WHERE id = ?");
  number.with(id).step();
  const int look = number.number(0);
  transaction.commit();
  return look;
}

int ResultStore::holdout_looks(ExperimentId experiment) const {
  Statement row(database_, "SELECT count(*) FROM holdout_look WHERE experiment = ?");
  row.with(experiment).step();
  return row.number(0);
}

ComparisonId ResultStore::record_comparison(RevisionId revision, const ComparisonRecord& c) {
  Transaction transaction(database_);
  const ComparisonId id{next_id("comparison")};
  Statement(database_,
            "INSERT INTO comparison (id, revision, kind, fit, look, step, findings) VALUES (?, ?, ?, ?, ?, ?, ?)")
      .run_with(id, revision, to_string(c.kind), c.fit, c.look, c.step, sentences_text(c.findings));
  insert_scores(database_, id, c.scores);
  insert_floors(database_, id, c.floors);
  record_seconds(database_, "comparison", id.value, c.seconds);
  transaction.commit();
  return id;
}

void ResultStore::record_where_it_fails(ComparisonId comparison, const std::string& document) {
  Transaction transaction(database_);
  Statement(database_, "INSERT OR REPLACE INTO where_it_fails (comparison, document) VALUES (?, ?)")
      .run_with(comparison, document);
  transaction.commit();
}

std::optional<StoredComparison> ResultStore::latest_comparison(RevisionId revision, ComparisonKind kind,
                                                               bool held_out) const {
  Statement row(database_,
                "SELECT id, fit, look, step, findings FROM comparison WHERE revision = ? AND kind = ? AND (NOT ? OR"
                " EXISTS (SELECT * FROM comparison_score AS s JOIN trial ON trial.id = s.trial"
                "         WHERE s.comparison = comparison.id AND trial.held_out = 1))"
                " ORDER BY id DESC LIMIT 1");
  if (!row.with(revision, to_string(kind), held_out).step()) return std::nullopt;
  const ComparisonId id{row.integer(0)};
  return StoredComparison{id,
                          revision,
                          {.kind = kind,
                           .fit = row.null(1) ? std::nullopt : std::optional(FitId{row.integer(1)}),
                           .look = row.optional_number(2),
                           .step = row.real(3),
                           .scores = scores_of(database_, id),
                           .floors = floors_of(database_, id),
                           .findings = sentences_from(row.text(4)),
                           .seconds = seconds_of(database_, "comparison", id.value)}};
}

namespace {

/// Of a revision's channel in its latest refitted comparisons, with held-out trials and without.
std::vector<HorizonRow> horizons_of(const Database& database, RevisionId revision, const std::string& channel) {
  Statement row(database,
                "WITH score AS (SELECT s.comparison, s.horizon, s.rmse, t.held_out FROM comparison_score AS s"
                "   JOIN comparison AS c ON c.id = s.comparison JOIN trial AS t ON t.id = s.trial"
                "   WHERE c.revision = ?1 AND c.kind = 'refitted' AND s.channel = ?2 AND s.horizon > 0),"
                " newest AS (SELECT held_out, max(comparison) AS comparison FROM score GROUP BY held_out),"
                " pooled AS (SELECT score.horizon, score.held_out, sqrt(avg(score.rmse * score.rmse)) AS rmse"
                "   FROM score JOIN newest USING (held_out, comparison) GROUP BY score.horizon, score.held_out)"
                " SELECT horizon, max(iif(held_out = 0, rmse, NULL)), max(iif(held_out = 1, rmse, NULL))"
                " FROM pooled GROUP BY horizon ORDER BY horizon");
  row.with(revision, channel);
  std::vector<HorizonRow> rows;
  while (row.step()) rows.push_back({row.real(0), row.real(1), row.real(2)});
  return rows;
}

}  // namespace

std::vector<HistoryRow> ResultStore::history(ExperimentId experiment) const {
  const std::optional<StoredRevision> current = current_revision(experiment);
  Statement row(database_,
                "SELECT r.id, r.number, p.number, r.change, e.channel, e.unit, e.fit_rmse, e.held_out_rmse, e.floor,"
                " e.times_floor, e.failed_trials, EXISTS (SELECT 1 FROM fit AS f WHERE f.revision = r.id)"
                " FROM revision AS r JOIN experiment AS x ON x.id = r.experiment"
                " LEFT JOIN revision AS p ON p.id = r.parent"
                " LEFT JOIN error_by_revision AS e ON e.experiment = x.name AND e.revision = r.number"
                " WHERE r.experiment = ? ORDER BY r.number, e.channel");
  row.with(experiment);
  std::vector<HistoryRow> rows;
  while (row.step()) {
    rows.push_back({.revision = {row.integer(0)},
                    .number = row.number(1),
                    .parent = row.optional_number(2),
                    .change = row.text(3),
                    .current = current && current->id.value == row.integer(0),
                    .fitted = row.integer(11) != 0,
                    .channel = row.text(4),
                    .unit = row.text(5),
                    .fit_rmse = row.real(6),
                    .held_out_rmse = row.real(7),
                    .floor = row.real(8),
                    .times_floor = row.real(9),
                    .failed_trials = row.number(10)});
  }
  for (HistoryRow& one : rows)
    if (!one.channel.empty()) one.horizons = horizons_of(database_, one.revision, one.channel);
  return rows;
}

}  // namespace lacuna

#include "storage/core/names.h"
#include "storage/core/number_blob.h"
#include "storage/integrity/row_key.h"
#include "storage/core/storage_error.h"
#include "storage/eea/eea_names.h"
#include "storage/eea/eea_run_record.h"
#include "storage/eea/eea_store.h"
#include "storage/eea/eea_writer.h"
#include "storage/traces/read_trace.h"
#include "storage/traces/trial_condition.h"

#include <lacuna/error.h>

#include <map>

/// The members of EeaStore that read, and `begin`, which reads first.
namespace lacuna {
namespace {

std::optional<std::uint64_t> number_at(Statement& row, int column) {
  if (row.null(column)) return std::nullopt;
  return number_of(row.integer(column));
}

std::uint64_t count_at(Statement& row, int column) { return static_cast<std::uint64_t>(row.integer(column)); }

/// Models with keys from `first` to `last`; with `pass`, its models alone.
std::vector<ModelRow> models_between(const Database& database, std::int64_t first, std::int64_t last,
                                     std::optional<std::int64_t> pass) {
  Statement row(database,
                "SELECT id, pass, generation, parent, other_parent, genome, kind, reused, score, coalesce(reason, '')"
                " FROM model LEFT JOIN invalid_model ON invalid_model.model = model.id"
                " WHERE id BETWEEN ?1 AND ?2 AND (?3 IS NULL OR pass = ?3) ORDER BY id");
  row.with(first, last, pass);
  std::vector<ModelRow> models;
  while (row.step()) {
    models.push_back({.number = number_of(row.integer(0)),
                      .pass = static_cast<int>(number_of(row.integer(1))),
                      .generation = row.number(2),
                      .parents = {number_at(row, 3), number_at(row, 4)},
                      .genome = numbers_in(row.bytes(5)),
                      .kind = score_kind_from(row.text(6)),
                      .reused = row.flag(7),
                      .score = row.real(8),
                      .trial_scores = {},
                      .reason = row.text(9)});
  }
  return models;
}

/// Numbers of the run's trials by their keys.
std::map<std::int64_t, std::size_t> trial_numbers(const Database& database, RunId run) {
  Statement row(database, "SELECT trial, number FROM target_trial WHERE run = ?");
  row.with(run);
  std::map<std::int64_t, std::size_t> numbers;
  while (row.step()) numbers[row.integer(0)] = static_cast<std::size_t>(row.integer(1));
  return numbers;
}

/// `models`: ascending.
void add_trial_scores(const Database& database, RunId run, std::vector<ModelRow>& models) {
  if (models.empty()) return;
  const std::map<std::int64_t, std::size_t> numbers = trial_numbers(database, run);
  Statement row(database,
                "SELECT model, trial, model_score.score FROM model_score WHERE model BETWEEN ? AND ?"
                " AND metric = (SELECT metric FROM eea_run WHERE run = ?) ORDER BY model, trial");
  row.with(key_of(run, models.front().number), key_of(run, models.back().number), run);
  auto model = models.begin();
  while (row.step()) {
    const std::uint64_t number = number_of(row.integer(0));
    while (model != models.end() && model->number < number) ++model;
    if (model == models.end()) break;
    if (model->number != number) continue;
    const auto known = numbers.find(row.integer(1));
    if (known == numbers.end())
      throw DamagedDatabase(database.file().string() + ": run " + std::to_string(run.value) + ": model " +
                            std::to_string(number) + " has a score on a trial that the run does not have");
    const std::size_t trial = known->second;
    if (model->trial_scores.size() <= trial) model->trial_scores.resize(trial + 1, kNotKnown);
    model->trial_scores[trial] = row.real(2);
  }
}

void add_best_values(const Database& database, std::int64_t pass, PassRow& into) {
  Statement value(database, "SELECT value FROM best_value WHERE pass = ? ORDER BY position");
  value.with(pass);
  while (value.step()) into.best_values.push_back(value.real(0));
  Statement objective(database, "SELECT name, unit, value FROM objective_score WHERE pass = ? ORDER BY position");
  objective.with(pass);
  while (objective.step()) into.objective.push_back({objective.text(0), objective.text(1), objective.real(2)});
}

void add_ensemble(const Database& database, std::int64_t pass, PassRow& into) {
  Statement member(database, "SELECT model, score, structure FROM ensemble_model WHERE pass = ? ORDER BY rank");
  member.with(pass);
  while (member.step()) into.ensemble.push_back({number_of(member.integer(0)), member.real(1), member.text(2), {}});
  Statement value(database, "SELECT rank, value FROM ensemble_value WHERE pass = ? ORDER BY rank, position");
  value.with(pass);
  while (value.step()) {
    const auto rank = static_cast<std::size_t>(value.integer(0));
    if (rank < 1 || rank > into.ensemble.size())
      throw DamagedDatabase(database.file().string() + ": pass " + std::to_string(into.number) +
                            " has values of a model that is not in its ensemble");
    into.ensemble[rank - 1].values.push_back(value.real(1));
  }
  Statement trial(database,
                  "SELECT target_trial.number FROM set_aside JOIN target_trial ON target_trial.trial = set_aside.trial"
                  " AND target_trial.run = set_aside.pass >> 40 WHERE pass = ? ORDER BY target_trial.number");
  trial.with(pass);
  while (trial.step()) into.set_aside.push_back(trial.number(0));
}

}  // namespace

void EeaStore::begin(const EeaRunRecord& record) {
  const std::lock_guard lock(writing_);
  Transaction transaction(database_);
  if (const std::optional<EeaRunRecord> there = read_run_record(database_, run_)) {
    if (const std::string other = difference(*there, record); !other.empty()) {
      throw Error(database_.file().string() + ": run " + std::to_string(run_.value) + " was begun with " + other +
                  "; undo the change of the experiment, or run without --resume");
    }
  } else {
    write_run_record(database_, run_, experiment_, record);
  }
  set_run_ending(database_, run_, std::nullopt);
  transaction.commit();
  to_end_ = true;
}

EeaRunRecord EeaStore::record() const {
  const std::lock_guard lock(writing_);
  const std::optional<EeaRunRecord> record = read_run_record(database_, run_);
  if (!record) {
    throw Error(database_.file().string() + ": run " + std::to_string(run_.value) +
                " is not a run of the algorithm; view eea_runs lists these runs");
  }
  return *record;
}

std::vector<TargetTrialRow> EeaStore::trial_rows() const {
  const std::lock_guard lock(writing_);
  Statement row(
      database_,
      "SELECT number, test, file, for_transfer, predicted_fitness, measured_fitness, surprise FROM target_trial"
      " JOIN trial ON trial.id = target_trial.trial WHERE run = ? ORDER BY number");
  row.with(run_);
  std::vector<TargetTrialRow> rows;
  while (row.step()) {
    rows.push_back({.number = row.number(0),
                    .test = number_at(row, 1),
                    .file = row.text(2),
                    .for_transfer = row.flag(3),
                    .predicted_fitness = row.real(4),
                    .measured_fitness = row.real(5),
                    .surprise = row.real(6)});
  }
  return rows;
}

std::vector<Trial> EeaStore::trials() const {
  const std::lock_guard lock(writing_);
  Statement row(database_, "SELECT trial FROM target_trial WHERE run = ? ORDER BY number");
  row.with(run_);
  std::vector<Trial> trials;
  while (row.step()) trials.push_back(read_trial(database_, {row.integer(0)}));
  return trials;
}

std::optional<TimeSeries> EeaStore::predicted_path(std::uint64_t model, int trial) const {
  const std::lock_guard lock(writing_);
  Statement row(database_,
                "SELECT trace.id FROM trace JOIN target_trial ON target_trial.trial = trace.trial"
                " WHERE run = ? AND number = ? AND trace.model = ? AND kind = 'centre_of_mass'");
  if (!row.with(run_, trial, key_of(run_, model)).step()) return std::nullopt;
  return read_trace(database_, TraceId{row.integer(0)});
}

std::vector<ModelRow> EeaStore::models(int pass) const {
  const std::lock_guard lock(writing_);
  std::vector<ModelRow> models =
      models_between(database_, key_base(run_), last_key(run_), key_of(run_, static_cast<std::uint64_t>(pass)));
  add_trial_scores(database_, run_, models);
  return models;
}

std::optional<ModelRow> EeaStore::model(std::uint64_t number) const {
  const std::lock_guard lock(writing_);
  std::vector<ModelRow> models = models_between(database_, key_of(run_, number), key_of(run_, number), std::nullopt);
  if (models.empty()) return std::nullopt;
  add_trial_scores(database_, run_, models);
  return models.front();
}

std::optional<TestRow> EeaStore::test(std::uint64_t number) const {
  const std::lock_guard lock(writing_);
  Statement row(database_,
                "SELECT pass, generation, parent, other_parent, genome, valid, test_score.score, coalesce(reason, '')"
                " FROM test LEFT JOIN eea_run ON eea_run.run = test.id >> 40"
                " LEFT JOIN test_score ON test_score.test = test.id AND test_score.metric = eea_run.fitness"
                " LEFT JOIN invalid_test ON invalid_test.test = test.id WHERE test.id = ?");
  if (!row.with(key_of(run_, number)).step()) return std::nullopt;
  return TestRow{.number = number,
                 .pass = static_cast<int>(number_of(row.integer(0))),
                 .generation = row.number(1),
                 .parents = {number_at(row, 2), number_at(row, 3)},
                 .genome = numbers_in(row.bytes(4)),
                 .valid = row.flag(5),
                 .fitness = row.real(6),
                 .reason = row.text(7)};
}

std::vector<PassRow> EeaStore::passes() const {
  const std::lock_guard lock(writing_);
  Statement row(database_,
                "SELECT id, number, best_model, best_score, best_test, best_fitness, evaluations, abandoned, reused,"
                " invalid, steps, test_evaluations, invalid_tests, test_steps, coalesce(stopped, '') FROM pass"
                " WHERE id BETWEEN ? AND ? AND ended ORDER BY id");
  row.with(key_base(run_), last_key(run_));
  std::vector<PassRow> passes;
  while (row.step()) {
    PassRow& pass = passes.emplace_back();
    pass.number = row.number(1);
    pass.best_model = number_at(row, 2);
    pass.best_score = row.real(3);
    pass.best_test = number_at(row, 4);
    pass.best_fitness = row.real(5);
    pass.evaluations = count_at(row, 6);
    pass.abandoned = count_at(row, 7);
    pass.reused = count_at(row, 8);
    pass.invalid = count_at(row, 9);
    pass.steps = count_at(row, 10);
    pass.test_evaluations = count_at(row, 11);
    pass.invalid_tests = count_at(row, 12);
    pass.test_steps = count_at(row, 13);
    pass.stopped = row.text(14);
    add_best_values(database_, row.integer(0), pass);
    add_ensemble(database_, row.integer(0), pass);
  }
  return passes;
}

}  // namespace lacuna

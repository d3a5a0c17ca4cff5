#include "storage/eea/eea_writer.h"

#include "storage/core/canonical_text.h"
#include "storage/core/names.h"
#include "storage/core/number_blob.h"
#include "storage/eea/eea_names.h"
#include "storage/traces/trial_condition.h"
#include "storage/traces/write_trial.h"

#include <lacuna/error.h>

#include <cmath>

namespace lacuna {
namespace {

TrialRecord trial_record(RunId run, const TargetTrialRow& row, const Trial& trial) {
  const Eigen::VectorXd& times = trial.measured.times;
  return {.name = row.test ? name_of_test_trial(run, row.number) : trial.name,
          .file = row.file,
          .digest = digest_of(trial),
          .held_out = trial.held_out,
          .duration = times.size() > 0 ? times[times.size() - 1] - times[0] : 0.0,
          .samples = times.size(),
          .setup = trial.setup};
}

}  // namespace

EeaWriter::EeaWriter(Database& database, RunId run, ExperimentId experiment)
    : database_(database),
      run_(run),
      experiment_(experiment),
      insert_pass_(database,
                   "INSERT INTO pass (id, run, number, ended, evaluations, abandoned, reused, invalid, steps,"
                   " test_evaluations, invalid_tests, test_steps) VALUES (?, ?, ?, 0, 0, 0, 0, 0, 0, 0, 0, 0)"
                   " ON CONFLICT (id) DO NOTHING"),
      insert_test_(database,
                   "INSERT INTO test (id, pass, generation, parent, other_parent, genome, valid)"
                   " VALUES (?, ?, ?, ?, ?, ?, ?)"),
      insert_test_score_(database, "INSERT INTO test_score (test, metric, score) VALUES (?, ?, ?)"),
      insert_invalid_test_(database, "INSERT INTO invalid_test (test, reason) VALUES (?, ?)"),
      insert_model_(database,
                    "INSERT INTO model (id, pass, generation, parent, other_parent, genome, kind, reused, score)"
                    " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      insert_model_score_(database, "INSERT INTO model_score (model, trial, metric, score) VALUES (?, ?, ?, ?)"),
      insert_invalid_model_(database, "INSERT INTO invalid_model (model, reason) VALUES (?, ?)") {
  Statement row(database, "SELECT metric, fitness FROM eea_run WHERE run = ?");
  if (!row.with(run).step()) throw Error("EeaStore: begin comes before anything is committed");
  metric_ = row.integer(0);
  if (!row.null(1)) fitness_ = row.integer(1);
  Statement trials(database, "SELECT trial FROM target_trial WHERE run = ? ORDER BY number");
  trials.with(run);
  while (trials.step()) trials_.push_back({trials.integer(0)});
}

std::int64_t EeaWriter::pass_key(int number) {
  const std::int64_t key = key_of(run_, static_cast<std::uint64_t>(number));
  if (pass_ != number) insert_pass_.run_with(key, run_, number);
  pass_ = number;
  return key;
}

std::optional<std::int64_t> EeaWriter::key_of_some(std::optional<std::uint64_t> number) const {
  if (!number) return std::nullopt;
  return key_of(run_, *number);
}

TrialId EeaWriter::trial_of(int number) const {
  const auto index = static_cast<std::size_t>(number);
  if (index >= trials_.size()) throw Error("EeaStore: trial " + std::to_string(number) + " was never appended");
  return trials_[index];
}

void EeaWriter::insert(const TestRow& test) {
  const std::int64_t key = key_of(run_, test.number);
  insert_test_.run_with(key, pass_key(test.pass), test.generation, key_of_some(test.parents[0]),
                        key_of_some(test.parents[1]), number_bytes(test.genome), test.valid);
  if (fitness_) insert_test_score_.run_with(key, *fitness_, test.fitness);
  if (!test.reason.empty()) insert_invalid_test_.run_with(key, test.reason);
}

void EeaWriter::insert(const TargetTrialRow& row, const Trial& trial) {
  if (row.number != static_cast<int>(trials_.size())) {
    throw Error("EeaStore: trial " + std::to_string(row.number) + " follows trial " +
                std::to_string(static_cast<int>(trials_.size()) - 1));
  }
  const TrialId id = write_trial(database_, run_, experiment_, trial_record(run_, row, trial));
  write_trial_condition(database_, id, trial);
  const auto keep = [&](TraceKind kind, const TimeSeries& series) {
    write_trace(database_, run_, {.trial = id, .kind = kind}, series, TracePrecision::float64);
  };
  keep(TraceKind::measured, trial.measured);
  keep(TraceKind::commands, trial.commands.series);
  if (!trial.centre_of_mass.channels.empty()) keep(TraceKind::centre_of_mass, trial.centre_of_mass);
  Statement(database_,
            "INSERT INTO target_trial (run, number, trial, test, for_transfer, predicted_fitness, measured_fitness,"
            " surprise) VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
      .run_with(run_, row.number, id, key_of_some(row.test), row.for_transfer, row.predicted_fitness,
                row.measured_fitness, row.surprise);
  trials_.push_back(id);
}

void EeaWriter::insert(const ModelRow& model) {
  const std::int64_t key = key_of(run_, model.number);
  insert_model_.run_with(key, pass_key(model.pass), model.generation, key_of_some(model.parents[0]),
                         key_of_some(model.parents[1]), number_bytes(model.genome), to_string(model.kind), model.reused,
                         model.score);
  for (std::size_t trial = 0; trial < model.trial_scores.size(); ++trial) {
    if (!std::isnan(model.trial_scores[trial]))  // what is set aside has no row
      insert_model_score_.run_with(key, trial_of(static_cast<int>(trial)), metric_, model.trial_scores[trial]);
  }
  if (!model.reason.empty()) insert_invalid_model_.run_with(key, model.reason);
}

void EeaWriter::insert_prediction(std::uint64_t model, int trial, TraceKind kind, const TimeSeries& series) {
  write_trace(database_, run_, {.trial = trial_of(trial), .model = ModelId{key_of(run_, model)}, .kind = kind}, series,
              TracePrecision::float32);
}

void EeaWriter::insert(const PassRow& pass) {
  const std::int64_t key = pass_key(pass.number);
  const auto count = [](std::uint64_t number) { return static_cast<std::int64_t>(number); };
  Statement(database_,
            "UPDATE pass SET ended = 1, best_model = ?, best_score = ?, best_test = ?, best_fitness = ?,"
            " evaluations = ?, abandoned = ?, reused = ?, invalid = ?, steps = ?, test_evaluations = ?,"
            " invalid_tests = ?, test_steps = ?, stopped = nullif(?, '') WHERE id = ?")
      .run_with(key_of_some(pass.best_model), pass.best_score, key_of_some(pass.best_test), pass.best_fitness,
                count(pass.evaluations), count(pass.abandoned), count(pass.reused), count(pass.invalid),
                count(pass.steps), count(pass.test_evaluations), count(pass.invalid_tests), count(pass.test_steps),
                pass.stopped, key);
  Statement value(database_, "INSERT INTO best_value (pass, position, value) VALUES (?, ?, ?)");
  int position = 0;
  for (const double best : pass.best_values) value.run_with(key, position++, best);
  Statement objective(database_,
                      "INSERT INTO objective_score (pass, position, name, unit, value) VALUES (?, ?, ?, ?, ?)");
  position = 0;
  for (const ObjectiveRow& row : pass.objective) objective.run_with(key, position++, row.name, row.unit, row.value);
  insert_ensemble(key, pass.ensemble);
  Statement set_aside(database_, "INSERT INTO set_aside (pass, trial) VALUES (?, ?)");
  for (const int trial : pass.set_aside) set_aside.run_with(key, trial_of(trial));
}

void EeaWriter::insert_ensemble(std::int64_t pass, const std::vector<EnsembleRow>& ensemble) {
  Statement member(database_,
                   "INSERT INTO ensemble_model (pass, rank, model, score, structure) VALUES (?, ?, ?, ?, ?)");
  Statement value(database_, "INSERT INTO ensemble_value (pass, rank, position, value) VALUES (?, ?, ?, ?)");
  int rank = 1;
  for (const EnsembleRow& row : ensemble) {
    member.run_with(pass, rank, key_of(run_, row.model), row.score, row.structure);
    int position = 0;
    for (const double of_member : row.values) value.run_with(pass, rank, position++, of_member);
    ++rank;
  }
}

}  // namespace lacuna

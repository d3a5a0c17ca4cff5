#include "storage/results/result_store.h"

#include "foundation/digest.h"
#include "storage/core/clock.h"
#include "storage/core/json_text.h"
#include "storage/core/names.h"
#include "storage/integrity/row_key.h"
#include "storage/integrity/seal.h"
#include "storage/core/statement.h"
#include "storage/results/stored_run.h"

#include <lacuna/error.h>

#include <cstdio>
#include <random>

namespace lacuna {
namespace {

std::string random_identity() {
  std::random_device device;
  std::string hex;
  for (int word = 0; word < 4; ++word) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(device()));
    hex += digits;
  }
  return hex;
}

}  // namespace

std::string identity_of_run(const std::string& task, RunId run) {
  constexpr std::size_t kDigits = 32;
  return sha256(task + " " + std::to_string(run.value)).substr(0, kDigits);
}

ResultStore::ResultStore(Database& database) : database_(database) {}

ResultStore::~ResultStore() {
  if (!run_ || ended_ || database_.in_transaction()) return;
  try {
    end_run_unless_ended(database_, *run_, RunEnding::failed);
  } catch (const std::exception&) {
    // Whatever ended the run has been reported; a run without an ending reads as "not ended".
  }
}

RunId ResultStore::run() const {
  if (!run_) throw Error("ResultStore: begin_run comes before anything is recorded");
  return *run_;
}

std::int64_t ResultStore::next_id(const char* table) { return next_key(database_, table, run()); }

RunId ResultStore::begin_run(const RunRecord& record, const Provenance& p) {
  Transaction transaction(database_);
  Statement number(database_, "SELECT coalesce(max(number), 0) + 1 FROM run");
  number.step();
  const RunId run{number.integer(0)};
  Statement(database_, "INSERT INTO run (number, identity, command, seed, threads, started) VALUES (?, ?, ?, ?, ?, ?)")
      .run_with(run, record.task.empty() ? random_identity() : identity_of_run(record.task, run), record.command,
                static_cast<std::int64_t>(record.seed), record.threads, utc_now());
  Statement(
      database_,
      "INSERT INTO provenance (run, program, source_revision, compiler, build_type, ode, sqlite, eigen, processor,"
      " system) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .run_with(run, p.program, p.source_revision, p.compiler, p.build_type, p.ode, p.sqlite, p.eigen, p.processor,
                p.system);
  transaction.commit();
  run_ = run;
  ended_ = false;
  return run;
}

void ResultStore::continue_run(RunId run) {
  Transaction transaction(database_);
  Statement row(database_, "SELECT coalesce(ending, '') FROM run WHERE number = ?");
  const std::string name = database_.file().string() + ": run " + std::to_string(run.value);
  if (!row.with(run).step()) throw Error(name + " does not exist; view runs lists those that do");
  if (row.text(0) == to_string(RunEnding::done)) throw Error(name + " is done; there is nothing to continue");
  set_run_ending(database_, run, std::nullopt);
  transaction.commit();
  run_ = run;
  ended_ = false;
}

void ResultStore::end_run(RunEnding ending) {
  set_run_ending(database_, run(), ending);
  ended_ = true;
}

bool is_done(const Database& database, RunId run) {
  Statement ending(database, "SELECT 1 FROM run WHERE number = ? AND ending = 'done'");
  return ending.with(run).step();
}

namespace {

void write_ending(Database& database, RunId run, std::optional<RunEnding> ending) {
  std::optional<std::string> time;
  std::optional<std::string> name;
  if (ending) {
    time = utc_now();
    name = to_string(*ending);
  }
  Statement(database, "UPDATE run SET ended = ?, ending = ? WHERE number = ?").run_with(time, name, run);
}

}  // namespace

void set_run_ending(Database& database, RunId run, std::optional<RunEnding> ending) {
  Transaction transaction(database);
  write_ending(database, run, ending);
  ending ? seal_run(database, run) : unseal_run(database, run);
  transaction.commit();
}

void end_runs(Database& database, const std::vector<RunId>& runs, RunEnding ending) {
  Transaction transaction(database);
  Sealer sealer(database);
  for (const RunId run : runs) {
    write_ending(database, run, ending);
    sealer.seal(run);
  }
  transaction.commit();
}

void end_run_unless_ended(Database& database, RunId run, RunEnding ending) {
  Transaction transaction(database);
  Statement ended(database, "SELECT ending IS NOT NULL FROM run WHERE number = ?");
  if (ended.with(run).step() && !ended.flag(0)) set_run_ending(database, run, ending);
  transaction.commit();
}

void ResultStore::record_plugins(const std::vector<PluginFileRecord>& files) {
  Transaction transaction(database_);
  Statement insert(database_, "INSERT OR REPLACE INTO plugin_file (run, file, sha256, build_id) VALUES (?, ?, ?, ?)");
  for (const PluginFileRecord& file : files) insert.run_with(run(), file.file, file.sha256, file.build_id);
  transaction.commit();
}

void ResultStore::record_robot_files(const std::vector<RobotFileRecord>& files) {
  Transaction transaction(database_);
  Statement insert(database_, "INSERT OR REPLACE INTO robot_file (run, file, sha256) VALUES (?, ?, ?)");
  for (const RobotFileRecord& file : files) insert.run_with(run(), file.file, file.sha256);
  transaction.commit();
}

ExperimentId ResultStore::record_experiment(const ExperimentRecord& record) {
  Transaction transaction(database_);
  std::optional<ExperimentId> experiment = find_experiment(record.name);
  if (!experiment) {
    experiment = ExperimentId{next_id("experiment")};
    Statement(database_, "INSERT INTO experiment (id, name) VALUES (?, ?)").run_with(*experiment, record.name);
  }
  const std::string overrides = sentences_text(record.overrides);
  const std::string decided = sentences_text(record.decided);
  const std::string digest = digest_of_text(record.file, record.text, overrides, decided);
  Statement(database_,
            "INSERT INTO experiment_text (id, experiment, digest, file, text, overrides, decided)"
            " VALUES (?, ?, ?, ?, ?, ?, ?)"
            " ON CONFLICT (experiment, digest) DO NOTHING")
      .run_with(next_id("experiment_text"), *experiment, digest, record.file, record.text, overrides, decided);
  Statement(database_,
            "UPDATE run SET experiment_text = (SELECT id FROM experiment_text WHERE experiment = ? AND digest = ?)"
            " WHERE number = ?")
      .run_with(*experiment, digest, run());
  transaction.commit();
  return *experiment;
}

std::optional<ExperimentId> ResultStore::find_experiment(const std::string& name) const {
  Statement row(database_, "SELECT id FROM experiment WHERE name = ?");
  if (!row.with(name).step()) return std::nullopt;
  return ExperimentId{row.integer(0)};
}

}  // namespace lacuna

#include "storage/results/stored_run.h"

#include "foundation/digest.h"
#include "foundation/text/problem.h"
#include "storage/core/clock.h"
#include "storage/core/json_text.h"
#include "storage/core/statement.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

constexpr const char* kUntil = " (until ";  ///< behind the file of an earlier build of a plugin

struct ExperimentRow {
  std::string name, file, text, overrides, digest, decided;
};

/// Of a statement whose first columns are these.
ExperimentRow experiment_row(Statement& row) {
  return {row.text(0), row.text(1), row.text(2), row.text(3), row.text(4), row.text(5)};
}

constexpr const char* kEdited =
    " differs from the text or file name that was stored when the run began (its digest does not match): the database "
    "was edited or is damaged; restore a backup";

/// Earlier versions of the program left out what they had decided, or the file's name, too.
bool has_earlier_digest(const ExperimentRow& row) {
  const std::string oldest = row.text + '\n' + row.overrides;
  return row.digest == sha256(oldest) || row.digest == sha256(oldest + '\n' + row.file);
}

bool is_as_stored(const ExperimentRow& row) {
  return row.digest == digest_of_text(row.file, row.text, row.overrides, row.decided) || has_earlier_digest(row);
}

}  // namespace

std::string digest_of_text(const std::string& file, const std::string& text, const std::string& overrides,
                           const std::string& decided) {
  return sha256(text + '\n' + overrides + '\n' + file + '\n' + decided);
}

void check_stored_texts(const Database& database) {
  ProblemList problems;
  Statement texts(database,
                  "SELECT experiment.name, file, text, overrides, digest, decided FROM experiment_text"
                  " JOIN experiment ON experiment.id = experiment_text.experiment ORDER BY experiment_text.id");
  while (texts.step()) {
    const ExperimentRow text = experiment_row(texts);
    if (!is_as_stored(text))
      problems.add({database.file().string()}, "a text of the experiment " + text.name + kEdited);
  }
  problems.throw_if_any();
}

std::vector<std::string> files_of_experiment(const Database& database, const std::string& experiment) {
  Statement row(database,
                "SELECT DISTINCT file FROM experiment_text"
                " JOIN experiment ON experiment.id = experiment_text.experiment WHERE experiment.name = ?"
                " ORDER BY file");
  row.with(experiment);
  std::vector<std::string> files;
  while (row.step()) files.push_back(row.text(0));
  return files;
}

void replace_plugin(Database& database, RunId run, const PluginFileRecord& before, const PluginFileRecord& now) {
  Transaction transaction(database);
  Statement(database, "UPDATE plugin_file SET file = ? WHERE run = ? AND file = ?")
      .run_with(before.file + kUntil + utc_now() + ")", run, before.file);
  Statement(database, "INSERT INTO plugin_file (run, file, sha256, build_id) VALUES (?, ?, ?, ?)")
      .run_with(run, now.file, now.sha256, now.build_id);
  transaction.commit();
}

StoredRun stored_run(const Database& database, RunId run) {
  Statement row(database,
                "SELECT experiment.name, file, text, overrides, digest, decided, seed, threads FROM run"
                " JOIN experiment_text ON experiment_text.id = run.experiment_text"
                " JOIN experiment ON experiment.id = experiment_text.experiment WHERE run.number = ?");
  if (!row.with(run).step())
    throw Error(database.file().string() + ": has no run " + std::to_string(run.value) + "; lacuna runs lists them");
  const ExperimentRow text = experiment_row(row);
  if (!is_as_stored(text))
    throw_problem({database.file().string()}, "the experiment of run " + std::to_string(run.value) + kEdited);
  StoredRun stored;
  stored.experiment = {text.name, text.file, text.text, sentences_from(text.overrides), sentences_from(text.decided)};
  stored.seed = static_cast<std::uint64_t>(row.integer(6));
  stored.threads = row.number(7);
  Statement plugin(database, "SELECT file, sha256, build_id FROM plugin_file WHERE run = ? ORDER BY file");
  plugin.with(run);
  while (plugin.step()) {
    const bool earlier = plugin.text(0).find(kUntil) != std::string::npos;
    (earlier ? stored.earlier_plugins : stored.plugins).push_back({plugin.text(0), plugin.text(1), plugin.text(2)});
  }
  Statement robot(database, "SELECT file, sha256 FROM robot_file WHERE run = ? ORDER BY file");
  robot.with(run);
  while (robot.step()) stored.robots.push_back({robot.text(0), robot.text(1)});
  return stored;
}

}  // namespace lacuna

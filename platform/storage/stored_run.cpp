#include "storage/stored_run.h"

#include "foundation/digest.h"
#include "foundation/problem.h"
#include "storage/json_text.h"
#include "storage/statement.h"

#include <lacuna/error.h>

namespace lacuna {
namespace {

constexpr const char* kEdited =
    " is not the text that was stored when the run began (its digest is another one): the file was edited or is "
    "damaged; restore a copy";

}  // namespace

std::string digest_of_text(const std::string& text, const std::string& overrides) {
  return sha256(text + '\n' + overrides);
}

void check_stored_texts(const Database& database) {
  ProblemList problems;
  Statement texts(database,
                  "SELECT experiment.name, text, overrides, digest FROM experiment_text"
                  " JOIN experiment ON experiment.id = experiment_text.experiment ORDER BY experiment_text.id");
  while (texts.step())
    if (digest_of_text(texts.text(1), texts.text(2)) != texts.text(3))
      problems.add({database.file().string()}, "a text of the experiment " + texts.text(0) + kEdited);
  problems.throw_if_any();
}

StoredRun stored_run(const Database& database, RunId run) {
  Statement row(database,
                "SELECT experiment.name, file, text, overrides, seed, threads, digest FROM run"
                " JOIN experiment_text ON experiment_text.id = run.experiment_text"
                " JOIN experiment ON experiment.id = experiment_text.experiment WHERE run.number = ?");
  if (!row.with(run).step())
    throw Error(database.file().string() + ": has no run " + std::to_string(run.value) + "; lacuna runs lists them");
  if (digest_of_text(row.text(2), row.text(3)) != row.text(6))
    throw_problem({database.file().string()}, "the experiment of run " + std::to_string(run.value) + kEdited);
  StoredRun stored;
  stored.experiment = {row.text(0), row.text(1), row.text(2), sentences_from(row.text(3))};
  stored.seed = static_cast<std::uint64_t>(row.integer(4));
  stored.threads = row.number(5);
  Statement plugin(database, "SELECT file, sha256, build_id FROM plugin_file WHERE run = ? ORDER BY file");
  plugin.with(run);
  while (plugin.step()) stored.plugins.push_back({plugin.text(0), plugin.text(1), plugin.text(2)});
  Statement robot(database, "SELECT file, sha256 FROM robot_file WHERE run = ? ORDER BY file");
  robot.with(run);
  while (robot.step()) stored.robots.push_back({robot.text(0), robot.text(1)});
  return stored;
}

}  // namespace lacuna

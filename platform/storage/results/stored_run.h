#pragma once

#include "storage/core/database.h"
#include "storage/core/records.h"

#include <string>
#include <vector>

namespace lacuna {

/// What is stored with the text of an experiment. `overrides`: as they stand in the database.
std::string digest_of_text(const std::string& file, const std::string& text, const std::string& overrides,
                           const std::string& decided);

/// The experiment files, as users named them, whose texts the database has of the experiment of that name.
std::vector<std::string> files_of_experiment(const Database& database, const std::string& experiment);

/// What a run was started from: enough to run it again.
struct StoredRun {
  ExperimentRecord experiment;
  std::uint64_t seed = 0;
  int threads = 1;
  std::vector<PluginFileRecord> plugins;  ///< by file; those that it used last
  /// Builds that it used before `replace_plugin`; behind each file stands until when.
  std::vector<PluginFileRecord> earlier_plugins;
  std::vector<RobotFileRecord> robots;  ///< by file; none where an older version began the run
};

/// Throws `BadInput` where the text of an experiment, or its file's name, is not the one whose digest was stored with
/// it, for commands that show the whole database.
void check_stored_texts(const Database& database);

/// An unfinished run continues with another build of a plugin; the earlier build stays recorded.
void replace_plugin(Database& database, RunId run, const PluginFileRecord& before, const PluginFileRecord& now);

/// Throws `Error` where the database has no such run, `BadInput` where the experiment's text is not the one whose
/// digest was stored with it. That shows accidents; who forges a text can forge its digest.
StoredRun stored_run(const Database& database, RunId run);

}  // namespace lacuna

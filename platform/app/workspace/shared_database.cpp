#include "app/workspace/shared_database.h"

#include "config/experiment_reader.h"
#include "storage/results/stored_run.h"

#include <fmt/format.h>

#include <system_error>

namespace lacuna {
namespace {

namespace fs = std::filesystem;

bool is_another_of_that_name(const fs::path& file, const Experiment& experiment) try {
  std::error_code missing;
  if (!fs::is_regular_file(file, missing) || fs::equivalent(file, experiment.file, missing) || missing) return false;
  return read_experiment(file, {}).name == experiment.name;
} catch (const Error&) {
  return false;  // it can write into no database
}

std::vector<std::string> files_in(const fs::path& database, const std::string& experiment, const Stop& stop) try {
  std::error_code missing;
  if (!fs::is_regular_file(database, missing)) return {};
  return files_of_experiment(Database::open_read_only(database, stop), experiment);
} catch (const Error&) {
  return {};  // whoever writes to it says why not
}

}  // namespace

std::optional<ReadingNote> shared_database_note(const Experiment& experiment, const fs::path& database,
                                                const Stop& stop) {
  for (const std::string& file : files_in(database, experiment.name, stop))
    if (is_another_of_that_name(file, experiment))
      return ReadingNote{experiment.where("experiment.name"),
                         fmt::format("{} is also called \"{}\" and writes into the same database, {}: its revisions "
                                     "and those of this file are counted as one experiment. Give this file another "
                                     "name under [experiment], or name another database with --db",
                                     file, experiment.name, database.string()),
                         true};
  return std::nullopt;
}

}  // namespace lacuna

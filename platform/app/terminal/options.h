#pragma once

#include "foundation/processes/interrupt.h"
#include "foundation/work.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace lacuna {

/// Options that mean the same in every command.
struct CommonOptions {
  std::filesystem::path experiment;    ///< the experiment file
  std::vector<std::string> overrides;  ///< --set key=value
  std::vector<std::string> decided;    ///< what the program decided where a stored experiment leaves it open
  std::vector<std::filesystem::path> plugin_paths;
  std::filesystem::path database;  ///< --db; empty: the experiment's name with .db in the working folder
  int threads = 0;                 ///< 0: all
  std::optional<std::uint64_t> seed;
  std::optional<std::string> json;  ///< --json[=FILE]; "" is standard output
  bool quiet = false;
  std::string task;  ///< of a plan, that the command carries out: its digest; empty: none
  /// --time-limit; null: none. Shared: copies of the options are of the same work.
  std::shared_ptr<TimeLimit> time_limit = {};
  Stop stop = when_interrupted();  ///< what ends the work early: an interrupt of this process, and the time limit

  /// The work of the command on its threads. It reports to `progress`.
  Work work(ProgressCallback progress = {}) const;
};

/// The settings, plugin folders and database of these options, to be typed behind another command; each with a space
/// before it.
std::string options_to_type(const CommonOptions& options);
/// "lacuna NAME EXPERIMENT" to be typed as it is, with the settings, plugin folders and database of these options.
std::string command_to_type(const std::string& name, const CommonOptions& options);

/// The command line, such that a shell takes it again; `run_program` sets it.
void set_command_line(int argc, char** argv);
const std::string& command_line();

/// Adds the experiment argument and the options of `add_model_options`.
void add_experiment_options(CLI::App& command, CommonOptions& options);
/// Adds --set, --plugin-path and --evaluation-limit.
void add_model_options(CLI::App& command, CommonOptions& options);
void add_plugin_path_option(CLI::App& command, CommonOptions& options);
/// Called for each database that a command names, before it is looked for: no output may take its place. Throws
/// `BadInput` for a name that leads nowhere.
void note_database(const std::filesystem::path& database);
/// Adds the argument DB, a database that the command reads: no output of it may take its place.
void add_database_argument(CLI::App& command, std::filesystem::path& database);
/// Throws `BadInput` for a file without content, which SQLite takes for a database without tables.
void refuse_empty(const std::filesystem::path& database);
void add_databases_argument(CLI::App& command, std::vector<std::filesystem::path>& databases);
/// Adds an option such as --json[=FILE]; without a file, "", which is standard output. The file stands behind an equals
/// sign, so that the option never takes the word after it.
void add_result_option(CLI::App& command, const std::string& name, std::optional<std::string>& file,
                       const std::string& description);
/// Adds --db, --threads, --seed, --json and --quiet.
void add_work_options(CLI::App& command, CommonOptions& options);

}  // namespace lacuna

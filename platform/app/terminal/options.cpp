#include "app/terminal/options.h"

#include "app/terminal/mistaken_file.h"
#include "app/terminal/output.h"
#include "app/terminal/time_limit.h"
#include "command_line/whole_number.h"
#include "foundation/files/allowed_files.h"
#include "foundation/parallel.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "foundation/files/whole_file.h"

#include <CLI/CLI.hpp>

#include <tuple>
#include <utility>

namespace lacuna {
namespace {

std::string typed_command;

constexpr std::uint64_t kMostThreads = 1024;

/// A misspelt folder would otherwise just be one without plugins.
CLI::Validator folder() {
  return CLI::Validator(
      [](const std::string& text) {
        std::error_code ignored;
        return std::filesystem::is_directory(text, ignored) ? std::string() : "there is no folder " + text;
      },
      "");
}

}  // namespace

void note_database(const std::filesystem::path& database) {
  if (database.empty()) throw_problem({}, "the name of the database is empty; name a file");
  check_may_read(database);
  std::error_code failure;
  std::ignore = std::filesystem::status(database, failure);
  if (failure == std::errc::too_many_symbolic_link_levels) throw_problem({database.string()}, kCircleOfLinks);
  if (failure == std::errc::filename_too_long)
    throw_problem({database.string()}, "cannot be opened: " + failure.message());
  refuse_outputs_among({database});
}

void set_command_line(int argc, char** argv) {
  typed_command = "lacuna";
  for (int i = 1; i < argc; ++i) typed_command += " " + shell_word(argv[i]);
}

const std::string& command_line() { return typed_command; }

void add_result_option(CLI::App& command, const std::string& name, std::optional<std::string>& file,
                       const std::string& description) {
  command.add_flag("--" + name + "{}", file, description)->option_text("[=FILE]");
}

void add_database_argument(CLI::App& command, std::filesystem::path& database) {
  command.add_option("database", database, "Database file")
      ->required()
      ->option_text("DB")
      ->each(refuse_experiment_as_database)
      ->each(note_database);
}

void refuse_empty(const std::filesystem::path& database) {
  std::error_code missing;
  if (std::filesystem::file_size(database, missing) == 0 && !missing)
    throw_problem({database.string()},
                  "is empty; make a database from an experiment file with `lacuna compare` or `lacuna run`");
}

void add_databases_argument(CLI::App& command, std::vector<std::filesystem::path>& databases) {
  command.add_option("databases", databases, "Database files")
      ->required()
      ->option_text("DB...")
      ->each(refuse_experiment_as_database)
      ->each(note_database);
}

void add_plugin_path_option(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--plugin-path", options.plugin_paths,
                  "Folder with plugins, searched before all others; may be repeated")
      ->allow_extra_args(false)
      ->option_text("FOLDER")
      ->check(folder());
}

void add_experiment_options(CLI::App& command, CommonOptions& options) {
  command.add_option("experiment", options.experiment, "Experiment file (TOML)")
      ->required()
      ->option_text("FILE")
      ->each(refuse_database_as_experiment);
  add_model_options(command, options);
}

void add_model_options(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--set", options.overrides, "Override a key of the file: --set engine.step=0.0005; may be repeated")
      ->allow_extra_args(false)
      ->option_text("KEY=VALUE");
  add_plugin_path_option(command, options);
  add_evaluation_limit_option(command);
}

void add_work_options(CLI::App& command, CommonOptions& options) {
  command
      .add_option("--db", options.database,
                  "Database file (default: the experiment's name with .db, in the current folder)")
      ->option_text("FILE")
      ->each(note_database);
  command.add_option("--threads", options.threads, "Threads (default: one per processor)")
      ->option_text("N")
      ->check(whole_number(1, kMostThreads));
  command.add_option("--seed", options.seed, "Seed (default: the file's)")->option_text("N")->check(whole_number(0));
  add_result_option(command, "json", options.json, "Write results as JSON to FILE (default: standard output)");
  command.add_flag("--quiet", options.quiet, "Print results only");
}

Work CommonOptions::work(ProgressCallback progress) const {
  return {threads > 0 ? threads : default_threads(), stop, std::move(progress)};
}

std::string options_to_type(const CommonOptions& options) {
  std::string typed;
  for (const std::string& one : options.overrides) typed += " --set " + shell_word(one);
  for (const std::filesystem::path& folder : options.plugin_paths)
    typed += " --plugin-path " + shell_word(folder.string());
  if (!options.database.empty()) typed += " --db " + shell_word(options.database.string());
  return typed;
}

std::string command_to_type(const std::string& name, const CommonOptions& options) {
  return "lacuna " + name + " " + shell_word(options.experiment.string()) + options_to_type(options);
}

}  // namespace lacuna

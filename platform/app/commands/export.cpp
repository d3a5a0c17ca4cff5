#include "app/commands/commands.h"
#include "app/terminal/mistaken_file.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/exported_robot.h"
#include "app/workspace/exported_rows.h"
#include "command_line/whole_number.h"
#include "foundation/text/problem.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace lacuna {
namespace {

constexpr const char* kOfExperiments = "With an experiment file, the identified robot";
constexpr const char* kOfDatabases = "With a database, its rows";

/// `experiment` is the experiment file or the database.
struct ExportOptions : CommonOptions {
  std::string what, out;
  std::optional<std::string> urdf, mjcf, toml, csv, npz, mcap;
  std::optional<int> revision;
  bool force = false;

  Existing existing() const { return force ? Existing::replaced : Existing::refused; }
};

/// Throws `BadInput` for the first option of a group that was given.
void refuse_group(const CLI::App& command, const char* group, const std::string& why) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_group() == group && option->count() > 0) throw_problem({}, option->get_name() + " " + why);
}

void export_robot_files(const ExportOptions& options) {
  refuse_database_as_experiment(options.experiment.string());
  RobotExport wanted{{}, options.revision, options.existing()};
  if (options.urdf) wanted.files.push_back({"urdf", *options.urdf});
  if (options.mjcf) wanted.files.push_back({"mjcf", *options.mjcf});
  if (options.toml) wanted.files.push_back({"toml", *options.toml});
  if (wanted.files.empty())
    throw_problem({},
                  "say what to write: --toml robot.toml, --urdf robot.urdf or --mjcf robot.xml; from a database, a "
                  "view or a trial: lacuna export DATABASE VIEW --csv");
  export_robots(options, wanted);
}

/// The formats that were asked for, each with its file, which is empty for standard output.
std::vector<std::pair<RowFormat, std::string>> asked_formats(const ExportOptions& options) {
  std::vector<std::pair<RowFormat, std::string>> asked;
  if (options.csv) asked.emplace_back(RowFormat::csv, *options.csv);
  if (options.json) asked.emplace_back(RowFormat::json, *options.json);
  if (options.npz) asked.emplace_back(RowFormat::npz, *options.npz);
  if (options.mcap) asked.emplace_back(RowFormat::mcap, *options.mcap);
  return asked;
}

/// The ending of a file chooses the format where no option does, and between an array and lines of JSON.
void choose_format(const ExportOptions& options, RowsExport& wanted) {
  const auto asked = asked_formats(options);
  if (asked.size() > 1) throw_problem({}, "give only one of --csv, --json, --npz and --mcap");
  if (!asked.empty() && !asked.front().second.empty() && !options.out.empty())
    throw_problem({options.out}, fmt::format("is a second output file beside {}; name only one", asked.front().second));
  wanted.to = !asked.empty() && !asked.front().second.empty() ? asked.front().second : options.out;
  const std::optional<RowFormat> by_ending = row_format_of(wanted.to);
  if (asked.empty() && !by_ending)
    throw_problem({}, "say which format: --csv, --json, --npz or --mcap, or name a file with such an ending: rows.csv");
  wanted.format = asked.empty() ? *by_ending : asked.front().first;
  if (wanted.format == RowFormat::json && by_ending == RowFormat::json_lines) wanted.format = RowFormat::json_lines;
}

void export_of_database(const ExportOptions& options) {
  refuse_experiment_as_database(options.experiment.string());
  RowsExport wanted;
  wanted.database = options.experiment;
  wanted.what = options.what;
  wanted.revision = options.revision;
  wanted.existing = options.existing();
  wanted.quiet = options.quiet;
  wanted.stop = options.stop;
  if (!options.what.empty()) choose_format(options, wanted);
  export_rows(wanted);
}

void run_export(const CLI::App& command, const ExportOptions& options) {
  const bool rows = !options.what.empty() || options.csv || options.npz || options.mcap;
  if (options.urdf || options.mjcf || options.toml || (!rows && !is_database(options.experiment))) {
    refuse_group(command, kOfDatabases, "is for a database; a robot is written with --urdf, --mjcf or --toml");
    return export_robot_files(options);
  }
  refuse_group(command, kOfExperiments, "is for an experiment file; leave it out to export rows of a database");
  export_of_database(options);
}

void add_robot_options(CLI::App& command, ExportOptions& options) {
  command.add_option("--urdf", options.urdf, "URDF file to write")->option_text("FILE");
  command.add_option("--mjcf", options.mjcf, "MJCF file to write")->option_text("FILE");
  command.add_option("--toml", options.toml, "Robot file to write (TOML)")->option_text("FILE");
  add_model_options(command, options);
  add_work_options(command, options);
  for (const char* name :
       {"--urdf", "--mjcf", "--toml", "--set", "--plugin-path", "--evaluation-limit", "--db", "--threads", "--seed"})
    command.get_option(name)->group(kOfExperiments);
}

void add_row_options(CLI::App& command, ExportOptions& options) {
  command
      .add_option("what", options.what,
                  "With a database: name of a view or table (lacuna sql --views), or of a trial, such as chirp.csv "
                  "(readings and "
                  "prediction side by side)")
      ->option_text("WHAT");
  command
      .add_option("out", options.out,
                  "With a database: file to write; its ending selects the format unless an option does (default: "
                  "standard output)")
      ->option_text("OUT");
  add_result_option(command, "csv", options.csv, "Write as CSV to FILE (default: standard output)");
  add_result_option(command, "npz", options.npz, "As NumPy arrays, one per column");
  add_result_option(command, "mcap", options.mcap, "A trial as MCAP, one topic per channel");
  for (const char* name : {"what", "out", "--csv", "--npz", "--mcap"}) command.get_option(name)->group(kOfDatabases);
}

}  // namespace

void add_export_command(CLI::App& program) {
  auto options = std::make_shared<ExportOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand(
      "export", "Export the identified robot (TOML, URDF, MJCF), or rows of a database for other programs");
  command->add_option("source", options->experiment, "Experiment file (TOML) or database")
      ->required()
      ->option_text("FILE");
  add_robot_options(*command, *options);
  add_row_options(*command, *options);
  command
      ->add_option("--revision", options->revision,
                   "Revision whose robot or prediction is written (default: the current robot, the newest prediction)")
      ->option_text("N");
  command->add_flag("--force", options->force, "Replace existing files");
  command->callback([command, options] { run_export(*command, *options); });
}

}  // namespace lacuna

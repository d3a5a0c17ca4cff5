#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "foundation/processes/interrupt.h"
#include "report/text/run_text.h"
#include "storage/files/log_left.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace lacuna {
namespace {

struct RunsOptions {
  std::filesystem::path database;
  std::optional<std::string> json;
};

void list_runs(const RunsOptions& options) {
  check_output(options.json);
  const LogLeft log(options.database);
  const Database database = Database::open_read_only(options.database, when_interrupted());
  const std::vector<EeaRunListing> runs = eea_runs(database);
  if (!takes_standard_output(options.json)) std::fputs(runs_text(runs).c_str(), stdout);
  if (options.json) write_output(*options.json, runs_json(runs).dump(2) + "\n");
}

}  // namespace

void add_runs_command(CLI::App& program) {
  auto options = std::make_shared<RunsOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("runs", "List the runs of a database");
  add_database_argument(*command, options->database);
  add_result_option(*command, "json", options->json, "Write results as JSON to FILE (default: standard output)");
  command->callback([options] { list_runs(*options); });
}

}  // namespace lacuna

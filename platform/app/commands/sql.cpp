#include "app/commands/commands.h"
#include "app/terminal/mistaken_file.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/terminal/plain_streams.h"
#include "foundation/processes/interrupt.h"
#include "foundation/files/whole_file.h"
#include "storage/files/log_left.h"
#include "storage/queries/query.h"
#include "storage/queries/query_output.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace lacuna {
namespace {

struct SqlOptions {
  std::filesystem::path database;
  std::string sql;
  bool views = false;
  bool csv = false;
  std::optional<std::string> json;
};

void print_views() {
  for (const ViewDescription& view : view_descriptions()) {
    std::printf("%s\n  %s\n  %s\n", view.name.c_str(), view.sentence.c_str(), view.example.c_str());
  }
}

void query(const SqlOptions& options) {
  check_output(options.json);
  note_database(options.database);
  const LogLeft log(options.database);
  const Database database = Database::open_read_only(options.database, when_interrupted());
  const bool to_file = options.json && !options.json->empty();
  const QueryFormat format = options.json ? QueryFormat::json : options.csv ? QueryFormat::csv : QueryFormat::table;
  const auto write_to = [&](std::ostream& stream) {
    run_queries(database, options.sql, *make_query_output(format, stream));
  };
  if (!to_file) return write_to(format == QueryFormat::table ? std::cout : exact_output());
  WholeFile file(*options.json, Link::followed, when_interrupted());
  write_to(file.stream());
  file.publish();
}

}  // namespace

void add_sql_command(CLI::App& program) {
  auto options = std::make_shared<SqlOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("sql", "Query a database, read-only");
  command->add_option("database", options->database, "Database file; not needed for --views")
      ->option_text("FILE")
      ->each(refuse_experiment_as_database);
  command->add_option("sql", options->sql, "One or more statements; try \"SELECT * FROM error_by_revision\"")
      ->option_text("STATEMENT");
  command->add_flag("--views", options->views, "List the views, each with an example");
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Write results as CSV (not with --json)");
  add_result_option(*command, "json", options->json, "Write results as JSON to FILE (default: standard output)");
  command->get_option("--json")->excludes(csv);
  command->callback([options] {
    if (options->views) return print_views();
    if (options->database.empty()) throw CLI::RequiredError("database");
    if (options->sql.empty()) throw CLI::RequiredError("a statement in quotes, or --views to list the views,");
    query(*options);
  });
}

}  // namespace lacuna

#include "app/commands/commands.h"
#include "app/terminal/options.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "storage/eea/eea_store.h"
#include "storage/files/log_left.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

namespace lacuna {
namespace {

struct HashOptions {
  std::filesystem::path database;
  std::optional<std::int64_t> run;
};

void print_hashes(const HashOptions& options) {
  const LogLeft log(options.database);
  const Database database = Database::open_read_only(options.database, when_interrupted());
  std::vector<EeaRunListing> runs = eea_runs(database);
  if (options.run) std::erase_if(runs, [&](const EeaRunListing& run) { return run.run.value != *options.run; });
  if (runs.empty())
    throw_problem({options.database.string()}, options.run
                                                   ? fmt::format("has no run {}; lacuna runs lists them", *options.run)
                                                   : std::string("has no run of the algorithm"));
  for (const EeaRunListing& run : runs)
    fmt::print("{}  run {} {} replicate {}\n", content_hash(database, run.run), run.run.value,
               plain_text(run.experiment), run.replicate);
}

}  // namespace

void add_hash_command(CLI::App& program) {
  auto options = std::make_shared<HashOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("hash", "Print a hash of each run's content; runs with equal results have equal hashes");
  add_database_argument(*command, options->database);
  command->add_option("--run", options->run, "This run only")->option_text("N");
  command->callback([options] { print_hashes(*options); });
}

}  // namespace lacuna

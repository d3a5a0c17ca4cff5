#include "app/commands/commands.h"
#include "app/runs/replicates.h"
#include "app/runs/open_stored_run.h"
#include "app/terminal/options.h"
#include "app/terminal/scratch_folder.h"
#include "command_line/whole_number.h"
#include "foundation/processes/interrupt.h"
#include "foundation/parallel.h"
#include "storage/files/log_left.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <mutex>
#include <utility>

namespace lacuna {
namespace {

struct ReproduceOptions {
  std::filesystem::path database;
  std::optional<std::int64_t> run;
  int threads = 0;
  bool quiet = false;
  bool trust = false;
  std::vector<std::filesystem::path> plugin_paths;
};

/// Values that are not known are equal.
bool same_values(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

bool differ(const PassRow& a, const PassRow& b) {
  return a.best_model != b.best_model || a.best_score != b.best_score || a.best_test != b.best_test ||
         a.best_fitness != b.best_fitness || a.steps != b.steps || !same_values(a.best_values, b.best_values);
}

/// Where the two begin to differ, as far as the passes tell.
std::string first_difference(const std::vector<PassRow>& stored, const std::vector<PassRow>& again) {
  for (std::size_t i = 0; i < std::min(stored.size(), again.size()); ++i)
    if (differ(stored[i], again[i])) return fmt::format("the passes differ from pass {} on", stored[i].number);
  return "all passes agree, but other rows differ";
}

/// Shows the program that will be started; throws where the user has not said that it may be.
void check_program(const ReproduceOptions& options, const OpenStoredRun& stored) {
  const std::string line = program_line(stored.opened->opened().experiment);
  if (line.empty()) return;
  if (options.trust) return fmt::print(stderr, "starting the program that the database names: {}\n", line);
  throw_problem({options.database.string()},
                fmt::format("the target of run {} is a program that only the database names: {} - it was not started, "
                            "because anybody who can write the file can put a command there (a digest shows accidents, "
                            "not forgery). If you trust this program: {} --trust",
                            stored.listing.run.value, line, command_line()));
}

EeaRunListing run_to_repeat(const Database& database, const ReproduceOptions& options) {
  EeaRunListing listing = choose_run(database, options.run);
  if (listing.ending != "done")
    throw_problem({options.database.string()},
                  fmt::format("run {} is not done ({}); only a finished run can be reproduced", listing.run.value,
                              listing.ending));
  return listing;
}

/// A run that was carried out again, in a database of its own.
struct Repetition {
  RunId run;
  ReplicateEnd end;
};

Repetition repeat(const OpenStoredRun& stored, const EeaRunListing& listing, Database& again,
                  const ReproduceOptions& options) {
  ResultStore store(again);
  const int threads = options.threads > 0 ? options.threads : default_threads();
  const RunId run = store.begin_run({command_line(), stored.run.seed, threads}, provenance_of_this_program());
  const ExperimentId experiment = store.record_experiment(stored.run.experiment);
  store.hand_over();
  const std::vector<PlannedReplicate> planned = {{run, listing.replicate, stored.run.seed}};
  Replicates replicates(*stored.opened, again, experiment);
  replicates.enter(planned);
  RunDisplay display(planned, options.quiet, nullptr);
  return {run, std::move(replicates.run(planned, threads, display).front())};
}

void check_ended(const ReplicateEnd& end, const EeaRunListing& listing) {
  if (end.ending == RunEnding::interrupted)
    throw Interrupted("interrupted; run " + std::to_string(listing.run.value) +
                      " is unchanged, and its repetition is discarded");
  if (end.ending == RunEnding::failed) throw Error(end.problem);
}

void reproduce(const ReproduceOptions& options) {
  const LogLeft log(options.database);
  Database database = Database::open_read_only(options.database, when_interrupted());
  const EeaRunListing listing = run_to_repeat(database, options);
  const OpenStoredRun stored = open_stored(database, listing, options.plugin_paths,
                                           options.trust ? StoredProgram::trusted : StoredProgram::refused);
  check_program(options, stored);
  for (const std::string& doubt : stored.doubts) std::fprintf(stderr, "%s\n", doubt.c_str());

  const ScratchFolder scratch;
  Database again = Database::open(scratch / "again.db", when_interrupted());
  const Repetition repetition = repeat(stored, listing, again, options);
  check_ended(repetition.end, listing);
  const std::string was = content_hash(database, listing.run), is = content_hash(again, repetition.run);
  fmt::print("stored      {}\nreproduced  {}\n", was, is);
  if (was == is) {
    fmt::print("run {} is reproduced: every row is the same\n", listing.run.value);
    return;
  }
  std::mutex unused;
  const std::vector<PassRow> passes = EeaStore(database, unused, listing.run, {}).passes();
  throw Error(
      fmt::format("run {} is not reproduced: {}", listing.run.value, first_difference(passes, repetition.end.passes)));
}

}  // namespace

void add_reproduce_command(CLI::App& program) {
  auto options = std::make_shared<ReproduceOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command =
      program.add_subcommand("reproduce", "Repeat a stored run and compare every row with the stored one");
  add_database_argument(*command, options->database);
  command->add_option("--run", options->run, "Run (required if there are several)")->option_text("N");
  command->add_option("--threads", options->threads, "Threads (default: one per processor)")
      ->option_text("N")
      ->check(whole_number(1, 1024));
  command->add_flag("--trust", options->trust,
                    "Allow Lacuna to start the program that the database names as the target; without it, such a run "
                    "is not repeated. Use it only if you trust the database");
  command->add_flag("--quiet", options->quiet, "Print results only");
  command->add_option("--plugin-path", options->plugin_paths, "Folder with plugins, searched before all others")
      ->allow_extra_args(false)
      ->option_text("FOLDER");
  command->callback([options] { reproduce(*options); });
}

}  // namespace lacuna

#include "app/commands.h"
#include "app/output.h"
#include "app/stored_bench.h"
#include "report/run_pictures.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <set>

namespace lacuna {
namespace {

struct PlotOptions {
  std::filesystem::path database;
  std::optional<std::int64_t> run;
  std::filesystem::path folder;
};

/// The run that was asked for, or all runs of the one experiment.
std::vector<EeaRunListing> runs_to_draw(const Database& database, const PlotOptions& options) {
  if (options.run) return {choose_run(database, options.run)};
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::erase_if(runs, [](const EeaRunListing& run) { return run.passes_done == 0; });
  const SourceLocation file{options.database.string()};
  if (runs.empty()) throw_problem(file, "has no run with a pass that has ended; lacuna run FILE makes one");
  std::set<std::string> experiments;
  for (const EeaRunListing& run : runs) experiments.insert(run.experiment);
  if (experiments.size() > 1)
    throw_problem(file, "has runs of several experiments; choose one with --run, lacuna runs lists them");
  return runs;
}

void plot(const PlotOptions& options) {
  Database database = Database::open_read_only(options.database);
  const std::vector<EeaRunListing> listings = runs_to_draw(database, options);
  make_output_folder(options.folder);
  std::mutex unused;
  std::vector<DrawnRun> runs;
  for (const EeaRunListing& listing : listings) runs.push_back(drawn_run(EeaStore(database, unused, listing.run, {})));
  const std::string title = listings.size() == 1
                                ? fmt::format("{}, run {}", listings.front().experiment, listings.front().run.value)
                                : fmt::format("{}, {} runs", listings.front().experiment, listings.size());
  for (const NamedFigure& named : run_figures(runs, title)) {
    const std::filesystem::path file = options.folder / (named.name + ".svg");
    write_svg(named.figure, file);
    fmt::print("{}\n", file.string());
  }
}

}  // namespace

void add_plot_command(CLI::App& program) {
  auto options = std::make_shared<PlotOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("plot", "Draw the runs of a database as SVG pictures");
  command->add_option("database", options->database, "Database file")->required()->option_text("DB");
  command->add_option("--run", options->run, "This run only (default: all of them together)")->option_text("N");
  command->add_option("--out", options->folder, "Folder for the pictures (default: this one)")->option_text("FOLDER");
  command->callback([options] { plot(*options); });
}

}  // namespace lacuna

#include "app/commands/commands.h"
#include "app/runs/open_stored_run.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "app/workspace/newest_setting.h"
#include "foundation/processes/interrupt.h"
#include "report/figures/file_name.h"
#include "report/figures/run_pictures.h"
#include "storage/files/log_left.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <mutex>

namespace lacuna {
namespace {

struct PlotOptions {
  std::filesystem::path database;
  std::optional<std::int64_t> run;
  std::filesystem::path folder;
};

std::string numbers(const std::vector<EeaRunListing>& runs) {
  std::vector<std::int64_t> numbers;
  for (const EeaRunListing& run : runs) numbers.push_back(run.run.value);
  return fmt::format("{} {}", numbers.size() == 1 ? "run" : "runs", fmt::join(numbers, ", "));
}

/// The run that was asked for, or the newest ones.
std::vector<EeaRunListing> runs_to_draw(const Database& database, const PlotOptions& options) {
  if (options.run) return {choose_run(database, options.run)};
  std::vector<EeaRunListing> runs = eea_runs(database);
  std::erase_if(runs, [](const EeaRunListing& run) { return run.passes_done == 0; });
  if (runs.empty())
    throw_problem({options.database.string()}, "has no run with a finished pass; make one: lacuna run FILE");
  std::vector<EeaRunListing> drawn = newest_setting(database, runs);
  if (drawn.size() < runs.size())
    fmt::print(stderr, "draws {} of {}; the other runs are not replicates of it; to draw one of them: --run N\n",
               numbers(drawn), drawn.front().experiment);
  return drawn;
}

void plot(const PlotOptions& options) {
  const LogLeft log(options.database);
  Database database = Database::open_read_only(options.database, when_interrupted());
  const std::vector<EeaRunListing> listings = runs_to_draw(database, options);
  make_output_folder(options.folder);
  std::mutex unused;
  std::vector<DrawnRun> runs;
  for (const EeaRunListing& listing : listings) runs.push_back(drawn_run(EeaStore(database, unused, listing.run, {})));
  const std::string title =
      fmt::format("{}, {}", listings.front().experiment,
                  listings.size() > 4 ? fmt::format("{} runs", listings.size()) : numbers(listings));
  FileNames names;
  for (const NamedFigure& named : run_figures(runs, title)) {
    const std::filesystem::path file = file_for_picture(options.folder, names.next(named.name + ".svg"));
    write_svg(named.figure, file, when_interrupted());
    fmt::print("{}\n", file.string());
  }
}

}  // namespace

void add_plot_command(CLI::App& program) {
  auto options = std::make_shared<PlotOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("plot", "Draw the runs of a database as SVG pictures");
  add_database_argument(*command, options->database);
  command->add_option("--run", options->run, "This run only (default: the newest with its replicates)")
      ->option_text("N");
  command->add_option("--out", options->folder, "Folder for the pictures (default: the current folder)")
      ->option_text("FOLDER");
  command->callback([options] { plot(*options); });
}

}  // namespace lacuna

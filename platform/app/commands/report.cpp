#include "app/commands/commands.h"
#include "app/runs/replays.h"
#include "app/terminal/options.h"
#include "app/terminal/output.h"
#include "foundation/processes/interrupt.h"
#include "foundation/text/plain_text.h"
#include "foundation/text/problem.h"
#include "foundation/text/shell_word.h"
#include "report/pages/pages.h"
#include "storage/files/log_left.h"
#include "storage/pages/page_database.h"
#include "storage/results/stored_run.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <memory>

namespace lacuna {
namespace {

struct ReportOptions {
  std::filesystem::path database;
  std::string out;
  double megabytes = 50.0;
  bool no_robots = false;
  bool quiet = false;
  std::vector<std::filesystem::path> plugin_paths;
};

constexpr double kMegabyte = 1e6;
constexpr std::size_t kReplayBytes = 12'000'000;

/// Megabytes of a page are nothing to be read there.
void refuse_terminal(const ReportOptions& options) {
  if (!options.out.empty() || isatty(STDOUT_FILENO) == 0) return;
  const std::string page = shell_word(options.database.stem().string() + ".html");
  throw_problem({}, "standard output is a terminal, and the page is HTML for a browser; name a file: " +
                        command_line() + " --out " + page);
}

void make_report(const ReportOptions& options) {
  require_pages();
  refuse_terminal(options);
  check_output(options.out);
  refuse_empty(options.database);
  const LogLeft log(options.database);
  const Database database = Database::open_read_only(options.database, when_interrupted());
  check_stored_texts(database);
  PageDatabase pages;
  pages.copy(database, static_cast<std::size_t>(options.megabytes * kMegabyte));
  pages.add_about("database", options.database.filename().string());
  pages.add_about("lacuna", LACUNA_VERSION);
  if (!options.no_robots)
    Replays(options.database, options.plugin_paths, pages, when_interrupted()).prepare_for_report(kReplayBytes);
  const std::string page = report_page(pages.bytes());
  write_output(options.out, page);
  if (!options.quiet && !options.out.empty())
    fmt::print("{}: {:.1f} MB; open it in a browser, no network needed\n", plain_text(options.out),
               static_cast<double>(page.size()) / kMegabyte);
}

}  // namespace

void add_report_command(CLI::App& program) {
  auto options = std::make_shared<ReportOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("report", "Write a database as one HTML file for any browser");
  add_database_argument(*command, options->database);
  command->add_option("--out", options->out, "HTML file to write (required on a terminal; default: standard output)")
      ->option_text("FILE");
  command
      ->add_option("--most-megabytes", options->megabytes,
                   "Maximum size of the HTML file (default: 50); of a larger database it shows a selection, "
                   "which it describes")
      ->option_text("MB")
      ->check(CLI::Range(1.0, 2000.0));
  command->add_flag("--no-robots", options->no_robots, "Leave the page Replay without simulated robots");
  command->add_option("--plugin-path", options->plugin_paths, "Folder with plugins, searched before all others")
      ->allow_extra_args(false)
      ->option_text("FOLDER");
  command->add_flag("--quiet", options->quiet, "Print nothing");
  command->callback([options] { make_report(*options); });
}

}  // namespace lacuna

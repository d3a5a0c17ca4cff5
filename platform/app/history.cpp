#include "app/commands.h"
#include "app/options.h"
#include "app/output.h"
#include "app/workbench.h"
#include "report/history_text.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace lacuna {
namespace {

struct HistoryOptions : CommonOptions {
  std::optional<std::string> csv;
  std::filesystem::path out;
};

void run_history(const HistoryOptions& options) {
  check_output(options.json, options.csv);
  make_output_folder(options.out);
  Workbench bench(options);
  const bool compared =
      bench.ledger()
          .store()
          .latest_comparison(bench.revision().id, ComparisonKind::refitted, bench.rig().count(true) > 0)
          .has_value();
  if (!compared) bench.compare_model(bench.fit_model().result, true, true);

  const std::vector<HistoryRow> rows = bench.ledger().store().history(bench.ledger().experiment());
  const int looks = bench.ledger().store().holdout_looks(bench.ledger().experiment());
  if (!takes_standard_output(options.json) && !takes_standard_output(options.csv))
    fmt::print("{} · {}\n{}", bench.rig().experiment.name, bench.ledger().file().string(), history_text(rows, looks));
  if (options.json) write_output(*options.json, history_json(rows, looks));
  if (options.csv) write_output(*options.csv, history_csv(rows));
  if (!options.out.empty()) draw_history(rows, bench.rig().experiment.name + " · error by revision", options.out);
  bench.ledger().done();
}

}  // namespace

void add_history_command(CLI::App& program) {
  auto options = std::make_shared<HistoryOptions>();  // shared: CLI11 keeps the callback, which must own the options
  CLI::App* command = program.add_subcommand("history", "Error by revision of the model");
  add_experiment_options(*command, *options);
  add_work_options(*command, *options);
  add_result_option(*command, "csv", options->csv, "The table as CSV, to standard output or FILE");
  command->add_option("--out", options->out, "Folder for the picture (SVG)")->option_text("FOLDER");
  command->callback([options] { run_history(*options); });
}

}  // namespace lacuna
